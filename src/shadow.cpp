// What pieces of netting hide of the flow together, on a grid across it (R/measure-meshes.R).
#include <algorithm>
#include <cmath>
#include <cpp11.hpp>
#include <stdexcept>
#include <vector>

using namespace cpp11;

namespace {

// Cells of the grid are no smaller (m), and no more along one side.
constexpr double least_size = 1e-6;
constexpr int most_cells = 400;

}  // namespace

// Area (m2) across the flow that pieces hide.
//
// place, by_i, by_j: per piece, across the flow and up: where it is (m) and how that changes by meshes
// across and down the netting (m); 2 each. reach: per piece the meshes to its port, starboard, fore and
// aft edge; 4 each. depth: per piece -log of the share that it lets through, times its area (m2); it is
// spread evenly over across times down parts of the piece. size: of a cell of the grid (m).
[[cpp11::register]] double shadow_area(doubles place, doubles by_i, doubles by_j, doubles reach,
                                       doubles depth, int across, int down, double size) {
  const R_xlen_t pieces = depth.size();
  if (place.size() != 2 * pieces || by_i.size() != 2 * pieces || by_j.size() != 2 * pieces ||
      reach.size() != 4 * pieces || across < 1 || down < 1) {
    throw std::invalid_argument("pieces do not fit");
  }
  if (pieces == 0) return 0.0;
  const double *at = REAL(place.data()), *i = REAL(by_i.data()), *j = REAL(by_j.data()),
               *edge = REAL(reach.data()), *thick = REAL(depth.data());
  const std::size_t parts = static_cast<std::size_t>(across) * static_cast<std::size_t>(down);
  std::vector<double> middle[2];
  double low[2], cell[2];
  int cells[2];
  for (int way = 0; way < 2; ++way) {
    middle[way].reserve(parts * static_cast<std::size_t>(pieces));
    for (R_xlen_t k = 0; k < pieces; ++k) {
      const double* r = edge + 4 * k;
      for (int a = 0; a < across; ++a) {
        const double meshes_across = r[0] + (a + 0.5) / across * (r[1] - r[0]);
        for (int d = 0; d < down; ++d) {
          const double meshes_down = r[2] + (d + 0.5) / down * (r[3] - r[2]);
          middle[way].push_back(at[2 * k + way] + i[2 * k + way] * meshes_across +
                                j[2 * k + way] * meshes_down);
        }
      }
    }
    const auto ends = std::minmax_element(middle[way].begin(), middle[way].end());
    low[way] = *ends.first;
    const double wide = std::max(*ends.second - *ends.first, least_size);
    cells[way] = static_cast<int>(
        std::clamp(std::nearbyint(wide / std::max(size, least_size)), 1.0, 1.0 * most_cells));
    cell[way] = wide / cells[way];
  }
  std::vector<double> sum(static_cast<std::size_t>(cells[0]) * static_cast<std::size_t>(cells[1]));
  const auto number = [&](int way, std::size_t k) {
    const int n = static_cast<int>((middle[way][k] - low[way]) / cell[way]);
    return static_cast<std::size_t>(std::min(n, cells[way] - 1));
  };
  for (std::size_t k = 0; k < middle[0].size(); ++k) {
    sum[number(0, k) + static_cast<std::size_t>(cells[0]) * number(1, k)] +=
        thick[k / parts] / static_cast<double>(parts);
  }
  const double one = cell[0] * cell[1];
  double hidden = 0.0;
  for (const double s : sum) hidden += 1.0 - std::exp(-s / one);
  return hidden * one;
}
