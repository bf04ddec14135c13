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

void NettingCells::add_force(const LineArrays& lines, const double* tension, int begin, int end,
                             double* force) const {
  const int cells = count();
  for (int e = begin; e < end; ++e) {
    const int u = first_line + e, v = u + cells;
    const double pull_u = lines.multiplicity[u] * tension[u] * lines.inverse_length[u];
    const double pull_v = lines.multiplicity[v] * tension[v] * lines.inverse_length[v];
    const double pull_q = pull_u * lines.twist_weight[u] + pull_v * lines.twist_weight[v];
    const double held = pull_q + lines.twist_stiffness[u] + lines.twist_stiffness[v];
    const double damped = (lines.loose[u] + lines.loose[v]) * amplitude[e] * amplitude[e] / 9.0;
    const int* n = &node[4 * static_cast<std::size_t>(e)];
    for (int c = 0; c < 3; ++c) {
      const double drag = lines.drag[c][u] + lines.drag[c][v];
      const double along_u = pull_u * lines.e[c][u], along_v = pull_v * lines.e[c][v];
      const double twisted = held * lines.twist[c][u] + damped * lines.twist_rate[c][u];
      for (int k = 0; k < 4; ++k) {
        force[3 * static_cast<std::ptrdiff_t>(n[k]) + c] +=
            share[k][e] * drag - along[0][k][e] * along_u - along[1][k][e] * along_v -
            twist[k][e] * twisted;
      }
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
