// Sums over groups of an array's numbers, for the lattice: what R's rowsum() gives, without its search
// for groups, where these are numbered already.
#include <algorithm>
#include <cmath>
#include <cpp11.hpp>
#include <stdexcept>
#include <vector>

using namespace cpp11;

namespace {

// Of numbers from 1 to n, from 0.
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

// Heights that differ by less than this share are one: rounding keeps them apart.
constexpr double same_height = 1e-11;

}  // namespace

// Sums of x over groups 1..n, added up in the order of x.
[[cpp11::register]] doubles group_sums(doubles x, integers group, int n) {
  const std::vector<int> place = places_of(group, x.size(), n);
  writable::doubles total(static_cast<R_xlen_t>(n));
  double* sum = REAL(total.data());
  std::fill(sum, sum + n, 0.0);
  const double* value = REAL(x.data());
  for (std::size_t k = 0; k < place.size(); ++k) sum[place[k]] += value[k];
  return total;
}

// The largest x (0 or more) of groups 1..n; 0 of a group that has none.
[[cpp11::register]] doubles group_maxima(doubles x, integers group, int n) {
  const std::vector<int> place = places_of(group, x.size(), n);
  writable::doubles most(static_cast<R_xlen_t>(n));
  double* found = REAL(most.data());
  std::fill(found, found + n, 0.0);
  const double* value = REAL(x.data());
  for (std::size_t k = 0; k < place.size(); ++k) {
    found[place[k]] = std::max(found[place[k]], value[k]);
  }
  return most;
}

// Volumes (m3, at least 0) at points 1..n that leave the water over one height (m) at one point,
// together: list(first = the first of each group, volume), in the order of these. What has no
// volume or height is left out.
[[cpp11::register]] list group_volumes(doubles volume, doubles height, integers point, int n) {
  const std::vector<int> place = places_of(point, volume.size(), n);
  if (height.size() != volume.size()) throw std::invalid_argument("heights do not fit");
  const double *v = REAL(volume.data()), *h = REAL(height.data());
  std::vector<int> newest(static_cast<std::size_t>(n), -1), before, first;
  std::vector<double> sum;
  for (std::size_t k = 0; k < place.size(); ++k) {
    if (!(v[k] > 0.0 && h[k] > 0.0)) continue;
    int& last = newest[static_cast<std::size_t>(place[k])];
    int group = last;
    while (group >= 0 && std::abs(h[first[group]] - h[k]) > same_height * h[k])
      group = before[group];
    if (group < 0) {
      before.push_back(last);
      last = group = static_cast<int>(first.size());
      first.push_back(static_cast<int>(k));
      sum.push_back(0.0);
    }
    sum[static_cast<std::size_t>(group)] += v[k];
  }
  writable::integers places(static_cast<R_xlen_t>(first.size()));
  for (std::size_t g = 0; g < first.size(); ++g) places[static_cast<R_xlen_t>(g)] = first[g] + 1;
  return writable::list(
      {"first"_nm = places, "volume"_nm = writable::doubles(sum.begin(), sum.end())});
}
