#include "netting_triangle.hpp"

namespace codend {

void NettingTriangles::prepare() {
  const std::size_t triangles = rest.size();
  for (std::vector<double>& a : shape) a.assign(triangles + 7, 0.0);
  twice_bars.resize(triangles);
  for (std::size_t e = 0; e < triangles; ++e) {
    const double* c = &twine[6 * e];
    const double d = (c[2] - c[0]) * (c[5] - c[1]) - (c[4] - c[0]) * (c[3] - c[1]);
    twice_bars[e] = d;
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3, last = (k + 2) % 3;
      shape[k][e] = (c[2 * next + 1] - c[2 * last + 1]) / d;
      shape[3 + k][e] = (c[2 * last] - c[2 * next]) / d;
    }
  }
}

void NettingTriangles::vectors(const double* x, int begin, int end, double* const u[3],
                               double* const v[3]) const {
  for (int e = begin; e < end; ++e) {
    const int* n = &node[3 * static_cast<std::size_t>(e)];
    const double* p = x + 3 * static_cast<std::ptrdiff_t>(n[0]);
    const double* q = x + 3 * static_cast<std::ptrdiff_t>(n[1]);
    const double* r = x + 3 * static_cast<std::ptrdiff_t>(n[2]);
    const double a2 = shape[1][e], a3 = shape[2][e], b2 = shape[4][e], b3 = shape[5][e];
    const int k = e - begin;
    for (int c = 0; c < 3; ++c) {
      // Shapes sum to zero; differences come first because they round less.
      const double side2 = q[c] - p[c], side3 = r[c] - p[c];
      u[c][k] = a2 * side2 + a3 * side3;
      v[c][k] = b2 * side2 + b3 * side3;
    }
  }
}

void NettingTriangles::add_force(const LineArrays& lines, const double* tension,
                                 double* force) const {
  const int triangles = count();
  for (int e = 0; e < triangles; ++e) {
    const int u = first_line + e, v = u + triangles;
    const double pull_u = lines.multiplicity[u] * tension[u] * lines.inverse_length[u];
    const double pull_v = lines.multiplicity[v] * tension[v] * lines.inverse_length[v];
    const int* n = &node[3 * static_cast<std::size_t>(e)];
    double* p = force + 3 * static_cast<std::ptrdiff_t>(n[0]);
    double* q = force + 3 * static_cast<std::ptrdiff_t>(n[1]);
    double* r = force + 3 * static_cast<std::ptrdiff_t>(n[2]);
    const double a1 = shape[0][e], a2 = shape[1][e], a3 = shape[2][e];
    const double b1 = shape[3][e], b2 = shape[4][e], b3 = shape[5][e];
    for (int c = 0; c < 3; ++c) {
      const double drag = lines.drag[c][u] + lines.drag[c][v];
      const double along_u = pull_u * lines.e[c][u], along_v = pull_v * lines.e[c][v];
      p[c] += drag - a1 * along_u - b1 * along_v;
      q[c] += drag - a2 * along_u - b2 * along_v;
      r[c] += drag - a3 * along_u - b3 * along_v;
    }
  }
}

void NettingTriangles::add_added_mass(const LineArrays& lines, double* mass) const {
  for (int e = 0; e < count(); ++e) {
    const int u = first_line + e, v = u + count();
    const Block share = added_mass(lines, u) + added_mass(lines, v);
    for (int k = 0; k < 3; ++k) {
      const std::ptrdiff_t point = node[3 * static_cast<std::size_t>(e) + k];
      Eigen::Map<Block>(mass + 9 * point) += share;
    }
  }
}

}  // namespace codend
