#include "netting_cell.hpp"

namespace codend {

void NettingCells::prepare() {
  const std::size_t cells = rest.size();
  auto clear = [cells](std::vector<double>& values) { values.assign(cells + 7, 0.0); };
  for (int k = 0; k < 4; ++k) {
    for (int f = 0; f < 2; ++f) clear(along[f][k]);
    clear(twist[k]);
    clear(share[k]);
  }
  for (int f = 0; f < 2; ++f) {
    clear(twist_weight[f]);
    clear(sag_weight[f]);
  }
  clear(bars);
  clear(amplitude);
  for (std::size_t e = 0; e < cells; ++e) {
    const CellShape s = cell_shape(&twine[8 * e]);
    for (int k = 0; k < 4; ++k) {
      for (int f = 0; f < 2; ++f) along[f][k][e] = s.along[f][k];
      twist[k][e] = s.twist[k];
      share[k][e] = s.share[k];
    }
    for (int f = 0; f < 2; ++f) {
      twist_weight[f][e] = s.twist_weight[f];
      sag_weight[f][e] = s.sag_weight[f];
    }
    bars[e] = s.bars;
    amplitude[e] = s.amplitude;
  }
}

CellArrays NettingCells::arrays() const {
  CellArrays out;
  out.first = first_line;
  out.count = count();
  for (int k = 0; k < 4; ++k) {
    for (int f = 0; f < 2; ++f) out.along[f][k] = along[f][k].data();
    out.twist[k] = twist[k].data();
    out.share[k] = share[k].data();
  }
  for (int f = 0; f < 2; ++f) {
    out.twist_weight[f] = twist_weight[f].data();
    out.sag_weight[f] = sag_weight[f].data();
  }
  out.amplitude = amplitude.data();
  return out;
}

Line<4> NettingCells::line(int cell, int which) const {
  const std::size_t e = static_cast<std::size_t>(cell);
  Line<4> out;
  out.nodes = &node[4 * e];
  for (int k = 0; k < 4; ++k) {
    out.shape[k] = along[which][k][e];
    out.twist[k] = twist[k][e];
    out.share[k] = share[k][e];
  }
  out.twist_weight = twist_weight[which][e];
  out.rest = rest[e];
  out.multiplicity = bars[e] * multiplicity[e];
  out.material = material[e];
  out.index = first_line + which * count() + cell;
  out.point_share = 1.0;
  return out;
}

void NettingCells::vectors(const double* x, int begin, int end, double* const u[3],
                           double* const v[3], double* const q[3]) const {
  for (int e = begin; e < end; ++e) {
    const int* n = &node[4 * static_cast<std::size_t>(e)];
    const double* first = x + 3 * static_cast<std::ptrdiff_t>(n[0]);
    const double* corner[3];
    for (int k = 0; k < 3; ++k) corner[k] = x + 3 * static_cast<std::ptrdiff_t>(n[k + 1]);
    const int place = e - begin;
    for (int c = 0; c < 3; ++c) {
      // The sum of each shape function is zero. Differences of positions have a smaller rounding
      // error.
      double along_u = 0.0, along_v = 0.0, twisted = 0.0;
      for (int k = 0; k < 3; ++k) {
        const double side = corner[k][c] - first[c];
        along_u += along[0][k + 1][e] * side;
        along_v += along[1][k + 1][e] * side;
        twisted += twist[k + 1][e] * side;
      }
      u[c][place] = along_u;
      v[c][place] = along_v;
      q[c][place] = twisted;
    }
  }
}

void NettingCells::add_added_mass(const LineArrays& lines, double* mass) const {
  for (int e = 0; e < count(); ++e) {
    const int u = first_line + e, v = u + count();
    const Block whole = added_mass(lines, u) + added_mass(lines, v);
    for (int k = 0; k < 4; ++k) {
      const std::ptrdiff_t point = node[4 * static_cast<std::size_t>(e) + k];
      Eigen::Map<Block>(mass + 9 * point) += share[k][e] * whole;
    }
  }
}

}  // namespace codend
