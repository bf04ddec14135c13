#include "gear_model.hpp"

#include "carry_strains.hpp"

namespace codend {

Model model_of(const Gear& gear, const Lattice& lattice, const GearModel& numbers) {
  Model out;
  out.nodes = lattice.nodes;
  out.held = lattice.held;
  for (std::size_t k = 0; k < lattice.ties.share.size(); ++k) {
    out.ties.push_back({lattice.ties.first[k], lattice.ties.second[k], lattice.ties.share[k]});
  }
  out.water = numbers.water;
  out.ground = numbers.ground;
  out.slack = numbers.slack;
  out.load = lattice.load;
  out.mass = lattice.mass;
  out.materials = numbers.materials;
  out.load_table = numbers.load_table;
  out.multipliers = numbers.multipliers;
  out.bars = lattice.bars;
  lattice.cells.divide(out.cells, out.hexagons, out.hexagonal);
  out.spheres = lattice.spheres;
  out.lifts = lattice.lifts;
  out.screens = lattice.screens;
  out.blended.node = lattice.blended.node;
  out.blended.twine = lattice.blended.twine;
  out.blended.rest = lattice.blended.rest;
  out.blended.multiplicity = lattice.blended.multiplicity;
  out.blended.height = lattice.blended.height;
  out.blended.overlap = lattice.blended.overlap;
  out.blended.material = lattice.blended.material;
  if (!lattice.blended.material.empty()) out.blended.materials = numbers.blended;
  out.openings = lattice.openings;
  out.bends = lattice.bends;
  out.plates.plate = numbers.plates;
  for (std::size_t p = 0; p < gear.plates.size(); ++p) {
    for (int k = 0; k < 3; ++k) {
      out.plates.plate[p].node[k] = lattice.division.places[gear.plates[p].points[k]];
    }
  }
  for (const SlidingBars& rope : lattice.sliding) {
    out.sliding.emplace_back();
    out.sliding.back().bar = rope.bar;
    out.sliding.back().axial_stiffness = rope.axial_stiffness;
  }
  out.contacts = lattice.contacts;
  out.contacts.lines = lattice.line_friction;
  out.volumes = lattice.volumes;
  out.wake_sheets = lattice.wake_sheets;
  out.pressure.drag_coefficient = numbers.drag_coefficient;
  return out;
}

std::vector<int> line_parts(const Lattice& lattice) {
  const std::vector<int>& cells = lattice.cell_part;
  return in_line_order(lattice.cells.straight, lattice.bar_part, cells, cells, cells);
}

}  // namespace codend
