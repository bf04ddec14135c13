#include "mesh.hpp"

#include <algorithm>
#include <cmath>

#include "../base/names.hpp"
#include "../base/pi.hpp"
#include "bag.hpp"

namespace codend {

namespace {

// A cell or a sheet of netting.
struct Whole {
  int panel;
  const int* node;
  const double* twine;
  double height, multiplicity, bars;  // bars: number of one family
};

// Returns the cells, then the sheets, of the panels for which `some` is true.
template <class Some>
std::vector<Whole> whole_elements(const Gear& gear, const Mesh& mesh, Some some) {
  std::vector<Whole> out;
  const auto add = [&](int part, const int* node, const double* twine, double height,
                       double multiplicity) {
    const int panel = part - gear.rope_count;
    if (!some(gear.panels[panel])) return;
    double u[4], v[4];
    for (int k = 0; k < 4; ++k) {
      u[k] = twine[2 * k];
      v[k] = twine[2 * k + 1];
    }
    out.push_back({panel, node, twine, height, multiplicity, cell_area(u, v) * multiplicity});
  };
  for (std::size_t c = 0; c < mesh.cell_part.size(); ++c) {
    add(mesh.cell_part[c], &mesh.cells.node[4 * c], &mesh.cells.twine[8 * c], mesh.cells.height[c],
        mesh.cells.multiplicity[c]);
  }
  const Sheets& sheets = mesh.sheets;
  for (std::size_t c = 0; c < sheets.part.size(); ++c) {
    add(sheets.part[c], &sheets.node[4 * c], &sheets.twine[8 * c], sheets.height[c], 1.0);
  }
  return out;
}

double bar_length(const GearPanel& panel) { return panel.mesh_size / 2 - panel.straight_bar; }

void add_screens(const Gear& gear, Mesh& mesh) {
  NettingScreens& to = mesh.screens;
  for (const Whole& whole :
       whole_elements(gear, mesh, [](const GearPanel& panel) { return panel.screen(); })) {
    const GearPanel& panel = gear.panels[whole.panel];
    const double twine = whole.bars * panel.cell_twine() * panel.width();
    const double knots = whole.bars * (1 + (panel.straight_bar > 0));
    to.node.insert(to.node.end(), whole.node, whole.node + 4);
    to.twine.insert(to.twine.end(), whole.twine, whole.twine + 8);
    to.twine_area.push_back(twine + knots * pi / 4 * (panel.knot_diameter * panel.knot_diameter));
    to.overlap.push_back(panel.crossing_overlap());
    // The drag model's Reynolds number refers to one cylinder, also for parallel twines.
    to.diameter.push_back(panel.twine_diameter);
    to.height.push_back(whole.height);
    to.multiplicity.push_back(whole.multiplicity);
    to.law.push_back(by_name<NettingScreenLaw>(name_of(panel.drag), "drag"));
  }
}

void add_blended(const Gear& gear, Mesh& mesh) {
  BlendedCells& to = mesh.blended;
  const auto blended = [](const GearPanel& panel) { return panel.drag == NettingDrag::blended; };
  for (const Whole& whole : whole_elements(gear, mesh, blended)) {
    const GearPanel& panel = gear.panels[whole.panel];
    to.node.insert(to.node.end(), whole.node, whole.node + 4);
    to.twine.insert(to.twine.end(), whole.twine, whole.twine + 8);
    to.rest.push_back(bar_length(panel));
    to.multiplicity.push_back(whole.multiplicity);
    to.height.push_back(whole.height);
    to.overlap.push_back(panel.crossing_overlap());
    to.material.push_back(whole.panel);
  }
}

// Twine coordinates are in m. For netting of bars the sheets between bars carry the couples of
// knots.
void add_openings(const Gear& gear, Mesh& mesh) {
  MeshOpenings& to = mesh.openings;
  const auto stiff = [](const GearPanel& panel) { return panel.stiff; };
  for (const Whole& whole : whole_elements(gear, mesh, stiff)) {
    const GearPanel& panel = gear.panels[whole.panel];
    const double rest = bar_length(panel);
    to.node.insert(to.node.end(), whole.node, whole.node + 4);
    for (int k = 0; k < 8; ++k) to.twine.push_back(whole.twine[k] * rest);
    to.couple.push_back(panel.opening_couple);
    to.angle.push_back(panel.opening_angle);
    to.multiplicity.push_back(whole.multiplicity / (rest * rest));
  }
}

WholeDrag whole_drag(const Gear& gear, const std::vector<int>& part) {
  WholeDrag out;
  for (std::size_t k = 0; k < part.size(); ++k) {
    const GearPanel& panel = gear.panels[part[k] - gear.rope_count];
    if (panel.screen()) out.screens.push_back(static_cast<int>(k));
    if (panel.drag == NettingDrag::blended) out.blended.push_back(static_cast<int>(k));
  }
  return out;
}

// Twine length (m) of every panel in bars and cells.
std::vector<double> panel_twine(const Gear& gear, const Mesh& mesh) {
  std::vector<double> in_bars(gear.panels.size(), 0.0), in_cells = in_bars;
  for (std::size_t b = 0; b < mesh.bar_part.size(); ++b) {
    const int panel = mesh.bar_part[b] - gear.rope_count;
    if (panel < 0 || panel >= gear.panel_count) continue;
    in_bars[panel] += mesh.bars.rest[b] * mesh.bars.multiplicity[b];
  }
  for (std::size_t c = 0; c < mesh.cell_part.size(); ++c) {
    const double* twine = &mesh.cells.twine[8 * c];
    const double u[4] = {twine[0], twine[2], twine[4], twine[6]};
    const double v[4] = {twine[1], twine[3], twine[5], twine[7]};
    in_cells[mesh.cell_part[c] - gear.rope_count] +=
        cell_area(u, v) * mesh.cells.multiplicity[c] *
        (2 * mesh.cells.rest[c] + mesh.cells.straight[c]);
  }
  for (std::size_t p = 0; p < in_bars.size(); ++p) in_bars[p] += in_cells[p];
  return in_bars;
}

// Sets masses of all points, and loads with weight minus buoyancy.
void add_masses(const Gear& gear, const Supports& supports, const std::vector<Mass>& masses,
                Mesh& mesh) {
  const std::size_t points = static_cast<std::size_t>(mesh.nodes) + mesh.ties.share.size();
  mesh.mass.assign(points, 0.0);
  std::vector<double> volume(points, 0.0);
  for (const Mass& mass : masses) {
    mesh.mass[mass.node] += mass.mass;
    volume[mass.node] += mass.volume;
  }
  mesh.load = supports.load;
  mesh.load.resize(3 * points, 0.0);
  for (std::size_t p = 0; p < points; ++p) {
    mesh.load[3 * p + 2] -= gravity * (mesh.mass[p] - gear.density * volume[p]);
  }
}

struct Edges {
  ChainTable chains;
  EdgePieces pieces;
  std::vector<char> bars;
};
Edges gear_edges(const Gear& gear) {
  Edges out;
  std::vector<char> linked;
  for (const GearPanel& panel : gear.panels) {
    out.bars.push_back(panel.bars);
    linked.push_back(!panel.bars);
  }
  out.chains = chain_table(gear);
  out.pieces = edge_pieces(out.chains, edge_breaks(out.chains, linked), linked);
  return out;
}

}  // namespace

NodeCounts count_nodes(const Gear& gear, double nodes) {
  const Edges edges = gear_edges(gear);
  const Resolution resolution(gear, edges.pieces);
  return {resolution.node_counts(resolution.element_length(nodes)), resolution.is_divided()};
}

void place_inner_nodes(const CellList& cells, std::vector<double>& position) {
  for (std::size_t c = 0; c < cells.inner.size(); ++c) {
    if (cells.inner[c] < 0) continue;
    const double* twine = &cells.twine[8 * c];
    const int* node = &cells.node[4 * c];
    const double u2 = twine[2] - twine[0], v2 = twine[3] - twine[1];
    const double u3 = twine[4] - twine[0], v3 = twine[5] - twine[1];
    const double d = u2 * v3 - u3 * v2;
    const Vector first = at(position.data(), node[0]), second = at(position.data(), node[1]),
                 third = at(position.data(), node[2]);
    // e_u + e_v
    const Vector both = (second - first) * ((v3 - u3) / d) + (third - first) * ((u2 - v2) / d);
    const double share = cells.straight[c] / (cells.straight[c] + cells.rest[c]) / 2;
    at(position.data(), cells.inner[c]) = (first + second + third) / 3 + both * share;
  }
}

Mesh build_mesh(const Gear& gear, const Fineness& fineness, const FromShape& from,
                const LayOut& lay_out) {
  gear.check();
  Mesh out;
  const Edges edges = gear_edges(gear);
  if (fineness.counts) {
    out.counts = *fineness.counts;
    if (static_cast<int>(out.counts.pieces.size()) != edges.pieces.count() ||
        out.counts.ropes.size() != gear.ropes.size() ||
        out.counts.grouping.lambda.size() != gear.panels.size()) {
      throw InputError("counts", "counts belong to another gear");
    }
  } else {
    const Resolution resolution(gear, edges.pieces);
    out.counts = resolution.counts(resolution.element_length(fineness.nodes));
  }
  out.division =
      divide(gear, edges.chains, edges.pieces, out.counts.pieces, out.counts.ropes, edges.bars);

  Collection all;
  all.nodes = out.division.nodes;
  add_ropes(all, gear, out.division);
  out.panels = add_netting(all, gear, out.division, out.counts.grouping);
  add_pieces(all, gear, out.division);
  add_plates(all, gear, out.division);
  all.number_ties();
  out.nodes = all.nodes;
  out.ties = std::move(all.ties);
  out.bars = std::move(all.bars);
  out.cells = std::move(all.cells);
  out.spheres = std::move(all.spheres);
  out.lifts = std::move(all.lifts);
  out.wake_sheets = std::move(all.wake_sheets);
  out.sheets = std::move(all.sheets);
  out.twists = std::move(all.twists);
  out.bar_part = std::move(all.bar_part);
  out.cell_part = std::move(all.cell_part);
  out.sphere_part = std::move(all.sphere_part);
  out.lift_part = std::move(all.lift_part);

  const Supports supports = gear_supports(gear, out.division);
  out.held = supports.held;
  out.held.resize(static_cast<std::size_t>(out.nodes), 0);
  add_masses(gear, supports, all.masses, out);
  add_weights(gear, out.division, out.load);
  const int points = static_cast<int>(out.mass.size());
  if (gear.has_ground) {
    out.contacts = ground_contacts(all.masses, points);
    out.line_friction = line_friction(gear, out.division);
  }
  out.volumes = immersed_volumes(all.masses, points, gear.density);
  out.bends = rope_bends(gear, out.division);
  for (int r = 0; r < gear.rope_count; ++r) {
    if (gear.ropes[r].through.empty()) continue;
    SlidingBars rope;
    rope.axial_stiffness = gear.ropes[r].axial_stiffness;
    rope.diameter = gear.ropes[r].diameter;
    for (std::size_t b = 0; b < out.bar_part.size(); ++b) {
      if (out.bar_part[b] == r) rope.bar.push_back(static_cast<int>(b));
    }
    out.sliding.push_back(std::move(rope));
  }
  out.on_cell = whole_drag(gear, out.cell_part);
  out.on_sheet = whole_drag(gear, out.sheets.part);
  add_screens(gear, out);
  add_blended(gear, out);
  add_openings(gear, out);
  out.twine = panel_twine(gear, out);

  const PartMap map = part_map(gear, out.division, out.nodes, out.panels);
  const std::vector<int> at_points(map.points);
  if (!from.given) {
    out.start = first_shape(gear, map, false, lay_out);
    if (gear.has_ground) lay_on_ground(gear, at_points, out.start);
  } else if (from.alike) {
    out.start = from.position;
    if (out.start.size() < 3 * static_cast<std::size_t>(out.nodes)) {
      throw InputError("from", "from belongs to another mesh");
    }
    out.start.resize(3 * static_cast<std::size_t>(out.nodes));
  } else {
    from.map.check(gear, from.position.size() / 3);
    out.start = carry_positions(gear, map, from.map, from.position);
  }
  for (int k = 0; k < out.division.nodes; ++k) {
    if (supports.held[k]) at(out.start.data(), k) = at(supports.position.data(), k);
  }
  if (gear.has_bag) {
    out.bag = bag_triangles(gear, out);
    if (!from.given) round_bag(gear, out.held, out.bag, out.start);
  }
  if (!from.alike) place_inner_nodes(out.cells, out.start);
  if (gear.shot_along >= 0) {
    out.hung = first_shape(gear, map, true, lay_out);
    place_inner_nodes(out.cells, out.hung);
  }
  return out;
}

}  // namespace codend
