// Runs the example at the head of codend.hpp, which `make` takes from there, on a file of a gear's numbers,
// and writes how far (m) the settled gear moved as it was marched.
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
  std::printf("%g\n", (march.now().x - start.x).cwiseAbs().maxCoeff());
  return march.now().time == 10 ? 0 : 2;
}
