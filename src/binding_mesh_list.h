// A gear's mesh for R, with what R and measures take of its lattice.
#pragma once

#include "binding_list.h"
#include "binding_model.h"
#include "engine/measure/frame.hpp"
#include "engine/measure/measured_gear.hpp"

namespace binding {

struct MeshReport {
  codend::Lattice lattice;
  codend::MeasureFrame frame;

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
    visit.group("bag", lattice.bag);
    visit.group("division", lattice.division);
    visit.group("counts", lattice.counts);
    visit.items("panels", lattice.panels);
    visit.list("twine", lattice.twine);
    visit.list("start", lattice.start);
    visit.list("hung", lattice.hung);
    visit.group("frame", frame);
  }
};

// list(mesh, and what a MeshReport has). blocked: meshes of a bag behind its front; wake: of every
// point, or empty.
inline list mesh_list(const codend::Gear& gear, const codend::GearModel& numbers,
                      codend::Lattice&& lattice, double blocked, const std::vector<double>& wake) {
  codend::Model model = codend::model_of(gear, lattice, numbers);
  if (gear.has_bag) codend::press(codend::filled_bag(lattice, blocked), model);
  model.wake = wake;
  MeshReport report{std::move(lattice), {}};
  report.frame = codend::measure_frame(gear, report.lattice);
  writable::list out(ListWriter::written(report));
  out.push_back("mesh"_nm = mesh_handle(std::move(model)));
  return out;
}

}  // namespace binding
