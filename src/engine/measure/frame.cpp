#include "frame.hpp"

#include <algorithm>
#include <cmath>

namespace codend {

namespace {

// Fraction of a rope's length within which a location is at a node.
constexpr double at_node = 1e-9;

void add_between(const NodeRun& rope, double share, MeasureFrame& out) {
  const auto after = std::upper_bound(rope.at.begin() + 1, rope.at.end() - 1, share + at_node);
  const std::size_t k = static_cast<std::size_t>(after - rope.at.begin()) - 1;
  const double weight = (share - rope.at[k]) / (rope.at[k + 1] - rope.at[k]);
  out.places.push_back(rope.node[k]);
  out.next_places.push_back(rope.node[k + 1]);
  out.next_weights.push_back(std::abs(weight) > at_node ? weight : 0.0);
}

// Adds the nodes of all locations, in the order of Division::places.
void add_places(const Gear& gear, const Division& division, MeasureFrame& out) {
  const std::size_t before_ropes =
      division.places.size() - gear.share_places.size() - 3 * division.ropes.size();
  const auto add_node = [&](int node) {
    out.places.push_back(node);
    out.next_places.push_back(node);
    out.next_weights.push_back(0.0);
  };
  for (std::size_t k = 0; k < before_ropes; ++k) add_node(division.places[k]);
  for (const NodeRun& rope : division.ropes) {
    add_node(rope.node.front());
    add_between(rope, 0.5, out);
    add_node(rope.node.back());
  }
  for (const SharePlace& place : gear.share_places) {
    add_between(division.ropes[place.rope], place.share, out);
  }
}

}  // namespace

MeasureFrame measure_frame(const Gear& gear, const Mesh& mesh) {
  MeasureFrame out;
  const Division& division = mesh.division;
  out.nodes = mesh.nodes;
  out.points = static_cast<int>(mesh.mass.size());
  out.parts = gear.parts();
  out.panel_count = gear.panel_count;
  add_places(gear, division, out);
  for (int p = 0; p < gear.point_count; ++p) {
    if (gear.points[p].held) out.supports.push_back(division.places[p]);
  }
  for (const Division::Held& edge : division.held_edges) {
    if (edge.node.size() > 2) {
      out.supports.insert(out.supports.end(), edge.node.begin() + 1, edge.node.end() - 1);
    }
  }
  out.part.bars = mesh.bar_part;
  out.part.cells = mesh.cell_part;
  out.part.spheres = mesh.sphere_part;
  out.part.lifts = mesh.lift_part;
  const int before = gear.rope_count + gear.panel_count + static_cast<int>(gear.pieces.size());
  for (std::size_t k = 0; k < gear.plates.size(); ++k) {
    out.part.plates.push_back(before + static_cast<int>(k));
  }
  const auto whole = [&](const std::vector<int>& on_cell, const std::vector<int>& on_sheet) {
    std::vector<int> part;
    for (const int cell : on_cell) part.push_back(mesh.cell_part[cell]);
    for (const int sheet : on_sheet) part.push_back(mesh.sheets.part[sheet]);
    return part;
  };
  out.part.screens = whole(mesh.on_cell.screens, mesh.on_sheet.screens);
  out.part.blended = whole(mesh.on_cell.blended, mesh.on_sheet.blended);
  for (int r = 0; r < gear.rope_count; ++r) {
    const GearRope& rope = gear.ropes[r];
    out.ropes.push_back(
        {division.ropes[r].node, rope.mass_per_length, rope.volume_per_length, rope.strut});
  }
  for (const GearSeam& seam : gear.seams) {
    SeamFrame joined;
    for (const Chain& chain : seam.chains) {
      for (const Link& link : chain.links) joined.edge.push_back(link.edge);
    }
    joined.gathered = seam.gathered_at >= 0;
    out.seams.push_back(std::move(joined));
  }
  out.edges = division.edges;
  const CellList& cells = mesh.cells;
  out.cells.rest = cells.rest;
  out.cells.straight = cells.straight;
  for (std::size_t c = 0; c < cells.rest.size(); ++c) {
    const double* twine = &cells.twine[8 * c];
    const double u[4] = {twine[0], twine[2], twine[4], twine[6]};
    const double v[4] = {twine[1], twine[3], twine[5], twine[7]};
    out.cells.bars.push_back(cell_area(u, v) * cells.multiplicity[c]);
  }
  out.meshes = mesh_frame(gear, part_map(gear, division, mesh.nodes, mesh.panels));
  return out;
}

}  // namespace codend
