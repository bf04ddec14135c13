#include "gear_model.hpp"

#include "carry_strains.hpp"

namespace codend {

Model model_of(const Gear& gear, const Mesh& mesh, const GearModel& numbers) {
  Model out;
  out.nodes = mesh.nodes;
  out.held = mesh.held;
  for (std::size_t k = 0; k < mesh.ties.share.size(); ++k) {
    out.ties.push_back({mesh.ties.first[k], mesh.ties.second[k], mesh.ties.share[k]});
  }
  out.water = numbers.water;
  out.ground = numbers.ground;
  out.slack = numbers.slack;
  out.load = mesh.load;
  out.mass = mesh.mass;
  out.materials = numbers.materials;
  out.load_table = numbers.load_table;
  out.multipliers = numbers.multipliers;
  out.bars = mesh.bars;
  mesh.cells.divide(out.cells, out.hexagons, out.hexagonal);
  out.spheres = mesh.spheres;
  out.lifts = mesh.lifts;
  out.screens = mesh.screens;
  out.blended.node = mesh.blended.node;
  out.blended.twine = mesh.blended.twine;
  out.blended.rest = mesh.blended.rest;
  out.blended.multiplicity = mesh.blended.multiplicity;
  out.blended.height = mesh.blended.height;
  out.blended.overlap = mesh.blended.overlap;
  out.blended.material = mesh.blended.material;
  if (!mesh.blended.material.empty()) out.blended.materials = numbers.blended;
  out.openings = mesh.openings;
  out.bends = mesh.bends;
  out.twists = mesh.twists;
  out.plates.plate = numbers.plates;
  for (std::size_t p = 0; p < gear.plates.size(); ++p) {
    for (int k = 0; k < 3; ++k) {
      out.plates.plate[p].node[k] = mesh.division.places[gear.plates[p].points[k]];
    }
  }
  for (const SlidingBars& rope : mesh.sliding) {
    out.sliding.emplace_back();
    out.sliding.back().bar = rope.bar;
    out.sliding.back().axial_stiffness = rope.axial_stiffness;
    out.sliding.back().bend = rope.diameter;
  }
  out.contacts = mesh.contacts;
  out.contacts.lines = mesh.line_friction;
  out.volumes = mesh.volumes;
  out.wake_sheets = mesh.wake_sheets;
  out.pressure.drag_coefficient = numbers.drag_coefficient;
  return out;
}

std::vector<int> line_parts(const Mesh& mesh) {
  const std::vector<int>& cells = mesh.cell_part;
  return in_line_order(mesh.cells.straight, mesh.bar_part, cells, cells, cells);
}

}  // namespace codend
