#include "hexagonal_triangle.hpp"

namespace codend {

constexpr std::array<double, 4> HexagonalTriangles::share;

void HexagonalTriangles::prepare() {
  const std::size_t triangles = straight.size();
  shape_.resize(6 * triangles);
  cells_.resize(triangles);
  for (std::size_t e = 0; e < triangles; ++e) {
    const double* c = &twine[6 * e];
    const double d = (c[2] - c[0]) * (c[5] - c[1]) - (c[4] - c[0]) * (c[3] - c[1]);
    cells_[e] = 0.5 * std::abs(d);
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3, last = (k + 2) % 3;
      shape_[6 * e + k] = (c[2 * next + 1] - c[2 * last + 1]) / d;
      shape_[6 * e + 3 + k] = (c[2 * last] - c[2 * next]) / d;
    }
  }
}

Line<4> HexagonalTriangles::line(int triangle, int which) const {
  const std::size_t e = static_cast<std::size_t>(triangle);
  Line<4> out;
  out.nodes = &node[4 * e];
  for (int k = 0; k < 3; ++k) {
    out.shape[k] = which == 0 ? -1.0 / 3.0 : shape_[6 * e + 3 * (which - 1) + k] + 1.0 / 3.0;
  }
  out.shape[3] = which == 0 ? 1.0 : -1.0;
  out.rest = which == 0 ? straight[e] : oblique[e];
  out.multiplicity = cells_[e] * multiplicity[e];
  out.material = material[e];
  out.index = first_line + which * count() + triangle;
  out.point_share = 1.0;
  return out;
}

void HexagonalTriangles::vectors(int which, const double* x, int begin, int end,
                                 double* const e[3]) const {
  for (int t = begin; t < end; ++t) {
    const Line<4> bar = line(t, which);
    const Vector first = at(x, bar.nodes[0]);
    // The sum of `shape` is zero. Differences of positions have a smaller rounding error.
    Vector sum = Vector::Zero();
    for (int k = 1; k < 4; ++k) sum += bar.shape[k] * (at(x, bar.nodes[k]) - first);
    for (int c = 0; c < 3; ++c) e[c][t - begin] = sum[c];
  }
}

void HexagonalTriangles::add_force(const LineArrays& lines, const double* tension,
                                   double* force) const {
  for (int t = 0; t < count(); ++t) {
    for (int which = 0; which < 3; ++which) {
      const Line<4> bar = line(t, which);
      const int i = bar.index;
      const Vector pull = bar.multiplicity * tension[i] * lines.inverse_length[i] *
                          Vector(lines.e[0][i], lines.e[1][i], lines.e[2][i]);
      const Vector drag(lines.drag[0][i], lines.drag[1][i], lines.drag[2][i]);
      for (int k = 0; k < 4; ++k) at(force, bar.nodes[k]) += share[k] * drag - bar.shape[k] * pull;
    }
  }
}

void HexagonalTriangles::add_jacobian(const double* slopes, const BlockSink& sink) const {
  const int triangles = count();
  for (int t = 0; t < triangles; ++t) {
    Block blocks[16];
    for (Block& block : blocks) block.setZero();
    for (int which = 0; which < 3; ++which) {
      const Line<4> bar = line(t, which);
      const double* s = slopes + 27 * (static_cast<std::ptrdiff_t>(which) * triangles + t);
      const Eigen::Map<const Block> pull(s), turn(s + 9), everywhere(s + 18);
      for (int k = 0; k < 4; ++k) {
        for (int l = 0; l < 4; ++l) {
          blocks[4 * k + l] += bar.shape[k] * bar.shape[l] * pull - share[k] * bar.shape[l] * turn +
                               share[k] * share[l] * everywhere;
        }
      }
    }
    for (int k = 0; k < 4; ++k) {
      for (int l = 0; l < 4; ++l) sink.add(t, k, l, blocks[4 * k + l]);
    }
  }
}

void HexagonalTriangles::add_added_mass(const LineArrays& lines, double* mass) const {
  for (int t = 0; t < count(); ++t) {
    Block whole = Block::Zero();
    for (int which = 0; which < 3; ++which) whole += added_mass(lines, line(t, which).index);
    for (int k = 0; k < 4; ++k) {
      const std::ptrdiff_t point = node[4 * static_cast<std::size_t>(t) + k];
      Eigen::Map<Block>(mass + 9 * point) += share[k] * whole;
    }
  }
}

}  // namespace codend
