// Sums over groups, like R's rowsum(), without its search for groups: they are numbered already.
#include <algorithm>
#include <cpp11.hpp>
#include <stdexcept>
#include <vector>

using namespace cpp11;

namespace {

// Converts group numbers 1 to n to indices from 0; throws if they are invalid.
std::vector<int> places_of(const integers& group, R_xlen_t size, int n) {
  if (n < 0 || group.size() != size) throw std::invalid_argument("groups do not fit");
  std::vector<int> out;
  out.reserve(static_cast<std::size_t>(size));
  for (const int g : group) {
    if (g < 1 || g > n) throw std::invalid_argument("there is no such group");
    out.push_back(g - 1);
  }
  return out;
}

}  // namespace

// Sums x over groups 1..n, in the order of x.
[[cpp11::register]] doubles group_sums(doubles x, integers group, int n) {
  const std::vector<int> place = places_of(group, x.size(), n);
  writable::doubles total(static_cast<R_xlen_t>(n));
  double* sum = REAL(total.data());
  std::fill(sum, sum + n, 0.0);
  const double* value = REAL(x.data());
  for (std::size_t k = 0; k < place.size(); ++k) sum[place[k]] += value[k];
  return total;
}
