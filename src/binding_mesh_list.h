// A gear's mesh for R, with what R takes of its lattice.
#pragma once

#include "binding_list.h"
#include "binding_model.h"
#include "engine/measure/frame.hpp"
#include "engine/measure/measured_gear.hpp"

namespace binding {

struct MeshReport {
  codend::Lattice lattice;

  template <class Visit>
  void fields(Visit& visit) {
    visit("nodes", lattice.nodes);
    visit.list("bar_part", lattice.bar_part, {1, codend::Among::parts});
    visit.list("cell_part", lattice.cell_part, {1, codend::Among::parts});
    visit.list("sphere_part", lattice.sphere_part, {1, codend::Among::parts});
    visit.list("lift_part", lattice.lift_part, {1, codend::Among::parts});
    visit.group("sheets", lattice.sheets);
    visit.group("on_cell", lattice.on_cell);
    visit.group("on_sheet", lattice.on_sheet);
    visit.list("bag_cell", lattice.bag.cell, {1, codend::Among::elements});
    visit("encloses", lattice.bag.encloses);
    visit.group("division", lattice.division);
    visit.group("counts", lattice.counts);
    visit.items("panels", lattice.panels);
    visit.list("twine", lattice.twine);
    visit.list("start", lattice.start);
    visit.list("hung", lattice.hung);
  }
};

// list(mesh, and what a MeshReport has). blocked: meshes of a bag behind its front; wake: of every
// point, or empty.
inline list mesh_list(const codend::Gear& gear, const codend::GearModel& numbers,
                      codend::Lattice&& lattice, double blocked, const std::vector<double>& wake) {
  HeldMesh held;
  held.model = codend::model_of(gear, lattice, numbers);
  held.model.wake = wake;
  held.frame = codend::measure_frame(gear, lattice);
  if (gear.has_bag) {
    held.bag = codend::filled_bag(lattice, blocked);
    codend::press(held.bag, held.model);
  }
  MeshReport report{std::move(lattice)};
  writable::list out(ListWriter::written(report));
  out.push_back("mesh"_nm = mesh_handle(std::move(held)));
  return out;
}

}  // namespace binding
