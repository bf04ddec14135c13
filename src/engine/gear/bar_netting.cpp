#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "netting.hpp"
#include "sums.hpp"

namespace codend {

namespace {

// Sides of a panel on which a knot or the end of a twine lies: none, then the edges in order.
enum Side { inside = 0, on_upper, on_lower, on_left, on_right };

struct Knot {
  int row;
  double i, j;         // mesh coordinates
  double at;           // i before the knot was moved to a side
  double left, right;  // i of the panel's sides in its row
  int edge = inside;   // side to which it was moved
  bool kept = false;
  bool gathered = false;  // moved farther, because its row is too narrow for a knot
};

// All candidate knots of a panel, row by row, with two beyond the panel at both ends of a row.
struct KnotRows {
  std::vector<Knot> knots;
  int width = 0;  // knots in a row
  int rows = 0;   // index of the last row
};

// A twine between two knots, or from a knot to a cut end on a side.
struct Twine {
  int family;
  int from, to;  // knots; `to` is unused if `cut`
  bool cut = false;
  double share = 1.0;  // remaining fraction of its length
  double i = 0.0, j = 0.0;
  int edge = inside;        // side at which it is cut
  bool along_edge = false;  // on an edge; half of it belongs to the neighbour
};

// A node of a panel of bars: a knot, a cut end, or an interior node of a bar.
struct Point {
  double i, j;
  int edge = inside;
  double fraction = 0.0;  // along that edge
  double knots = 0.0;     // number of real knots that it represents
};

struct Segment {
  int first, second;  // points; interior nodes of bars follow all others
  double rest, multiplicity;
};

struct BarPanel {
  int panel, part;
  double lambda;
  int segments;  // per bar
  int rows;      // of knots
  std::vector<Point> points, between;
  std::vector<Segment> bars;
  std::vector<std::array<int, 4>> meshes;  // points around each equivalent mesh with uncut bars
  std::vector<int> id;                     // node of every point, then of the interior nodes
};

int count_rows(const GearPanel& panel, double lambda) {
  return at_least_one(std::nearbyint((2 - panel.square()) * panel.deep / lambda));
}

double distance_outside(const Knot& knot) {
  return std::max({knot.left - knot.at, knot.at - knot.right, 0.0});
}

// Moves the nearest knots to the sides in a row without a knot. Otherwise no twine would hold the
// point of a panel that narrows to less than a mesh.
void gather_row(std::vector<Knot>::iterator begin, std::vector<Knot>::iterator end, double lambda) {
  if (std::any_of(begin, end, [](const Knot& knot) { return knot.kept; })) return;
  double nearest = lambda;
  std::for_each(begin, end,
                [&](const Knot& knot) { nearest = std::min(nearest, distance_outside(knot)); });
  std::for_each(begin, end, [&](Knot& knot) {
    if (distance_outside(knot) > nearest + 1e-9 * lambda) return;
    knot.kept = knot.gathered = true;
    knot.edge = knot.at < knot.left ? on_left : on_right;
    knot.i = knot.edge == on_left ? knot.left : knot.right;
  });
}

// True if both knots lie on one side of the panel. A row without width lies on both sides.
bool on_one_side(const Knot& a, const Knot& b) {
  if (a.edge == inside || b.edge == inside) return false;
  return a.edge == b.edge || a.left == a.right || b.left == b.right;
}

KnotRows knot_rows(const GearPanel& panel, double lambda, int rows) {
  KnotRows out;
  out.rows = rows;
  // If the width is a whole number of equivalent meshes, the ends of the upper edge have knots.
  // Otherwise its middle has one.
  const double meshes = std::nearbyint(panel.upper / lambda);
  const bool half = std::abs(panel.upper / lambda - meshes) < 1e-6 && std::fmod(meshes, 2.0) == 1.0;
  const double centre = panel.upper / 2 + half * lambda / 2;
  const double low = std::min(panel.left(panel.deep), 0.0);
  const double high = std::max(panel.right(panel.deep), panel.upper);
  const double begin = std::floor((low - centre) / lambda) - 2;
  out.width = static_cast<int>(std::ceil((high - centre) / lambda) + 3 - begin);
  const double near = lambda / 4 + 1e-9;
  for (int row = 0; row <= rows; ++row) {
    const int shift = panel.square() ? 0 : row % 2;
    // Twines of the first and last row of diamond meshes end there, not at a side.
    const bool ends = !panel.square() && (row == 0 || row == rows);
    for (int k = 0; k < out.width; ++k) {
      Knot knot;
      knot.row = row;
      knot.at = knot.i = centre + lambda * (begin + k + shift / 2.0);
      knot.j = row * (panel.deep / rows);
      knot.left = panel.left(knot.j);
      knot.right = panel.right(knot.j);
      const double from_left = knot.i - knot.left, from_right = knot.right - knot.i;
      if (std::abs(from_left) <= near && !(ends && from_left > 1e-9 * near)) {
        knot.edge = on_left;
        knot.i = knot.left;
      } else if (std::abs(from_right) <= near && !(ends && from_right > 1e-9 * near)) {
        knot.edge = on_right;
        knot.i = knot.right;
      }
      knot.kept = from_left >= -near && from_right >= -near;
      out.knots.push_back(knot);
    }
    gather_row(out.knots.end() - out.width, out.knots.end(), lambda);
  }
  return out;
}

// Computes the end of a twine on a side; returns true if it ends there. A twine that crosses the
// side is cut at the crossing. A twine with its last knot near the side is cut or extended along
// its direction, so that lengths are exact. A twine nearly parallel to the side keeps its knot,
// which is moved to the side.
bool cut_twine(const std::vector<Knot>& knots, Twine& twine) {
  const Knot &from = knots[twine.from], &to = knots[twine.to];
  const bool leaves = from.kept != to.kept;
  if (!leaves && (from.edge > 0) == (to.edge > 0)) return false;
  const bool starts = leaves ? from.kept : from.edge == inside;
  const int inner_number = starts ? twine.from : twine.to;
  const Knot &inner = knots[inner_number], &outer = knots[starts ? twine.to : twine.from];
  const int side = outer.edge != inside ? outer.edge : outer.at < outer.left ? on_left : on_right;
  const auto gap = [&](const Knot& knot) {
    return side == on_left ? knot.at - knot.left : knot.right - knot.at;
  };
  const double within = gap(inner), share = within / (within - gap(outer));
  // A knot on the side belongs to the side.
  if (inner.edge != inside || outer.gathered) return false;
  if (!leaves && !(std::abs(gap(outer)) > 1e-9 * within && std::isfinite(share) && share > 0.45 &&
                   share < 1.55)) {
    return false;
  }
  twine.cut = true;
  twine.from = inner_number;
  twine.share = share;
  twine.edge = side;
  twine.i = inner.at + share * (outer.at - inner.at);
  twine.j = inner.j + share * (outer.j - inner.j);
  return true;
}

// Returns the twines between knots; at least one of their two knots is kept. They run to the next
// row; twines of square meshes also run along the row. Order: uncut twines of one family, then of
// the other, then cut twines.
std::vector<Twine> knot_twines(const GearPanel& panel, const KnotRows& rows) {
  const std::vector<Knot>& knots = rows.knots;
  const int number = static_cast<int>(knots.size());
  std::vector<Twine> whole, cut;
  for (int family = 0; family < 2; ++family) {
    for (int k = 0; k < number; ++k) {
      const Knot& from = knots[k];
      const int shift = panel.square() ? 0 : from.row % 2;
      int to = k + rows.width + shift - family;
      if (panel.square() && family == 1) {
        to = k + 1;
      } else if (from.row == rows.rows) {
        continue;
      }
      const bool there = to < number && knots[to].kept;
      if (!from.kept && !there) continue;
      Twine twine;
      twine.family = family;
      twine.from = k;
      twine.to = to;
      if (cut_twine(knots, twine)) {
        cut.push_back(twine);
      } else if (from.kept && there) {
        const bool ends_row = panel.square() && (from.row == 0 || from.row == rows.rows);
        twine.along_edge = on_one_side(from, knots[to]) || (ends_row && from.row == knots[to].row);
        whole.push_back(twine);
      }
    }
  }
  whole.insert(whole.end(), cut.begin(), cut.end());
  return whole;
}

// Sets the edge of every point, its fraction along the edge, and the number of knots it represents.
void place_points(const GearPanel& panel, std::vector<Point>& points) {
  double all = 0.0;
  for (Point& point : points) {
    if (point.edge == inside && point.j <= 1e-9 * panel.deep) point.edge = on_upper;
    if (point.edge == inside && point.j >= panel.deep * (1 - 1e-9)) point.edge = on_lower;
    point.fraction = point.j / panel.deep;
    if (point.edge <= on_lower) {
      const double left = panel.left(point.j);
      point.fraction = (point.i - left) / std::max(panel.right(point.j) - left, 1e-300);
    }
    // A knot on an edge belongs half to the neighbour.
    all += point.edge == inside ? 1.0 : 0.5;
  }
  for (Point& point : points) {
    point.knots = panel.bar_count() * (point.edge == inside ? 1.0 : 0.5) / all;
  }
}

// Returns the knots around each mesh whose four twines are uncut.
std::vector<std::array<int, 4>> whole_meshes(const std::vector<Twine>& twines, std::size_t knots) {
  std::vector<int> next[2] = {std::vector<int>(knots, -1), std::vector<int>(knots, -1)};
  for (const Twine& twine : twines) {
    if (!twine.cut) next[twine.family][twine.from] = twine.to;
  }
  std::vector<std::array<int, 4>> out;
  for (std::size_t k = 0; k < knots; ++k) {
    const int first = next[0][k], second = next[1][k];
    if (first < 0 || second < 0) continue;
    const int opposite = next[1][first];
    if (opposite >= 0 && next[0][second] == opposite) {
      out.push_back({static_cast<int>(k), first, opposite, second});
    }
  }
  return out;
}

BarPanel bar_panel(const GearPanel& panel, double lambda, int segments) {
  BarPanel out;
  out.lambda = lambda;
  out.segments = segments;
  out.rows = count_rows(panel, lambda);
  const KnotRows rows = knot_rows(panel, lambda, out.rows);
  const std::vector<Twine> twines = knot_twines(panel, rows);

  // Numbers the knots at the ends of twines, then cut ends.
  std::vector<int> number(rows.knots.size(), -1);
  for (const Twine& twine : twines) {
    number[twine.from] = 0;
    if (!twine.cut) number[twine.to] = 0;
  }
  for (std::size_t k = 0; k < rows.knots.size(); ++k) {
    const Knot& knot = rows.knots[k];
    if (!knot.kept || number[k] < 0) continue;
    number[k] = static_cast<int>(out.points.size());
    out.points.push_back({knot.i, knot.j, knot.edge});
  }
  std::vector<double> lengths;
  std::vector<Segment> bars;
  for (const Twine& twine : twines) {
    Segment bar;
    bar.first = number[twine.from];
    bar.second = twine.cut ? static_cast<int>(out.points.size()) : number[twine.to];
    if (twine.cut) out.points.push_back({twine.i, twine.j, twine.edge});
    bar.rest = twine.share * lambda * panel.mesh_size / 2;
    bar.multiplicity = lambda * (1 - 0.5 * twine.along_edge);
    lengths.push_back(bar.multiplicity * bar.rest);
    bars.push_back(bar);
  }
  for (std::array<int, 4> mesh : whole_meshes(twines, rows.knots.size())) {
    for (int& knot : mesh) knot = number[knot];
    out.meshes.push_back(mesh);
  }
  place_points(panel, out.points);
  const double exact = 2 * panel.bar_count() * panel.mesh_size / 2, built = exact_sum(lengths);
  const int first_between = static_cast<int>(out.points.size());
  for (Segment bar : bars) {
    bar.multiplicity = bar.multiplicity * exact / built;
    const Point &a = out.points[bar.first], &b = out.points[bar.second];
    // Equal segments with interior nodes (only between mesh knots).
    int from = bar.first;
    for (int step = 1; step <= segments; ++step) {
      int to = bar.second;
      if (step < segments) {
        const double share = static_cast<double>(step) / segments;
        to = first_between + static_cast<int>(out.between.size());
        out.between.push_back(
            {(1 - share) * a.i + share * b.i, (1 - share) * a.j + share * b.j, inside});
      }
      out.bars.push_back({from, to, bar.rest / segments, bar.multiplicity});
      from = to;
    }
  }
  return out;
}

// Returns the point at fraction `at` of an edge: a node, or a point tied between two nodes.
int edge_point(Collection& to, const EdgeNodes& edges, int edge, double at) {
  at = std::min(std::max(at, 0.0), 1.0);
  const int cell = edges.cell_of(at, edge);
  const double low = edges.fraction[cell];
  const double share = (at - low) / (edges.fraction[cell + 1] - low);
  const int first = edges.edge_node[cell], second = edges.edge_node[cell + 1];
  if (share < 1e-6 || share > 1 - 1e-6 || first == second) return share > 0.5 ? second : first;
  return to.tie(first, second, share);
}

// Adds wake sheets between equivalent bars: half a mesh below every knot where two bars begin, and
// half a mesh above every knot where two bars end. The twine area of a panel is distributed evenly
// over its sheets.
void add_wake_sheets(Collection& to, const Gear& gear, const std::vector<BarPanel>& all) {
  std::vector<int> number(all.size(), 0);
  std::vector<std::size_t> of_sheet;
  WakeSheets& sheets = to.wake_sheets;
  for (const bool below : {true, false}) {
    for (std::size_t p = 0; p < all.size(); ++p) {
      const BarPanel& panel = all[p];
      const WakeLaw law = gear.panels[panel.panel].shielding;
      if (law == WakeLaw::none) continue;
      std::vector<std::pair<int, int>> bars;  // knot, other end
      for (std::size_t b = 0; b < panel.bars.size(); b += panel.segments) {
        const int from = panel.id[panel.bars[b].first];
        const int end = panel.id[panel.bars[b + panel.segments - 1].second];
        bars.emplace_back(below ? from : end, below ? end : from);
      }
      std::stable_sort(bars.begin(), bars.end(),
                       [](const auto& a, const auto& b) { return a.first < b.first; });
      for (std::size_t b = 1; b < bars.size(); ++b) {
        if (bars[b].first != bars[b - 1].first) continue;
        sheets.node.insert(sheets.node.end(), {bars[b].first, bars[b - 1].second, bars[b].second});
        sheets.law.push_back(law);
        of_sheet.push_back(p);
        ++number[p];
      }
    }
  }
  for (const std::size_t p : of_sheet) {
    const GearPanel& panel = gear.panels[all[p].panel];
    const double area = 2 * panel.bar_count() * panel.mesh_size / 2 * panel.width();
    sheets.twine_area.push_back(area / number[p]);
    sheets.overlap.push_back(panel.crossing_overlap());
  }
}

// Adds the stiffness against twist of netting_twist.hpp.
void add_twists(Collection& to, const BarPanel& panel) {
  if (panel.lambda <= 1 + 1e-9) return;
  for (std::array<int, 4> mesh : panel.meshes) {
    for (int& node : mesh) node = panel.id[node];
    to.add_twist(mesh, (panel.lambda - 1 / panel.lambda) / 6, panel.part);
  }
}

// Knots of a panel in rows, with ends on both sides.
struct RowPlaces {
  std::vector<int> row, id;
  std::vector<double> i, s;  // s: fraction of the panel's width
};

// Adds sheets between the rows of knots of panels that need them.
void add_sheets(Collection& to, const Gear& gear, const Division& division,
                const std::vector<BarPanel>& all) {
  std::vector<RowPlaces> places(all.size());
  const auto needs = [&](const BarPanel& bars) {
    const GearPanel& panel = gear.panels[bars.panel];
    return panel.drag != NettingDrag::morison || panel.stiff ||
           (gear.has_bag && std::count(gear.bag.panels.begin(), gear.bag.panels.end(), bars.panel));
  };
  std::vector<std::vector<char>> open[2];  // rows without a knot on the left and right side
  for (std::size_t p = 0; p < all.size(); ++p) {
    const BarPanel& bars = all[p];
    const GearPanel& panel = gear.panels[bars.panel];
    for (auto& of : open) of.emplace_back(static_cast<std::size_t>(bars.rows) + 1, 1);
    if (!needs(bars)) continue;
    RowPlaces& known = places[p];
    for (std::size_t k = 0; k < bars.points.size(); ++k) {
      const double at = bars.points[k].j * (bars.rows / panel.deep);
      const int row = static_cast<int>(std::nearbyint(at));
      if (std::abs(at - row) >= 1e-6) continue;
      const double j = static_cast<double>(row) / bars.rows * panel.deep, left = panel.left(j);
      const double s = (bars.points[k].i - left) / std::max(panel.right(j) - left, 1e-9);
      known.row.push_back(row);
      known.id.push_back(bars.id[k]);
      known.i.push_back(bars.points[k].i);
      known.s.push_back(std::min(std::max(s, 0.0), 1.0));
      if (std::abs(known.s.back() - 0) < 1e-6) open[0][p][row] = 0;
      if (std::abs(known.s.back() - 1) < 1e-6) open[1][p][row] = 0;
    }
  }
  for (int side = 0; side < 2; ++side) {
    for (std::size_t p = 0; p < all.size(); ++p) {
      RowPlaces& known = places[p];
      const GearPanel& panel = gear.panels[all[p].panel];
      if (known.row.empty()) continue;
      for (int row = 0; row <= all[p].rows; ++row) {
        if (!open[side][p][row]) continue;
        const double depth = static_cast<double>(row) / all[p].rows, j = depth * panel.deep;
        known.row.push_back(row);
        known.id.push_back(edge_point(to, division.edges, 4 * all[p].panel + 2 + side, depth));
        known.i.push_back(side == 0 ? panel.left(j) : panel.right(j));
        known.s.push_back(side);
      }
    }
  }
  for (std::size_t p = 0; p < all.size(); ++p) {
    const RowPlaces& known = places[p];
    const GearPanel& panel = gear.panels[all[p].panel];
    const double lambda = all[p].lambda;
    std::vector<int> order(known.row.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
      return known.row[a] != known.row[b] ? known.row[a] < known.row[b] : known.s[a] < known.s[b];
    });
    std::vector<int> row;
    std::vector<double> s, u, v;
    for (const int k : order) {
      const double j = known.row[k] * (panel.deep / all[p].rows);
      row.push_back(known.row[k]);
      s.push_back(known.s[k]);
      u.push_back(panel.square() ? known.i[k] : known.i[k] + j);
      v.push_back(panel.square() ? j : j - known.i[k]);
    }
    for (const auto& facet : row_facets(row, s)) {
      if (!(triangle_area(u.data(), v.data(), facet[0], facet[1], facet[2]) >
            1e-9 * (lambda * lambda)))
        continue;
      for (const int k : {facet[0], facet[1], facet[2], facet[2]}) {
        to.sheets.node.push_back(known.id[order[k]]);
        to.sheets.twine.insert(to.sheets.twine.end(), {u[k], v[k]});
      }
      to.sheets.height.push_back(surface_height(panel.width(), lambda * panel.mesh_size / 2));
      to.sheets.part.push_back(all[p].part);
    }
  }
}

}  // namespace

std::vector<std::array<int, 3>> row_facets(const std::vector<int>& row,
                                           const std::vector<double>& s) {
  std::vector<std::array<int, 3>> out;
  const int n = static_cast<int>(row.size());
  for (int begin = 0, middle, end; begin < n; begin = middle) {
    middle = begin;
    while (middle < n && row[middle] == row[begin]) ++middle;
    end = middle;
    while (end < n && row[end] == row[middle]) ++end;
    int upper = begin, lower = middle, last_upper = -1, last_lower = -1;
    while (middle < end && (upper < middle || lower < end)) {
      // For equal s the row that is behind comes first, so that facets mirror those of the other
      // side of the panel.
      const bool behind = last_lower < 0 || (last_upper >= 0 && s[last_upper] <= s[last_lower]);
      const bool from_upper = upper < middle && (lower == end || s[upper] < s[lower] ||
                                                 (s[upper] == s[lower] && behind));
      const int place = from_upper ? upper++ : lower++;
      if (last_upper >= 0 && last_lower >= 0) out.push_back({last_upper, last_lower, place});
      (from_upper ? last_upper : last_lower) = place;
    }
  }
  return out;
}

void add_bar_netting(Collection& to, const Gear& gear, const Division& division,
                     const Grouping& grouping, std::vector<DrawnPanel>& drawn) {
  std::vector<BarPanel> all;
  for (std::size_t p = 0; p < gear.panels.size(); ++p) {
    if (!gear.panels[p].bars) continue;
    BarPanel panel = bar_panel(gear.panels[p], grouping.lambda[p], grouping.segments[p]);
    panel.panel = static_cast<int>(p);
    panel.part = gear.rope_count + panel.panel;
    all.push_back(std::move(panel));
  }
  // Consecutive node numbers per panel: knots, then interior nodes of bars.
  for (BarPanel& panel : all) {
    for (const Point& point : panel.points) {
      panel.id.push_back(point.edge == inside ? to.nodes++ : -1);
    }
    for (std::size_t k = 0; k < panel.between.size(); ++k) panel.id.push_back(to.nodes++);
  }
  for (BarPanel& panel : all) {
    for (int edge = on_upper; edge <= on_right; ++edge) {
      for (std::size_t k = 0; k < panel.points.size(); ++k) {
        if (panel.points[k].edge != edge) continue;
        panel.id[k] =
            edge_point(to, division.edges, 4 * panel.panel + edge - 1, panel.points[k].fraction);
      }
    }
  }
  add_wake_sheets(to, gear, all);
  for (const BarPanel& panel : all) {
    const GearPanel& of = gear.panels[panel.panel];
    for (const Segment& bar : panel.bars) {
      for (const int end : {bar.first, bar.second}) {
        add_twine(to, of, panel.id[end], bar.rest * bar.multiplicity / 2, bar.rest);
      }
      const int first = panel.id[bar.first], second = panel.id[bar.second];
      if (first == second) continue;
      to.add_bar(first, second, bar.rest, bar.multiplicity, surface_height(of.width(), bar.rest),
                 panel.part, panel.part);
    }
  }
  for (const BarPanel& panel : all) {
    for (std::size_t k = 0; k < panel.points.size(); ++k) {
      add_knots(to, gear.panels[panel.panel], panel.part, panel.id[k], panel.points[k].knots);
    }
  }
  for (const BarPanel& panel : all) add_twists(to, panel);
  add_sheets(to, gear, division, all);
  for (const BarPanel& panel : all) {
    DrawnPanel& out = drawn[panel.panel];
    out.bars = true;
    out.lambda = panel.lambda;
    out.segments = panel.segments;
    for (const int node : panel.id) out.node.push_back(node < 0 ? node : node + 1);
    for (const auto* points : {&panel.points, &panel.between}) {
      for (const Point& point : *points) {
        out.i.push_back(point.i);
        out.j.push_back(point.j);
      }
    }
  }
}

}  // namespace codend
