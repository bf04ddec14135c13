#include "meshes.hpp"

#include <algorithm>

#include "../base/pi.hpp"

namespace codend {

namespace {

// Shadow grid: minimum cell size (m), maximum cells per side, minimum transmitted fraction.
constexpr double least_size = 1e-6;
constexpr double most_cells = 400.0;
constexpr double least_light = 0.01;

// A piece of netting projected along the flow; index 0: across, 1: up.
template <class T>
struct Seen {
  T at[2], by_i[2], by_j[2];
  double reach[4];
  T thick;  // -log(transmitted fraction) times its area, m2
};

template <class T>
T hidden_area(const std::vector<Seen<T>>& pieces, int across, int down, T size) {
  using std::exp;
  const std::size_t parts = static_cast<std::size_t>(across) * static_cast<std::size_t>(down);
  // The centre of a part determines its cell. Its motion only matters at the ends of the grid.
  const auto right = [&](const Seen<T>& piece, std::size_t part) {
    const double* r = piece.reach;
    return r[0] + (part / static_cast<std::size_t>(down) + 0.5) / across * (r[1] - r[0]);
  };
  const auto back = [&](const Seen<T>& piece, std::size_t part) {
    const double* r = piece.reach;
    return r[2] + (part % static_cast<std::size_t>(down) + 0.5) / down * (r[3] - r[2]);
  };
  std::vector<double> middle[2];
  T low[2], cell[2];
  int cells[2];
  for (int way = 0; way < 2; ++way) {
    middle[way].reserve(pieces.size() * parts);
    for (const Seen<T>& piece : pieces) {
      const double at = value_of(piece.at[way]);
      const double by_i = value_of(piece.by_i[way]), by_j = value_of(piece.by_j[way]);
      for (std::size_t part = 0; part < parts; ++part) {
        middle[way].push_back(at + by_i * right(piece, part) + by_j * back(piece, part));
      }
    }
    const auto whole = [&](std::vector<double>::const_iterator end) {
      const std::size_t k = static_cast<std::size_t>(end - middle[way].cbegin());
      const Seen<T>& piece = pieces[k / parts];
      return piece.at[way] + piece.by_i[way] * right(piece, k % parts) +
             piece.by_j[way] * back(piece, k % parts);
    };
    const auto ends = std::minmax_element(middle[way].cbegin(), middle[way].cend());
    low[way] = whole(ends.first);
    T wide = whole(ends.second) - low[way];
    if (wide < T(least_size)) wide = T(least_size);
    const double of = value_of(wide) / std::max(value_of(size), least_size);
    cells[way] = static_cast<int>(std::clamp(std::nearbyint(of), 1.0, most_cells));
    cell[way] = wide / T(cells[way]);
  }
  std::vector<T> sum(static_cast<std::size_t>(cells[0]) * static_cast<std::size_t>(cells[1]));
  const auto number = [&](int way, std::size_t k) {
    const double n = (middle[way][k] - value_of(low[way])) / value_of(cell[way]);
    return static_cast<std::size_t>(std::min(static_cast<int>(n), cells[way] - 1));
  };
  for (std::size_t k = 0; k < middle[0].size(); ++k) {
    sum[number(0, k) + static_cast<std::size_t>(cells[0]) * number(1, k)] +=
        pieces[k / parts].thick / T(static_cast<double>(parts));
  }
  const T one = cell[0] * cell[1];
  T hidden{};
  for (const T& thick : sum) hidden += T(1.0) - exp(-(thick / one));
  return hidden * one;
}

}  // namespace

MeshFrame mesh_frame(const Gear& gear, const PartMap& map) {
  MeshFrame out;
  for (const GearPanel& panel : gear.panels) {
    out.width.push_back(panel.width());
    out.unit.push_back(panel.unit());
    out.square.push_back(panel.square());
    out.turned.push_back(panel.orientation == MeshOrientation::turned);
  }
  const PanelRows rows = panel_rows(gear, map);
  out.row_panel = rows.group;
  out.row_t = rows.t;
  out.row = rows.row;
  out.s = rows.s;
  const int last_row = static_cast<int>(rows.group.size()) - 1;
  const int last_place = static_cast<int>(rows.row.size()) - 1;
  for (int k = 0; k <= last_place; ++k) {
    const int row = rows.row[k];
    const GearPanel& panel = gear.panels[rows.group[row]];
    out.from.push_back(rows.at[k].from);
    out.to.push_back(rows.at[k].to);
    out.share.push_back(rows.at[k].share);
    const double t = rows.t[row], s = rows.s[k];
    const double across = panel.upper + (panel.lower - panel.upper) * t;
    const double before = k > 0 && rows.row[k - 1] == row ? rows.s[k - 1] : s;
    const double after = k < last_place && rows.row[k + 1] == row ? rows.s[k + 1] : s;
    const int above = row > 0 && rows.group[row - 1] == rows.group[row] ? row - 1 : row;
    const int below = row < last_row && rows.group[row + 1] == rows.group[row] ? row + 1 : row;
    const Beside up = rows.beside(above, s), down = rows.beside(below, s);
    out.above.push_back(up.low);
    out.above_next.push_back(up.high);
    out.above_share.push_back(up.share);
    out.below.push_back(down.low);
    out.below_next.push_back(down.high);
    out.below_share.push_back(down.share);
    out.per_mesh.push_back(1 / std::max((after - before) * across, 1e-12));
    out.per_row.push_back(1 / std::max((rows.t[below] - rows.t[above]) * panel.deep, 1e-12));
    out.slant.push_back(panel.left(1) +
                        s * (panel.right(1) - panel.left(1) - (panel.right(0) - panel.left(0))));
    // Each position represents half the distance to its neighbours.
    out.fore.push_back((rows.t[above] - t) / 2 * panel.deep);
    out.aft.push_back((rows.t[below] - t) / 2 * panel.deep);
    out.port.push_back((before - s) / 2 * across);
    out.starboard.push_back((after - s) / 2 * across);
    out.meshes.push_back((after - before) / 2 * across * (out.aft.back() - out.fore.back()));
  }
  return out;
}

template <class T>
std::vector<Three<T>> MeshFrame::places(const std::vector<T>& x) const {
  std::vector<Three<T>> out;
  out.reserve(row.size());
  for (std::size_t k = 0; k < row.size(); ++k) {
    const Three<T> first = three(x, from[k]), second = three(x, to[k]);
    out.push_back(share[k] == 1.0 ? second : first + (second - first) * T(share[k]));
  }
  return out;
}

template <class T>
std::vector<MeshPlace<T>> mesh_places(const MeshFrame& frame, const std::vector<T>& x) {
  using std::acos;
  const std::vector<Three<T>> at = frame.places(x);
  const int last = frame.count() - 1;
  std::vector<MeshPlace<T>> out;
  out.reserve(at.size());
  for (int k = 0; k <= last; ++k) {
    const int before = k > 0 && frame.row[k - 1] == frame.row[k] ? k - 1 : k;
    const int after = k < last && frame.row[k + 1] == frame.row[k] ? k + 1 : k;
    MeshPlace<T> place;
    place.at = at[k];
    // Along a row: mean over both neighbours.
    place.opening =
        (length_of(at[k] - at[before]) + length_of(at[after] - at[k])) * T(frame.per_mesh[k]);
    Three<T> i = (at[after] - at[before]) * T(frame.per_mesh[k]);
    // If the row bends, the bars follow it.
    const T straight = length_of(i);
    if (value_of(straight) > 0) i = i * (place.opening / straight);
    // If the panel tapers, i changes with j down a column.
    const Three<T> up = at[frame.above[k]] +
                        (at[frame.above_next[k]] - at[frame.above[k]]) * T(frame.above_share[k]);
    const Three<T> down = at[frame.below[k]] +
                          (at[frame.below_next[k]] - at[frame.below[k]]) * T(frame.below_share[k]);
    const Three<T> j = (down - up) * T(frame.per_row[k]) - i * T(frame.slant[k]);
    place.depth = length_of(j);
    const int panel = frame.panel(k);
    // Diamond meshes: u and v are oblique; square meshes: across and down.
    place.u = frame.square[panel] ? i : (j + i) * T(0.5);
    place.v = frame.square[panel] ? j : (j - i) * T(0.5);
    const T cosine = dot(place.u, place.v) / (length_of(place.u) * length_of(place.v));
    const double c = value_of(cosine);
    place.angle = !std::isfinite(c) ? cosine : acos(c > 1 ? T(1.0) : c < -1 ? T(-1.0) : cosine);
    if (frame.turned[panel]) place.angle = T(pi) - place.angle;
    out.push_back(place);
  }
  return out;
}

template <class T>
T twine_shadow(const MeshFrame& frame, const std::vector<MeshPlace<T>>& found,
               const Three<double>& across, const Three<double>& up) {
  using std::abs;
  using std::log;
  using std::sqrt;
  std::vector<Seen<T>> pieces;
  T area_sum{}, wide{}, deep{};
  for (int k = 0; k < frame.count(); ++k) {
    if (!(frame.meshes[k] > 0)) continue;
    const MeshPlace<T>& place = found[k];
    const int panel = frame.panel(k);
    const double both = frame.square[panel] ? 0.0 : 1.0;
    Seen<T> piece;
    T u[2], v[2];
    for (int way = 0; way < 2; ++way) {
      const Three<double>& axis = way == 0 ? across : up;
      const auto along = [&](const Three<T>& x) {
        return x.x * T(axis.x) + x.y * T(axis.y) + x.z * T(axis.z);
      };
      u[way] = along(place.u);
      v[way] = along(place.v);
      piece.at[way] = along(place.at);
      piece.by_i[way] = u[way] - v[way] * T(both);
      piece.by_j[way] = u[way] * T(both) + v[way];
    }
    const auto long_of = [](const T* x) { return sqrt(x[0] * x[0] + x[1] * x[1]); };
    // A diamond mesh is the parallelogram of two bars of each family, a square mesh of one.
    const T bars(frame.meshes[k] * (1 + both));
    const T area = bars * abs(u[0] * v[1] - u[1] * v[0]);
    const auto through = [&](const T* bar) {
      const T hidden =
          bars * T(frame.width[panel]) * long_of(bar) / (value_of(area) > 1e-12 ? area : T(1e-12));
      return T(1.0) - (value_of(hidden) > 1 ? T(1.0) : hidden);
    };
    const T light = through(u) * through(v);
    piece.thick = -log(value_of(light) > least_light ? light : T(least_light)) * area;
    const double reach[4] = {frame.port[k], frame.starboard[k], frame.fore[k], frame.aft[k]};
    std::copy(reach, reach + 4, piece.reach);
    wide += long_of(piece.by_i) * T(reach[1] - reach[0]);
    deep += long_of(piece.by_j) * T(reach[3] - reach[2]);
    area_sum += area;
    pieces.push_back(piece);
  }
  if (pieces.empty()) return T(0.0);
  // Parts with equal size across and down, on average.
  const double n = static_cast<double>(pieces.size());
  const double ways = std::clamp(
      std::nearbyint(4 * std::sqrt(value_of(wide) / n / std::max(value_of(deep) / n, 1e-9))), 1.0,
      16.0);
  return hidden_area(pieces, static_cast<int>(ways), static_cast<int>(std::nearbyint(16 / ways)),
                     sqrt(area_sum / T(n)));
}

template std::vector<Three<double>> MeshFrame::places(const std::vector<double>&) const;
template std::vector<Three<Dual>> MeshFrame::places(const std::vector<Dual>&) const;
template std::vector<MeshPlace<double>> mesh_places(const MeshFrame&, const std::vector<double>&);
template std::vector<MeshPlace<Dual>> mesh_places(const MeshFrame&, const std::vector<Dual>&);
template double twine_shadow(const MeshFrame&, const std::vector<MeshPlace<double>>&,
                             const Three<double>&, const Three<double>&);
template Dual twine_shadow(const MeshFrame&, const std::vector<MeshPlace<Dual>>&,
                           const Three<double>&, const Three<double>&);

}  // namespace codend
