// R interface: measures of states.
#include <algorithm>
#include <cmath>
#include <map>

#include "binding_list.h"
#include "binding_model.h"
#include "engine/measure/measure_errors.hpp"

using namespace binding;

namespace {

// Reads tensions, forces and positions of a state.
codend::MeasuredShape<double> read_shape(const list& state) {
  codend::MeasuredShape<double> out;
  out.position = numbers(state, "position");
  out.velocity = numbers(state, "velocity");
  out.force = numbers(state, "force");
  out.bar_tension = numbers(state, "bar_tension");
  out.u_tension = numbers(state, "u_tension");
  out.v_tension = numbers(state, "v_tension");
  out.straight_tension = numbers(state, "straight_tension");
  const list forces(state["forces"]), plates(state["boards"]);
  for (const codend::ReportedForce& force : codend::reported_forces()) {
    out.forces.push_back(numbers(forces, force.name));
  }
  out.attack = numbers(plates, "attack");
  out.heel = numbers(plates, "heel");
  out.trim = numbers(plates, "trim");
  return out;
}

}  // namespace

// Returns measures in SI units; NaN if the gear lacks a measure. questions: see measures.hpp;
// state: positions, velocities, tensions and forces.
[[cpp11::register]] doubles engine_measures(SEXP handle, list questions, list state) {
  return guarded([&]() -> doubles {
    const HeldModel& held = held_model(handle);
    return as_doubles(codend::measure(held.frame, read_model(handle),
                                      codend::read_fields<codend::Questions>(ListSource(questions)),
                                      held.catch_bag(), read_shape(state)));
  });
}

// Returns standard errors (SI) of measures on the first of several meshes (measure_errors.hpp); NA
// if the other meshes provide no information. `nodes`: of every mesh. `values`: measures in SI, all
// of the first mesh, then all of the next.
[[cpp11::register]] doubles engine_measure_errors(strings kinds, doubles nodes, doubles values,
                                                  double tolerance, double step_accuracy) {
  return guarded([&]() -> doubles {
    std::vector<codend::MeasureKind> of;
    for (const std::string kind : kinds) {
      of.push_back(codend::by_name<codend::MeasureKind>(kind, "kinds"));
    }
    std::vector<codend::MeasuredMesh> meshes;
    const double* next = REAL(values);
    for (const double count : nodes) {
      meshes.push_back({count, std::vector<double>(next, next + of.size())});
      next += of.size();
    }
    writable::doubles errors = as_doubles(codend::measure_errors(
        of, meshes[0], {meshes.begin() + 1, meshes.end()}, tolerance, step_accuracy));
    std::replace_if(
        errors.begin(), errors.end(), [](double error) { return std::isnan(error); }, NA_REAL);
    return errors;
  });
}

// Returns hydrodynamic forces on every part, 3 each, N.
[[cpp11::register]] doubles engine_part_forces(SEXP handle, list state) {
  return guarded([&]() -> doubles {
    return as_doubles(codend::part_forces(held_model(handle).frame, read_shape(state)));
  });
}

// Returns tensions at both ends of bars of ropes, 2 each, N.
[[cpp11::register]] doubles engine_end_tensions(SEXP handle, list state, integers bars) {
  return guarded([&]() -> doubles {
    const codend::Model model = read_model(handle);
    const codend::MeasureFrame& frame = held_model(handle).frame;
    const codend::MeasuredShape<double> shape = read_shape(state);
    std::vector<double> out;
    for (const int bar : places(bars)) {
      for (const double end : codend::end_tensions(frame, model, shape, bar)) out.push_back(end);
    }
    return as_doubles(out);
  });
}

// Returns the meshes at all positions on panels as columns (MeshPlace); points: 3 each, m.
[[cpp11::register]] list engine_mesh_places(SEXP handle, doubles points) {
  return guarded([&]() -> list {
    const codend::MeshFrame& meshes = held_model(handle).frame.meshes;
    std::map<std::string, std::vector<double>> columns;
    for (const auto& place : codend::mesh_places(meshes, numbers(points))) {
      columns["opening"].push_back(place.opening);
      columns["depth"].push_back(place.depth);
      columns["angle"].push_back(place.angle);
      const auto add = [&](const char* const names[3], codend::Three<double> x) {
        for (int c = 0; c < 3; ++c) columns[names[c]].push_back(x[c]);
      };
      constexpr const char* u[3] = {"u_x", "u_y", "u_z"};
      constexpr const char* v[3] = {"v_x", "v_y", "v_z"};
      constexpr const char* x[3] = {"x", "y", "z"};
      add(u, place.u);
      add(v, place.v);
      add(x, place.at);
    }
    writable::list out;
    for (const auto& [name, values] : columns) {
      out.push_back(cpp11::named_arg(name.c_str()) = as_doubles(values));
    }
    return out;
  });
}

// Returns volume (m3) and surface (m2) of the netting behind a front, `blocked` meshes from the end
// of the bag; points: 3 each, m.
[[cpp11::register]] doubles engine_catch_sizes(SEXP handle, double blocked, doubles points) {
  return guarded([&]() -> doubles {
    codend::FilledBag bag = held_model(handle).bag;
    bag.blocked = blocked;
    const std::vector<double> x = numbers(points);
    return as_doubles(std::vector<double>{codend::bag_volume(bag, x), codend::bag_surface(bag, x)});
  });
}
