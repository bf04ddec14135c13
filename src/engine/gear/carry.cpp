#include "carry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace codend {

PartMap part_map(const Gear& gear, const Division& division, int nodes,
                 const std::vector<DrawnPanel>& drawn) {
  return {nodes,          division.nodes,
          division.edges, division.grids,
          division.ropes, {division.places.begin(), division.places.begin() + gear.point_count},
          drawn};
}

void PartMap::check(const Gear& gear, std::size_t points_of_shape) const {
  const auto need = [](bool right, const char* name) {
    if (!right) throw InputError(name, std::string(name) + " do not match the parts of the gear");
  };
  const std::size_t panels_of_gear = gear.panels.size(), on_edges = edges.fraction.size();
  need(grids.size() == panels_of_gear && panels.size() == panels_of_gear, "panels");
  need(ropes.size() == gear.ropes.size(), "ropes");
  need(points.size() == gear.points.size(), "points");
  need(edges.edge_node.size() == on_edges && edges.count.size() == 4 * panels_of_gear &&
           edges.before.size() == edges.count.size(),
       "edges");
  std::size_t before = 0;
  for (std::size_t e = 0; e < edges.count.size(); ++e) {
    need(edges.count[e] >= 2 && static_cast<std::size_t>(edges.before[e]) == before, "edges");
    before += static_cast<std::size_t>(edges.count[e]);
  }
  need(before == on_edges, "edges");
  for (const NodeRun& rope : ropes) need(rope.node.size() >= 2, "ropes");
  need(static_cast<std::size_t>(nodes) <= points_of_shape, "nodes");
  for (std::size_t p = 0; p < panels_of_gear; ++p) {
    const std::size_t columns = static_cast<std::size_t>(edges.count[4 * p]);
    const std::size_t rows = static_cast<std::size_t>(edges.count[4 * p + 2]);
    need(panels[p].bars ||
             (grids[p].columns == edges.count[4 * p] && grids[p].node.size() == columns * rows),
         "grids");
    need(panels[p].i.size() == panels[p].node.size() && panels[p].j.size() == panels[p].i.size(),
         "panels");
    need(!panels[p].bars || panels[p].lambda > 0, "panels");
    for (const int node : panels[p].node) {
      need(node != 0 && point(node) >= 0 && static_cast<std::size_t>(point(node)) < points_of_shape,
           "panels");
    }
  }
}

namespace {

double clamped_share(double x, double low, double high) {
  return x >= high ? 1.0 : x <= low ? 0.0 : (x - low) / (high - low);
}

Between along_run(const NodeRun& run, double x) {
  const int past =
      static_cast<int>(std::upper_bound(run.at.begin(), run.at.end(), x) - run.at.begin());
  const int cell = std::min(std::max(past - 1, 0), static_cast<int>(run.at.size()) - 2);
  return {run.node[cell], run.node[cell + 1], clamped_share(x, run.at[cell], run.at[cell + 1])};
}

Between along_edge(const EdgeNodes& edges, int edge, double x) {
  const int cell = edges.cell_of(x, edge);
  return {edges.edge_node[cell], edges.edge_node[cell + 1],
          clamped_share(x, edges.fraction[cell], edges.fraction[cell + 1])};
}

}  // namespace

void add_grid_places(std::vector<PanelPlace>& out, const PartMap& map) {
  for (std::size_t p = 0; p < map.grids.size(); ++p) {
    const std::vector<int>& node = map.grids[p].node;
    const int columns = map.edges.count[4 * p];
    for (std::size_t k = 0; k < node.size(); ++k) {
      const int row = static_cast<int>(k) / columns, column = static_cast<int>(k) % columns;
      out.push_back({node[k], static_cast<int>(p),
                     map.edges.fraction[map.edges.before[4 * p] + column],
                     map.edges.fraction[map.edges.before[4 * p + 2] + row]});
    }
  }
}

PanelPlace bar_place(const Gear& gear, const PartMap& map, int p, std::size_t k) {
  const GearPanel& panel = gear.panels[p];
  const DrawnPanel& drawn = map.panels[p];
  const double left = panel.left(drawn.j[k]);
  const double width = std::max(panel.right(drawn.j[k]) - left, 1e-9);
  const double s = (drawn.i[k] - left) / width;
  return {map.point(drawn.node[k]), p, std::min(std::max(s, 0.0), 1.0), drawn.j[k] / panel.deep};
}

namespace {

struct RowPlace {
  int panel;
  double s, t;
  Between at;
};

// Adds the knots of a panel of bars that lie on its rows between the edges.
void add_inner_knots(std::vector<RowPlace>& out, const Gear& gear, const PartMap& map, int p,
                     int rows) {
  for (std::size_t k = 0; k < map.panels[p].node.size(); ++k) {
    const PanelPlace place = bar_place(gear, map, p, k);
    const double row = std::nearbyint(place.t * rows);
    if (!(std::abs(place.t * rows - row) < 1e-6 && row > 0 && row < rows)) continue;
    out.push_back({p, place.s, row / rows, {place.node, place.node, 0.0}});
  }
}

// Returns the neighbours of x among the values (0 to 1) of a group, and the fraction between them.
// groups and values are sorted; keys are 2 (group + 1) + value.
Beside neighbouring_values(int group, double x, const std::vector<int>& groups,
                           const std::vector<double>& values, const std::vector<double>& keys) {
  const double key = 2.0 * (group + 1) + x;
  int low = static_cast<int>(std::upper_bound(keys.begin(), keys.end(), key) - keys.begin()) - 1;
  low = std::max(low, static_cast<int>(std::lower_bound(groups.begin(), groups.end(), group) -
                                       groups.begin()));
  int high = std::min(low + 1, static_cast<int>(groups.size()) - 1);
  if (groups[high] != group) high = low;
  const double width = values[high] - values[low];
  const double share = (x - values[low]) / std::max(width, 1e-12);
  return {low, high, std::min(std::max(share, 0.0), 1.0)};
}
}  // namespace

PanelRows panel_rows(const Gear& gear, const PartMap& map) {
  std::vector<RowPlace> all;
  std::vector<PanelPlace> grid;
  add_grid_places(grid, map);
  for (const PanelPlace& place : grid) {
    all.push_back({place.panel, place.s, place.t, {place.node, place.node, 0.0}});
  }
  const auto each = [&](auto visit) {
    for (std::size_t p = 0; p < map.panels.size(); ++p) {
      if (!map.panels[p].bars) continue;
      const GearPanel& panel = gear.panels[p];
      visit(static_cast<int>(p),
            at_least_one(std::nearbyint((2 - panel.square()) * panel.deep / map.panels[p].lambda)));
    }
  };
  each([&](int p, int rows) { add_inner_knots(all, gear, map, p, rows); });
  // The ends of rows on the left and right edges, then all nodes of the upper and lower edges.
  for (int side = 2; side < 4; ++side) {
    each([&](int p, int rows) {
      for (int row = 1; row < rows; ++row) {
        const double t = static_cast<double>(row) / rows;
        all.push_back({p, side - 2.0, t, along_edge(map.edges, 4 * p + side, t)});
      }
    });
  }
  for (int side = 0; side < 2; ++side) {
    each([&](int p, int) {
      const int edge = 4 * p + side;
      for (int k = map.edges.before[edge]; k < map.edges.before[edge] + map.edges.count[edge];
           ++k) {
        const int node = map.edges.edge_node[k];
        all.push_back({p, map.edges.fraction[k], static_cast<double>(side), {node, node, 0.0}});
      }
    });
  }
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const RowPlace &x = all[a], &y = all[b];
    if (x.panel != y.panel) return x.panel < y.panel;
    return x.t != y.t ? x.t < y.t : x.s < y.s;
  });
  PanelRows out;
  double last = 0.0;
  for (const std::size_t k : order) {
    const RowPlace& place = all[k];
    const double key = 2.0 * (place.panel + 1) + place.t;
    if (out.row.empty() || key - last > 1e-9) {
      out.add_row(place.panel, place.t);
    }
    last = key;
    out.add_place(place.s);
    out.at.push_back(place.at);
  }
  return out;
}

void PlaceRows::add_row(int of_group, double deep) {
  group.push_back(of_group);
  t.push_back(deep);
  t_key.push_back(2.0 * (of_group + 1) + deep);
}

void PlaceRows::add_place(double across) {
  row.push_back(static_cast<int>(t.size()) - 1);
  s.push_back(across);
  s_key.push_back(2.0 * (row.back() + 1) + across);
}

Beside PlaceRows::neighbouring_rows(int of_group, double deep) const {
  return neighbouring_values(of_group, deep, group, t, t_key);
}

Beside PlaceRows::beside(int of_row, double across) const {
  return neighbouring_values(of_row, across, row, s, s_key);
}

std::vector<PanelPlace> panel_places(const Gear& gear, const PartMap& map) {
  std::vector<PanelPlace> out;
  add_grid_places(out, map);
  for (std::size_t p = 0; p < map.panels.size(); ++p) {
    if (!map.panels[p].bars) continue;
    for (int side = 0; side < 4; ++side) {
      const int edge = 4 * static_cast<int>(p) + side;
      for (int k = map.edges.before[edge]; k < map.edges.before[edge] + map.edges.count[edge];
           ++k) {
        const double f = map.edges.fraction[k];
        out.push_back({map.edges.edge_node[k], static_cast<int>(p), side < 2 ? f : side - 2.0,
                       side < 2 ? static_cast<double>(side) : f});
      }
    }
  }
  for (std::size_t p = 0; p < map.panels.size(); ++p) {
    if (!map.panels[p].bars) continue;
    for (std::size_t k = 0; k < map.panels[p].node.size(); ++k) {
      // Interior nodes only, neither on edges nor tied.
      if (map.panels[p].node[k] > map.divided_nodes) {
        out.push_back(bar_place(gear, map, static_cast<int>(p), k));
        out.back().node = map.panels[p].node[k] - 1;
      }
    }
  }
  return out;
}

std::vector<double> carry_positions(const Gear& gear, const PartMap& to, const PartMap& from,
                                    const std::vector<double>& position) {
  std::vector<double> start(3 * static_cast<std::size_t>(to.nodes),
                            std::numeric_limits<double>::quiet_NaN());
  std::vector<char> inside(static_cast<std::size_t>(to.nodes), 0);
  for (std::size_t r = 0; r < to.ropes.size(); ++r) {
    const NodeRun& rope = to.ropes[r];
    for (std::size_t k = 0; k < rope.node.size(); ++k) {
      const Between place = along_run(from.ropes[r], rope.at[k]);
      at(start.data(), rope.node[k]) = place(position.data());
      if (place.from != place.to && place.share > 0 && place.share < 1) inside[rope.node[k]] = 1;
    }
  }
  const PanelRows rows = panel_rows(gear, from);
  const auto along = [&](int row, double s) -> Vector {
    const Beside on = rows.beside(row, s);
    const Vector low = rows.at[on.low](position.data());
    return low + (rows.at[on.high](position.data()) - low) * on.share;
  };
  for (const PanelPlace& place : panel_places(gear, to)) {
    const Beside on = rows.neighbouring_rows(place.panel, place.t);
    const Vector first = along(on.low, place.s);
    at(start.data(), place.node) = first + (along(on.high, place.s) - first) * on.share;
  }
  // Restores the position of points within a rope: with one bar the rope has no node there.
  for (std::size_t k = 0; k < to.points.size(); ++k) {
    if (!inside[to.points[k]]) {
      at(start.data(), to.points[k]) = at(position.data(), from.points[k]);
    }
  }
  return start;
}

}  // namespace codend
