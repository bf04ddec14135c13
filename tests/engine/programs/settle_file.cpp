// Settles a model from a file and writes the solution to standard output.
//   settle_file MODEL
// Both are texts of arrays (base/text_source.hpp). The file has `model`, with the fields of Model,
// and `start`, the initial positions of the nodes (m, 3 per node). Exit status: 0 settled, 1
// unreadable or wrong file, 2 no equilibrium found.
#include <cstdio>
#include <exception>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "codend.hpp"

namespace {

struct File {
  codend::Model model;
  std::vector<double> start;

  template <class Visit>
  void fields(Visit& visit) {
    visit.group("model", model);
    visit("start", start, {3, codend::Among::numbers, codend::Per::node});
  }
};

std::string text_of(const char* path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw codend::InputError("", std::string(path) + " cannot be opened");
  return std::string(std::istreambuf_iterator<char>(file), {});
}

void write(const char* name, const std::vector<double>& values) {
  std::printf("%s number %zu\n", name, values.size());
  for (const double value : values) std::printf("%.17g\n", value);
}

int settle_file(const char* path) {
  File file = codend::read_fields<File>(codend::TextSource(text_of(path)));
  file.model.prepare();
  codend::Assembly assembly(file.model);
  std::vector<double> x = file.start;
  const std::vector<double> at_rest(x.size(), 0.0);
  const codend::SettleReport report =
      codend::settle(assembly, codend::SettleControl{}, at_rest.data(), x.data());
  std::printf("converged mark 1 %d\niterations whole 1 %d\n", report.converged, report.iterations);
  write("residual", {report.residual});
  write("position", x);
  return report.converged ? 0 : 2;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::fprintf(stderr, "settle_file takes the path of one file\n");
    return 1;
  }
  try {
    return settle_file(arguments[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
