#include "filled_bag.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace codend {

namespace {

// A part of a triangle: barycentric coordinates of its corners; true for corners on the front.
struct Piece {
  int triangle;
  std::array<std::array<double, 3>, 3> corner;
  std::array<bool, 3> front;
  // Its area as a fraction of the whole triangle.
  double share() const {
    const auto& [a, b, c] = corner;
    return std::abs(triple_product(Three<double>{a[0], a[1], a[2]}, Three<double>{b[0], b[1], b[2]},
                                   Three<double>{c[0], c[1], c[2]}));
  }
};

// Returns the parts of the triangles behind the front, as triangles.
std::vector<Piece> pieces_behind(const FilledBag& bag) {
  std::vector<Piece> out;
  const double most =
      bag.depth.empty() ? 0.0 : *std::max_element(bag.depth.begin(), bag.depth.end());
  const int triangles = static_cast<int>(bag.real.size());
  for (int t = 0; t < triangles; ++t) {
    double inside[3];
    for (int k = 0; k < 3; ++k) {
      inside[k] = bag.blocked - bag.depth[3 * static_cast<std::size_t>(t) + k];
      // Rows of nodes on the front, except for rounding, lie on it.
      if (std::abs(inside[k]) < 1e-9 * most) inside[k] = 0.0;
    }
    const auto add = [&](const std::array<int, 3>& from, const std::array<int, 3>& to) {
      Piece piece;
      piece.triangle = t;
      for (int k = 0; k < 3; ++k) {
        piece.corner[k] = {0.0, 0.0, 0.0};
        const double a = inside[from[k]], b = inside[to[k]];
        const double s = from[k] == to[k] ? 0.0 : a / (a - b);
        piece.corner[k][from[k]] += 1 - s;
        piece.corner[k][to[k]] += s;
        piece.front[k] = from[k] != to[k] || a == 0.0;
      }
      out.push_back(piece);
    };
    if (inside[0] >= 0 && inside[1] >= 0 && inside[2] >= 0) {
      add({0, 1, 2}, {0, 1, 2});
      continue;
    }
    for (int k = 0; k < 3; ++k) {
      const int l = (k + 1) % 3, m = (l + 1) % 3;
      if (inside[k] > 0 && inside[l] < 0 && inside[m] < 0) add({k, k, k}, {k, l, m});
      if (inside[k] < 0 && inside[l] >= 0 && inside[m] >= 0) {
        add({l, m, k}, {l, m, l});
        add({m, k, k}, {m, m, l});
      }
    }
  }
  return out;
}

template <class T>
std::array<Three<T>, 3> corners_of(const FilledBag& bag, const Piece& piece,
                                   const std::vector<T>& x) {
  std::array<Three<T>, 3> out;
  for (int c = 0; c < 3; ++c) {
    for (int k = 0; k < 3; ++k) {
      const int node = bag.node[3 * static_cast<std::size_t>(piece.triangle) + k];
      out[c] = out[c] + three(x, node) * T(piece.corner[c][k]);
    }
  }
  return out;
}

template <class T>
T area_of(const std::array<Three<T>, 3>& corner) {
  return length_of(cross(corner[1] - corner[0], corner[2] - corner[0])) / T(2.0);
}

// If |sum of normals| / sum of |normals| at a node is lower, the normals have no common direction.
constexpr double least_agreement = 0.8;

// Second fundamental form II of each triangle's surface along meshes of depth: the outward bulge of
// netting with longitudinal curvature. It is the change of the surface normal along the triangle's
// sides. A side e has the sagitta s = II(e, e) / 8. The volume between a triangle of area A and the
// curved surface is A sum(s) / 3.
template <class T>
std::vector<T> lengthwise_forms(const FilledBag& bag, const std::vector<T>& x) {
  struct Normal {
    Three<T> sum;
    double sizes = 0.0;
  };
  std::map<int, Normal> normals;
  const int triangles = static_cast<int>(bag.real.size());
  const auto node_of = [&](int t, int k) { return bag.node[3 * static_cast<std::size_t>(t) + k]; };
  for (int t = 0; t < triangles; ++t) {
    const Three<T> a = three(x, node_of(t, 0));
    const double sign = bag.weight[t] > 0 ? 1 : bag.weight[t] < 0 ? -1 : 0;
    const Three<T> out =
        cross(three(x, node_of(t, 1)) - a, three(x, node_of(t, 2)) - a) * T(sign * bag.real[t]);
    for (int k = 0; k < 3; ++k) {
      Normal& normal = normals[node_of(t, k)];
      normal.sum = normal.sum + out;
      normal.sizes += value_of(length_of(out));
    }
  }
  std::vector<T> forms;
  for (int t = 0; t < triangles; ++t) {
    bool tip = false;
    Three<T> at[3], normal[3];
    for (int k = 0; k < 3; ++k) {
      at[k] = three(x, node_of(t, k));
      const Normal& of = normals[node_of(t, k)];
      const T size = length_of(of.sum);
      // Gathered netting has a tip without a normal.
      tip = tip || value_of(size) < least_agreement * of.sizes;
      normal[k] = of.sum * (T(1.0) / size);
    }
    const auto form = [&](int i, int j) { return dot(normal[j] - normal[i], at[j] - at[i]); };
    const double* d = &bag.depth[3 * static_cast<std::size_t>(t)];
    const double* s = &bag.across[3 * static_cast<std::size_t>(t)];
    const double twice = (d[1] - d[0]) * (s[2] - s[0]) - (d[2] - d[0]) * (s[1] - s[0]);
    const double a = (s[2] - s[0]) / twice, b = -(s[1] - s[0]) / twice;
    const T first = form(0, 1), second = form(0, 2), mixed = (first + second - form(1, 2)) / T(2.0);
    const T along = T(a * a) * first + T(b * b) * second + T(2 * a * b) * mixed;
    forms.push_back(tip || !std::isfinite(value_of(along)) ? T(0.0) : along);
  }
  return forms;
}

}  // namespace

std::vector<double> pressure_weights(const FilledBag& bag) {
  std::vector<double> out(bag.node.size(), 0.0);
  for (const Piece& piece : pieces_behind(bag)) {
    for (int k = 0; k < 3; ++k) {
      out[3 * static_cast<std::size_t>(piece.triangle) + k] +=
          piece.share() / 3 * (piece.corner[0][k] + piece.corner[1][k] + piece.corner[2][k]);
    }
  }
  for (std::size_t k = 0; k < out.size(); ++k) out[k] *= bag.weight[k / 3];
  return out;
}

template <class T>
T bag_volume(const FilledBag& bag, const std::vector<T>& x) {
  const std::vector<Piece> pieces = pieces_behind(bag);
  Three<T> middle;
  double on_edge = 0.0;
  for (const Piece& piece : pieces) {
    const std::array<Three<T>, 3> corner = corners_of(bag, piece, x);
    for (int c = 0; c < 3; ++c) {
      if (!piece.front[c]) continue;
      middle = middle + corner[c];
      ++on_edge;
    }
  }
  middle = middle * T(1 / on_edge);
  const std::vector<T> form = lengthwise_forms(bag, x);
  T flat{}, bulge{};
  for (const Piece& piece : pieces) {
    const std::array<Three<T>, 3> corner = corners_of(bag, piece, x);
    const int t = piece.triangle;
    flat += triple_product(corner[0] - middle, corner[1] - middle, corner[2] - middle) *
            T(bag.weight[t] / 6);
    double depth[3];
    for (int c = 0; c < 3; ++c) {
      depth[c] = 0.0;
      for (int k = 0; k < 3; ++k) {
        depth[c] += piece.corner[c][k] * bag.depth[3 * static_cast<std::size_t>(t) + k];
      }
    }
    double sides = 0.0;
    for (int c = 0; c < 3; ++c) {
      const double side = depth[(c + 1) % 3] - depth[c];
      sides += side * side;
    }
    // Half the bulge is missing: netting keeps its length, so that its chords lie as far outside
    // the arc as inside. The same holds for a polygon with the girth of a circle. Around the bag
    // `weight` includes this correction.
    bulge += area_of(corner) * form[t] * T(bag.real[t] * sides / 48);
  }
  return flat + bulge;
}

template <class T>
T bag_surface(const FilledBag& bag, const std::vector<T>& x) {
  T sum{};
  for (const Piece& piece : pieces_behind(bag)) {
    sum += area_of(corners_of(bag, piece, x)) * T(bag.real[piece.triangle]);
  }
  return sum;
}

template double bag_volume(const FilledBag&, const std::vector<double>&);
template Dual bag_volume(const FilledBag&, const std::vector<Dual>&);
template double bag_surface(const FilledBag&, const std::vector<double>&);
template Dual bag_surface(const FilledBag&, const std::vector<Dual>&);

}  // namespace codend
