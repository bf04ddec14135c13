// Settles a gear from a file of its numbers. Writes its measures and their errors to standard
// output.
//   settle_gear FILE NODES
// Both are texts of arrays (base/text_source.hpp). The file has the fields of GearNumbers
// (measure/settled_gear.hpp). Exit status: 0 settled, 1 unreadable or wrong file, 2 no equilibrium
// found.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "codend.hpp"

namespace {

void write(const char* name, const std::vector<double>& values) {
  std::printf("%s number %zu", name, values.size());
  for (const double value : values) std::printf(" %.17g", value);
  std::printf("\n");
}

}  // namespace

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
    std::printf("converged mark 1 %d\n", found.report.converged);
    write("measures", found.measures);
    if (found.report.converged) write("errors", codend::errors_of(numbers, how, found));
    return found.report.converged ? 0 : 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
