#include "netting.hpp"

#include <cmath>

#include "../base/pi.hpp"

namespace codend {

double cell_area(const double* u, const double* v) {
  return std::abs((u[2] - u[0]) * (v[3] - v[1]) - (u[3] - u[1]) * (v[2] - v[0])) / 2;
}

double triangle_area(const double* u, const double* v, int a, int b, int c) {
  return std::abs((u[b] - u[a]) * (v[c] - v[a]) - (u[c] - u[a]) * (v[b] - v[a])) / 2;
}

std::vector<HalfCell> half_cells(const std::vector<int>& cells, const std::vector<int>& side) {
  std::vector<HalfCell> out;
  for (int half = 0; half < 4; ++half) {
    for (const int c : cells) {
      if (half < 2 ? side[c] > 0 : side[c] < 0) continue;
      out.push_back({c, corner_triangles[half], side[c] == 0 ? 0.5 : 1.0});
    }
  }
  return out;
}

void add_knots(Collection& to, const GearPanel& panel, int part, int node, double count) {
  const double d = panel.knot_diameter;
  if (d <= 0.0) return;
  const int joins = 1 + (panel.straight_bar > 0);
  const double twine = count * (panel.knot_twine / joins);
  const double height = surface_height(d, panel.mesh_size * std::sqrt(count));
  to.masses.push_back(
      {node, twine * panel.mass_per_length, twine * panel.volume_per_length, d, height, 0.0});
  // A screen's drag already includes its knots.
  const double drags = panel.screen() ? 0.0 : panel.knot_drag;
  to.add_sphere(node, pi / 4 * (d * d) * count * drags, d, false,
                0.5 * pi / 6 * std::pow(d, 3.0) * count, height, part);
}

void add_twine(Collection& to, const GearPanel& panel, int node, double length, double extent) {
  const double width = panel.width();
  to.masses.push_back({node, length * panel.mass_per_length, length * panel.volume_per_length,
                       width, surface_height(width, extent), length * width});
}

std::vector<DrawnPanel> add_netting(Collection& to, const Gear& gear, const Division& division,
                                    const Grouping& grouping) {
  std::vector<DrawnPanel> drawn(gear.panels.size());
  add_bar_netting(to, gear, division, grouping, drawn);
  add_cell_netting(to, gear, division, drawn);
  return drawn;
}

namespace {

struct Cell {
  int panel, place;       // index of the upper left corner in the panel's grid
  std::array<int, 4> at;  // indices of the corners in the grid
  std::array<double, 4> u, v;
  double multiplicity, bars;
  int side;
  int inner = -1;
  double extent = 0.0;  // side of a square with the same stretched netting, m

  bool pointed() const { return at[2] == at[3]; }
  double wide(int p, int q) const {
    return (u[p] - u[q]) * (u[p] - u[q]) + (v[p] - v[q]) * (v[p] - v[q]);
  }
  template <class Value>
  static void turn(std::array<Value, 4>& x) {
    x = {x[2], x[3], x[0], x[1]};
  }
  // Makes coincident corners (tip of a panel) the last two.
  void gather() {
    const double longest = std::max({wide(0, 1), wide(1, 2), wide(2, 3), wide(3, 0)});
    if (wide(0, 1) < 1e-18 * longest) {
      turn(u);
      turn(v);
      turn(at);
    }
    if (wide(2, 3) < 1e-18 * longest) {
      u[3] = u[2];
      v[3] = v[2];
      at[3] = at[2];
    }
  }
};

// Returns the cells of a panel with nodes at these fractions across and deep.
std::vector<Cell> panel_cells(const GearPanel& panel, int number, const double* across, int columns,
                              const double* deep, int rows) {
  std::vector<double> u, v;
  // The straight bars of turned hexagons run between the twines in the opposite direction.
  const int way = panel.orientation == MeshOrientation::hexagonal_turned ? -1 : 1;
  for (int row = 0; row < rows; ++row) {
    const double j = deep[row] * panel.deep, left = panel.left(j);
    for (int column = 0; column < columns; ++column) {
      const double i = left + across[column] * (panel.right(j) - left);
      u.push_back(panel.square() ? i : i + j);
      v.push_back((panel.square() ? j : j - i) * way);
    }
  }
  std::vector<int> whole, side;
  std::vector<std::array<int, 4>> corner;
  for (int row = 0; row + 1 < rows; ++row) {
    for (int column = 0; column + 1 < columns; ++column) {
      const int a = row * columns + column, below = a + columns;
      const int off = 2 * (column + 1) - columns;
      whole.push_back(static_cast<int>(whole.size()));
      side.push_back((off > 0) - (off < 0));
      corner.push_back({a, a + 1, below + 1, below});
    }
  }
  std::vector<Cell> out;
  double largest = 0.0;
  const auto add = [&](int c, std::array<int, 4> of, double multiplicity) {
    Cell cell;
    cell.panel = number;
    cell.place = corner[c][0];
    for (int k = 0; k < 4; ++k) {
      cell.at[k] = corner[c][of[k]];
      cell.u[k] = u[cell.at[k]];
      cell.v[k] = v[cell.at[k]];
    }
    cell.multiplicity = multiplicity;
    cell.side = side[c];
    cell.gather();
    cell.bars = cell_area(cell.u.data(), cell.v.data()) * multiplicity;
    largest = std::max(largest, cell.bars);
    out.push_back(cell);
  };
  if (panel.straight_bar > 0) {
    for (const HalfCell& half : half_cells(whole, side)) {
      const int* of = half.corner;
      add(half.cell, {of[0], of[1], of[2], of[2]}, half.weight);
    }
  } else {
    for (const int c : whole) add(c, {0, 1, 2, 3}, 1.0);
  }
  out.erase(std::remove_if(out.begin(), out.end(),
                           [&](const Cell& cell) { return !(cell.bars > 1e-9 * largest); }),
            out.end());
  return out;
}

// Fractions of an evenly distributed load at the corners: mean of both diagonals, equal fractions
// within each triangle (cell_shape.hpp).
std::array<double, 4> corner_shares(const Cell& cell) {
  const double whole = cell_area(cell.u.data(), cell.v.data());
  std::array<double, 4> share = {0.0, 0.0, 0.0, 0.0};
  for (const auto& t : corner_triangles) {
    const double of = triangle_area(cell.u.data(), cell.v.data(), t[0], t[1], t[2]) / (6 * whole);
    for (const int k : t) share[k] += of;
  }
  return share;
}

}  // namespace

void add_cell_netting(Collection& to, const Gear& gear, const Division& division,
                      std::vector<DrawnPanel>& drawn) {
  const auto part_of = [&](int panel) { return gear.rope_count + panel; };
  const auto node_of = [&](const Cell& cell, int k) {
    return division.grids[cell.panel].node[cell.at[k]];
  };
  std::vector<Cell> cells;
  for (std::size_t p = 0; p < gear.panels.size(); ++p) {
    if (gear.panels[p].bars) continue;
    const EdgeNodes& edges = division.edges;
    const std::vector<Cell> found = panel_cells(
        gear.panels[p], static_cast<int>(p), &edges.fraction[edges.before[4 * p]],
        edges.count[4 * p], &edges.fraction[edges.before[4 * p + 2]], edges.count[4 * p + 2]);
    for (const Cell& cell : found) drawn[p].cell.push_back(cell.place + 1);
    cells.insert(cells.end(), found.begin(), found.end());
  }
  std::vector<int> hexagonal, pointed_sheets, whole_sheets, side;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    Cell& cell = cells[c];
    const GearPanel& panel = gear.panels[cell.panel];
    const double rest = panel.mesh_size / 2 - panel.straight_bar;
    if (panel.straight_bar > 0) {
      cell.inner = to.nodes++;
      hexagonal.push_back(static_cast<int>(c));
    }
    cell.extent = (rest + panel.straight_bar) *
                  std::sqrt((1 + cell.pointed()) * cell.bars / cell.multiplicity);
    for (int k = 0; k < 4; ++k) {
      to.cells.node.push_back(node_of(cell, k));
      to.cells.twine.insert(to.cells.twine.end(), {cell.u[k], cell.v[k]});
    }
    to.cells.rest.push_back(rest);
    to.cells.straight.push_back(panel.straight_bar);
    to.cells.inner.push_back(cell.inner);
    to.cells.multiplicity.push_back(cell.multiplicity);
    to.cells.height.push_back(surface_height(panel.width(), cell.extent));
    to.cells.material.push_back(part_of(cell.panel));
    to.cell_part.push_back(part_of(cell.panel));
    side.push_back(cell.side);
    if (panel.shielding != WakeLaw::none) {
      (cell.pointed() ? pointed_sheets : whole_sheets).push_back(static_cast<int>(c));
    }
  }

  // Wake sheets are triangles, divided as in hexagonal netting.
  const auto add_sheet = [&](int c, const int* corner, double weight) {
    const Cell& cell = cells[c];
    const GearPanel& panel = gear.panels[cell.panel];
    for (int k = 0; k < 3; ++k) to.wake_sheets.node.push_back(node_of(cell, corner[k]));
    const double bars =
        triangle_area(cell.u.data(), cell.v.data(), corner[0], corner[1], corner[2]) *
        (cell.multiplicity * weight);
    const double rest = panel.mesh_size / 2 - panel.straight_bar;
    to.wake_sheets.twine_area.push_back(bars * (2 * rest + panel.straight_bar) * panel.width());
    to.wake_sheets.overlap.push_back(panel.crossing_overlap());
    to.wake_sheets.law.push_back(panel.shielding);
  };
  for (const int c : pointed_sheets) add_sheet(c, corner_triangles[0], 1.0);
  for (const HalfCell& half : half_cells(whole_sheets, side)) {
    // The multiplicity of a quadrilateral cell is 1.
    add_sheet(half.cell, half.corner, half.weight);
  }

  struct Join {
    int panel, node;
    double bars;
  };
  std::vector<Join> joins;
  for (const Cell& cell : cells) {
    const std::array<double, 4> share = corner_shares(cell);
    for (int k = 0; k < 4; ++k) {
      if (!(share[k] > 0.0)) continue;
      const double bars = share[k] * cell.bars;
      // Half the twine of hexagonal netting, and one knot per unit cell, belong to the inner node.
      const GearPanel& panel = gear.panels[cell.panel];
      add_twine(to, panel, node_of(cell, k),
                bars * panel.cell_twine() * (1 - 0.5 * (cell.inner >= 0)), cell.extent);
      joins.push_back({cell.panel, node_of(cell, k), bars});
    }
  }
  for (const int c : hexagonal) {
    const GearPanel& panel = gear.panels[cells[c].panel];
    add_twine(to, panel, cells[c].inner, cells[c].bars / 2 * panel.cell_twine(), cells[c].extent);
  }
  for (const int c : hexagonal) {
    const GearPanel& panel = gear.panels[cells[c].panel];
    add_knots(to, panel, part_of(cells[c].panel), cells[c].inner, cells[c].bars);
  }
  // A node of two panels has knots of both.
  std::vector<Join> at_nodes;
  std::vector<int> known(static_cast<std::size_t>(to.nodes), -1);
  int panel = -1;
  for (const Join& join : joins) {
    if (gear.panels[join.panel].knot_diameter <= 0.0) continue;
    if (join.panel != panel) {
      panel = join.panel;
      std::fill(known.begin(), known.end(), -1);
    }
    int& place = known[join.node];
    if (place < 0) {
      place = static_cast<int>(at_nodes.size());
      at_nodes.push_back({join.panel, join.node, 0.0});
    }
    at_nodes[place].bars += join.bars;
  }
  for (const Join& join : at_nodes) {
    add_knots(to, gear.panels[join.panel], part_of(join.panel), join.node, join.bars);
  }
}

}  // namespace codend
