// Measures of states for R.
#include <algorithm>
#include <cmath>
#include <map>

#include "binding_list.h"
#include "binding_model.h"
#include "engine/measure/measure_errors.hpp"

using namespace binding;

namespace {

// Of a state's tensions, forces and places.
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

// Measures in SI, not a number where the gear does not have one. questions: see measures.hpp; state: what
// acts in it.
[[cpp11::register]] doubles engine_measures(SEXP mesh, list questions, list state) {
  return guarded([&]() -> doubles {
    const HeldMesh& held = held_mesh(mesh);
    return as_doubles(codend::measure(held.frame, read_model(mesh),
                                      codend::read_fields<codend::Questions>(ListSource(questions)),
                                      held.catch_bag(), read_shape(state)));
  });
}

// Standard errors of measures of these kinds on the first of lattices of so many nodes (see
// measure_errors.hpp), SI, NA where no other says more. values: SI, of every lattice after the other.
[[cpp11::register]] doubles engine_measure_errors(strings kinds, doubles nodes, doubles values,
                                                  double tolerance, double step_accuracy) {
  return guarded([&]() -> doubles {
    std::vector<codend::MeasureKind> of;
    for (const std::string kind : kinds) {
      of.push_back(codend::by_name<codend::MeasureKind>(kind, "kinds"));
    }
    std::vector<codend::MeasuredLattice> lattices;
    const double* next = REAL(values);
    for (const double count : nodes) {
      lattices.push_back({count, std::vector<double>(next, next + of.size())});
      next += of.size();
    }
    writable::doubles errors = as_doubles(codend::measure_errors(
        of, lattices[0], {lattices.begin() + 1, lattices.end()}, tolerance, step_accuracy));
    std::replace_if(
        errors.begin(), errors.end(), [](double error) { return std::isnan(error); }, NA_REAL);
    return errors;
  });
}

// Force of the flow on every part, 3 each, N.
[[cpp11::register]] doubles engine_part_forces(SEXP mesh, list state) {
  return guarded([&]() -> doubles {
    return as_doubles(codend::part_forces(held_mesh(mesh).frame, read_shape(state)));
  });
}

// Tension at both ends of bars of ropes, 2 each, N.
[[cpp11::register]] doubles engine_end_tensions(SEXP mesh, list state, integers bars) {
  return guarded([&]() -> doubles {
    const codend::Model model = read_model(mesh);
    const codend::MeasureFrame& frame = held_mesh(mesh).frame;
    const codend::MeasuredShape<double> shape = read_shape(state);
    std::vector<double> out;
    for (const int bar : places(bars)) {
      for (const double end : codend::end_tensions(frame, model, shape, bar)) out.push_back(end);
    }
    return as_doubles(out);
  });
}

// Meshes at all places of panels, as columns; points: 3 each, m.
[[cpp11::register]] list engine_mesh_places(SEXP mesh, doubles points) {
  return guarded([&]() -> list {
    const codend::MeshFrame& meshes = held_mesh(mesh).frame.meshes;
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

// Volume (m3) and surface (m2) of the netting behind a catch's front, `blocked` meshes from the bag's end;
// points: 3 each, m.
[[cpp11::register]] doubles engine_catch_sizes(SEXP mesh, double blocked, doubles points) {
  return guarded([&]() -> doubles {
    codend::FilledBag bag = held_mesh(mesh).bag;
    bag.blocked = blocked;
    const std::vector<double> x = numbers(points);
    return as_doubles(std::vector<double>{codend::bag_volume(bag, x), codend::bag_surface(bag, x)});
  });
}
