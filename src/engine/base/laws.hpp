// Laws by name and the ranges that they are used in, made by `make schema` from
// inst/schema/laws.csv: do not edit by hand.
#pragma once

// clang-format off
#include <array>
#include <cstddef>
#include <limits>

namespace codend {

// Solidities and Reynolds numbers beyond these are taken as the ends.
struct LawRange {
  double least_solidity, most_solidity, least_reynolds, most_reynolds;
};
constexpr double unbounded = std::numeric_limits<double>::infinity();

// Of twines; `constant` has numbers of its own.
enum class CylinderLawKind { constant, takagi, choo_casarella, cifuentes_kim };
constexpr std::array<const char*, 4> names_of(CylinderLawKind) {
  return {"constant", "takagi", "choo_casarella", "cifuentes_kim"};
}

// Of netting as a screen.
enum class NettingScreenLaw { loland, aarsnes, kristiansen_faltinsen };
constexpr std::array<const char*, 3> names_of(NettingScreenLaw) {
  return {"loland", "aarsnes", "kristiansen_faltinsen"};
}
inline LawRange range_of(NettingScreenLaw law) {
  constexpr LawRange ranges[] = {
      {0.1, 0.35, 0.0, unbounded},  // loland
      {0.1, 0.35, 0.0, unbounded},  // aarsnes
      {0, 0.35, 32, 10000},  // kristiansen_faltinsen
  };
  return ranges[static_cast<std::size_t>(law)];
}

// Of netting in all.
enum class NettingDrag { twines, blended, loland, aarsnes, kristiansen_faltinsen };
constexpr std::array<const char*, 5> names_of(NettingDrag) {
  return {"twines", "blended", "loland", "aarsnes", "kristiansen_faltinsen"};
}

// Of the speed of the water behind netting.
enum class WakeLaw { none, loland, cheng };
constexpr std::array<const char*, 3> names_of(WakeLaw) {
  return {"none", "loland", "cheng"};
}
inline LawRange range_of(WakeLaw law) {
  constexpr LawRange ranges[] = {
      {0.0, unbounded, 0.0, unbounded},  // none
      {0, 0.5, 0.0, unbounded},  // loland
      {0, 0.5, 0.0, unbounded},  // cheng
  };
  return ranges[static_cast<std::size_t>(law)];
}

}  // namespace codend
