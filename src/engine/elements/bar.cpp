#include "bar.hpp"

namespace codend {

void Bars::vectors(const double* x, int begin, int end, double* const e[3]) const {
  double *ex = e[0], *ey = e[1], *ez = e[2];
  const int* ends = node.data() + 2 * static_cast<std::ptrdiff_t>(begin);
  for (int k = 0; k < end - begin; ++k) {
    const double* p = x + 3 * static_cast<std::ptrdiff_t>(ends[2 * k]);
    const double* q = x + 3 * static_cast<std::ptrdiff_t>(ends[2 * k + 1]);
    ex[k] = q[0] - p[0];
    ey[k] = q[1] - p[1];
    ez[k] = q[2] - p[2];
  }
}

void Bars::add_force(const LineArrays& lines, const double* tension, double* force) const {
  const int bars = count();
  for (int b = 0; b < bars; ++b) {
    const double pull = lines.multiplicity[b] * tension[b] * lines.inverse_length[b];
    double* p = force + 3 * static_cast<std::ptrdiff_t>(node[2 * static_cast<std::size_t>(b)]);
    double* q = force + 3 * static_cast<std::ptrdiff_t>(node[2 * static_cast<std::size_t>(b) + 1]);
    const double x = pull * lines.e[0][b], y = pull * lines.e[1][b], z = pull * lines.e[2][b];
    const double dx = lines.drag[0][b], dy = lines.drag[1][b], dz = lines.drag[2][b];
    p[0] += dx + x;
    p[1] += dy + y;
    p[2] += dz + z;
    q[0] += dx - x;
    q[1] += dy - y;
    q[2] += dz - z;
  }
}

void Bars::add_added_mass(const LineArrays& lines, double* mass) const {
  for (int b = 0; b < count(); ++b) {
    const Block share = added_mass(lines, b);
    for (int k = 0; k < 2; ++k) {
      const std::ptrdiff_t point = node[2 * static_cast<std::size_t>(b) + k];
      Eigen::Map<Block>(mass + 9 * point) += share;
    }
  }
}

}  // namespace codend
