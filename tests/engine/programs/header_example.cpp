// Runs the example in the header of codend.hpp (`make` copies it) on a file of a gear's numbers.
// Prints the displacement (m) of the settled gear during the time integration.
//   header_example FILE
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

#include "codend.hpp"

int main(int count, char** arguments) {
  if (count != 2) return 1;
  std::ifstream file(arguments[1], std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(file), {});
#include "header_example.inc"
  std::printf("%g\n", (integration.now().x - start.x).cwiseAbs().maxCoeff());
  return integration.now().time == 10 ? 0 : 2;
}
