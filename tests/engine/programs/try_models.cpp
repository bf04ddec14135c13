// Damages texts of random models, reads them and uses the accepted ones (../mutated_models.hpp).
//
//   try_models COUNT SEED
//
// Exit status: 0 if all were rejected or harmless; else the status of the first failure.
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "../mutated_models.hpp"

int main(int count, char** arguments) {
  if (count != 3) {
    std::fprintf(stderr, "try_models takes how many models are tried, and a seed\n");
    return 1;
  }
  const std::uint64_t seed = std::strtoull(arguments[2], nullptr, 10);
  codend::Tried all;
  for (int k = 0; k < std::atoi(arguments[1]); ++k) {
    const std::uint64_t number = seed + static_cast<std::uint64_t>(k);
    try {
      const codend::Tried one = codend::try_damaged_models(number, 1);
      all.taken += one.taken;
      all.refused += one.refused;
    } catch (const std::exception& error) {
      std::fprintf(stderr, "model %llu: %s\n", static_cast<unsigned long long>(number),
                   error.what());
      return 1;
    }
  }
  std::printf("%d models taken, %d refused\n", all.taken, all.refused);
}
