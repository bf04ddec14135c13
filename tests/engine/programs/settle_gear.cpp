// Settles a gear from a file of its numbers and writes its measures to standard output.
//   settle_gear FILE NODES
// The file and what is written are texts of arrays (base/text_source.hpp), the file's with the fields of
// GearNumbers (measure/settled_gear.hpp).
// Exit status: 0 settled, 1 the file cannot be read or is wrong, 2 no equilibrium was found.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iterator>
#include <string>

#include "codend.hpp"

int main(int count, char** arguments) {
  if (count != 3) {
    std::fprintf(stderr, "settle_gear takes the path of a file and a number of nodes\n");
    return 1;
  }
  try {
    std::ifstream file(arguments[1], std::ios::binary);
    if (!file) throw codend::InputError("", std::string(arguments[1]) + " cannot be opened");
    const std::string text(std::istreambuf_iterator<char>(file), {});
    const auto numbers = codend::read_fields<codend::GearNumbers>(codend::TextSource(text));
    codend::GearSettling how;
    how.nodes = std::atof(arguments[2]);
    const codend::SettledGear found = codend::settle_gear(numbers, how);
    std::printf("converged mark 1 %d\nmeasures number %zu\n", found.report.converged,
                found.measures.size());
    for (const double value : found.measures) std::printf("%.17g\n", value);
    return found.report.converged ? 0 : 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
