#include "carry_strains.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

#include "sums.hpp"

namespace codend {

LineMap line_map(const Gear& gear, const Mesh& mesh) {
  return {gear.parts(),   mesh.bars.node, mesh.cells.node,    mesh.bar_part,
          mesh.cell_part, mesh.bars.rest, mesh.cells.straight};
}

void LineMap::check(const Gear& gear) const {
  const auto of_parts = [](const std::vector<int>& part, const std::vector<int>& node,
                           std::size_t width, const std::vector<double>& length) {
    return node.size() == width * part.size() && length.size() == part.size();
  };
  // A catch is a part without lines.
  if (part_count < gear.parts() - gear.has_bag || !of_parts(bar_part, bar_node, 2, bar_rest) ||
      !of_parts(cell_part, cell_node, 4, cell_straight)) {
    throw InputError("lines", "lines do not match the parts of the gear");
  }
}

namespace {

// Family of a rope, or first family of a panel's twine; the second family follows.
int family_of(int part) { return 2 * part + 1; }

// Positions of bars by the lengths of the preceding bars of their part.
void place_along_parts(const LineMap& lines, std::vector<LinePlace>& out) {
  std::map<int, long double> whole, begun;
  for (std::size_t b = 0; b < out.size(); ++b) whole[lines.bar_part[b]] += lines.bar_rest[b];
  for (std::size_t b = 0; b < out.size(); ++b) {
    const int part = lines.bar_part[b];
    const double end = static_cast<double>(begun[part] += lines.bar_rest[b]);
    out[b].s = (end - lines.bar_rest[b] / 2) / static_cast<double>(whole[part]);
    out[b].family = family_of(part);
  }
}

// Positions of netting bars by the positions of their ends in the panel.
void place_in_panels(const Gear& gear, const PartMap& map, const LineMap& lines,
                     std::vector<LinePlace>& out) {
  struct End {
    double s, t, i, j;
  };
  std::map<std::pair<int, int>, End> known;
  for (std::size_t p = 0; p < map.panels.size(); ++p) {
    const DrawnPanel& drawn = map.panels[p];
    for (std::size_t k = 0; drawn.bars && k < drawn.node.size(); ++k) {
      const PanelPlace place = bar_place(gear, map, static_cast<int>(p), k);
      known.insert({{place.panel, place.node}, {place.s, place.t, drawn.i[k], drawn.j[k]}});
    }
  }
  for (std::size_t b = 0; b < out.size(); ++b) {
    const int panel = lines.bar_part[b] - gear.rope_count;
    if (panel < 0 || panel >= gear.panel_count) continue;
    const auto from = known.find({panel, lines.bar_node[2 * b]});
    const auto to = known.find({panel, lines.bar_node[2 * b + 1]});
    if (from == known.end() || to == known.end()) continue;
    const End &first = from->second, &second = to->second;
    const double across = second.i - first.i, deep = second.j - first.j;
    out[b] = {family_of(lines.bar_part[b]) + (across * deep < 0 || across == 0),
              (first.s + second.s) / 2, (first.t + second.t) / 2};
  }
}

// Positions of cells by the mean of their corners.
std::vector<LinePlace> cell_places(const Gear& gear, const PartMap& map, const LineMap& lines) {
  std::vector<PanelPlace> grid;
  add_grid_places(grid, map);
  std::map<std::pair<int, int>, const PanelPlace*> known;
  for (const PanelPlace& place : grid) known.insert({{place.panel, place.node}, &place});
  std::vector<LinePlace> out;
  for (std::size_t c = 0; c < lines.cell_part.size(); ++c) {
    long double s = 0.0L, t = 0.0L;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto at =
          known.find({lines.cell_part[c] - gear.rope_count, lines.cell_node[4 * c + k]});
      if (at == known.end()) throw InputError("lines", "lines have cells outside of all grids");
      s += at->second->s;
      t += at->second->t;
    }
    out.push_back(
        {family_of(lines.cell_part[c]), static_cast<double>(s / 4), static_cast<double>(t / 4)});
  }
  return out;
}

}  // namespace

std::vector<LinePlace> line_places(const Gear& gear, const PartMap& map, const LineMap& lines) {
  std::vector<LinePlace> bars(lines.bar_part.size());
  place_along_parts(lines, bars);
  place_in_panels(gear, map, lines, bars);
  const std::vector<LinePlace> u = cell_places(gear, map, lines);
  const auto of_family = [&](int further) {
    std::vector<LinePlace> out = u;
    for (LinePlace& place : out) place.family += further;
    return out;
  };
  return in_line_order(lines.cell_straight, bars, u, of_family(1),
                       of_family(2 * (gear.rope_count + gear.panel_count)));
}

std::vector<double> carry_strains(const Gear& gear, const PartMap& to_map, const LineMap& to,
                                  const PartMap& from_map, const LineMap& from,
                                  const std::vector<double>& strain) {
  if (to.alike(from)) return strain;
  const std::vector<LinePlace> old = line_places(gear, from_map, from);
  // Lines form a row if their middles have the same depth.
  std::vector<double> deep;
  for (const LinePlace& place : old) deep.push_back(std::nearbyint(place.t * 1e6));
  std::vector<std::size_t> order(old.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::tie(old[a].family, deep[a], old[a].s) < std::tie(old[b].family, deep[b], old[b].s);
  });
  struct Row {
    std::size_t begin, end;
  };
  std::vector<Row> all;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool same = k > 0 && old[order[k]].family == old[order[k - 1]].family &&
                      deep[order[k]] == deep[order[k - 1]];
    if (!same) all.push_back({k, k});
    all.back().end = k + 1;
  }
  const auto reach = [&](const Row& row) {
    return old[order[row.end - 1]].s - old[order[row.begin]].s;
  };
  std::map<int, double> widest;
  for (const Row& row : all) {
    double& width = widest[old[order[row.begin]].family];
    width = std::max(width, reach(row));
  }
  // Skips rows less than half as wide as the widest: twines cut at the sides do not represent the
  // middle.
  PlaceRows rows;
  std::vector<double> value;
  for (const Row& row : all) {
    const std::size_t first = order[row.begin];
    if (reach(row) < widest[old[first].family] / 2) continue;
    rows.add_row(old[first].family, deep[first] / 1e6);
    for (std::size_t k = row.begin; k < row.end; ++k) {
      rows.add_place(old[order[k]].s);
      value.push_back(strain[order[k]]);
    }
  }
  const auto along = [&](int row, double s) {
    const Beside on = rows.beside(row, s);
    return value[on.low] + (value[on.high] - value[on.low]) * on.share;
  };
  std::vector<double> out;
  for (const LinePlace& place : line_places(gear, to_map, to)) {
    if (widest.count(place.family) == 0) {
      out.push_back(0.0);
      continue;
    }
    const Beside on = rows.neighbouring_rows(place.family, place.t);
    const double first = along(on.low, place.s);
    out.push_back(first + (along(on.high, place.s) - first) * on.share);
  }
  return out;
}

}  // namespace codend
