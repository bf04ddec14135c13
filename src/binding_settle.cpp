// R interface: equilibria.
#include <algorithm>

#include "binding_list.h"
#include "binding_model.h"
#include "engine/measure/settled_gear.hpp"
#include "engine/solve/body_modes.hpp"
#include "engine/solve/settle.hpp"

using namespace binding;

namespace {

// Data of a discretisation that R checks before the solution.
struct CheckedMesh {
  std::vector<double> twine;
  bool encloses;
  codend::Division division;

  template <class Visit>
  void fields(Visit& visit) {
    visit.list("twine", twine);
    visit("encloses", encloses);
    visit.group("division", division);
  }
};

// Reports every iteration to R, and stops if the user interrupts. how: SettleControl or
// GearSettling.
template <class Control>
void report_to(const function& watch, Control& how) {
  how.watch = [&watch](const codend::SettleProgress& progress) {
    check_user_interrupt();
    watch(progress.iteration, progress.residual);
    return true;
  };
  how.pause = [] { check_user_interrupt(); };
}

list settled_list(const codend::SettleReport& report, const std::vector<double>& position,
                  const std::vector<double>& strain, const std::vector<double>& wake) {
  const codend::SettleControl control;
  return writable::list({
      "position"_nm = as_doubles(position),
      "strain"_nm = as_doubles(strain),
      "converged"_nm = report.converged,
      "iterations"_nm = report.iterations,
      "factorisations"_nm = report.factorisations,
      "force_evaluations"_nm = static_cast<double>(report.force_evaluations),
      "factor_entries"_nm = static_cast<double>(report.factor_entries),
      "residual"_nm = report.residual,
      "largest_tension"_nm = report.largest_tension,
      "wake_renewals"_nm = report.wake_renewals,
      "perturbations"_nm = report.perturbations,
      "unstable"_nm = report.unstable,
      "wake_change"_nm = report.wake_change,
      "wake"_nm = as_doubles(wake),
      "worst_node"_nm = report.worst_node + 1,
      "worst_force"_nm = report.worst_force,
      "part_residual"_nm = report.parts.residual,
      "part_tolerance"_nm = control.part_tolerance,
      "worst_part"_nm = report.parts.part + 1,
      "part_rounding"_nm = report.parts.rounding,
      "greatest_rounding"_nm = control.greatest_rounding,
      "rounding_part"_nm = report.parts.rounding_part + 1,
      "seconds_forces"_nm = report.seconds_forces,
      "seconds_jacobian"_nm = report.seconds_jacobian,
      "seconds_linear"_nm = report.seconds_linear,
      "seconds_analysis"_nm = report.seconds_analysis,
  });
}

}  // namespace

// Returns an equilibrium of a model, see settled_list(). from: kind of initial guess, a name of
// codend::Start; part: of every line, from 1, or empty.
[[cpp11::register]] list engine_settle(SEXP handle, doubles start, std::string from, doubles strain,
                                       integers part, double tolerance, int iterations,
                                       function watch) {
  return guarded([&]() -> list {
    codend::Model model = read_model(handle);
    codend::Assembly assembly(model);
    std::vector<double> x = of_nodes(start, model, "start");
    const std::vector<double> v(x.size(), 0.0);

    codend::SettleControl control;
    control.start = codend::by_name<codend::Start>(from, "from");
    control.strain.assign(strain.begin(), strain.end());
    if (!control.strain.empty() &&
        control.strain.size() != static_cast<std::size_t>(model.lines())) {
      throw codend::InputError("strain", "strain has " + std::to_string(control.strain.size()) +
                                             " values, must have " + std::to_string(model.lines()) +
                                             " (1 per line)");
    }
    for (const int one : part) control.part.push_back(one - 1);
    if (!control.part.empty() &&
        (control.part.size() != static_cast<std::size_t>(model.lines()) ||
         *std::min_element(control.part.begin(), control.part.end()) < 0)) {
      throw codend::InputError("part", "part must be a number from 1 per line, of " +
                                           std::to_string(model.lines()) + " lines");
    }
    control.tolerance = tolerance;
    control.iterations = iterations;
    report_to(watch, control);
    const codend::SettleReport report = codend::settle_from(assembly, control, v.data(), x.data());
    std::vector<double> line_strain;
    assembly.strain(line_strain);
    line_strain.resize(static_cast<std::size_t>(model.lines()));
    return settled_list(report, x, line_strain,
                        assembly.has_wake() ? assembly.wake() : std::vector<double>());
  });
}

// Solves for the equilibrium of a gear from its numbers (measure/settled_gear.hpp).
//
// - `from`: list with the fields of InitialShape, or NULL.
// - `told`: TRUE to return the discretisation.
// - `built`: function of a CheckedMesh, called for every discretisation.
// - `levels`: NULL, or node numbers of other meshes of the gear solved with `nodes` nodes. If these
//   do not suffice for its errors, one more mesh is solved (extra_mesh()). Otherwise the result
//   is an empty list.
//
// Returns the list of engine_settle() plus these elements:
//
// - `levels`: list(nodes, measures (SI), iterations and CPU seconds) of each mesh level.
// - `asked`: requested nodes.
// - `seconds_mesh`, `blocked`, `full_bag`: see SettledGear and FilledBag.
// - `mesh`: the list of engine_mesh(), if `told`.
[[cpp11::register]] list engine_settle_gear(list numbers, double nodes, SEXP from,
                                            bool through_levels, bool told, double tolerance,
                                            int iterations, function watch, function built,
                                            SEXP levels) {
  return guarded([&]() -> list {
    const auto read = codend::read_fields<codend::GearNumbers>(ListSource(numbers));
    read.gear.check();
    codend::GearSettling how;
    codend::InitialShape begun;
    if (!Rf_isNull(from)) {
      begun = codend::read_fields<codend::InitialShape>(ListSource(from));
      how.from = &begun;
    }
    how.nodes = nodes;
    how.through_levels = through_levels;
    how.tolerance = tolerance;
    how.iterations = iterations;
    report_to(watch, how);
    how.built = [&](const codend::Mesh& mesh) {
      CheckedMesh checked{mesh.twine, mesh.bag.encloses, mesh.division};
      built(ListWriter::written(checked));
    };
    codend::SettledGear found;
    double asked = nodes;
    if (Rf_isNull(levels)) {
      found = codend::settle_gear(read, how);
    } else {
      auto extra =
          codend::extra_mesh(read, how, begun, nodes, binding::numbers(doubles(levels)), asked);
      if (!extra) return writable::list();
      found = std::move(*extra);
    }
    writable::list below;
    for (const codend::SettledLevel& level : found.levels) {
      below.push_back(writable::list({"nodes"_nm = static_cast<double>(level.nodes),
                                      "measures"_nm = as_doubles(level.measures),
                                      "iterations"_nm = level.report.iterations,
                                      "factorisations"_nm = level.report.factorisations,
                                      "seconds_forces"_nm = level.report.seconds_forces,
                                      "seconds_jacobian"_nm = level.report.seconds_jacobian,
                                      "seconds_linear"_nm = level.report.seconds_linear,
                                      "seconds_analysis"_nm = level.report.seconds_analysis,
                                      "seconds_mesh"_nm = level.seconds_mesh}));
    }
    writable::list out =
        settled_list(found.report, found.position, found.strain, found.gear.model.wake);
    const auto add = [&](const char* name, SEXP value) {
      out.push_back(cpp11::named_arg(name) = value);
    };
    add("levels", below);
    add("asked", cpp11::as_sexp(asked));
    add("seconds_mesh", cpp11::as_sexp(found.seconds_mesh));
    add("blocked", cpp11::as_sexp(found.gear.bag.blocked));
    add("full_bag", cpp11::as_sexp(found.full_bag));
    if (told) {
      codend::MeasuredGear of = codend::unprepared_gear(
          read.gear, read.model, std::move(found.gear.mesh), found.gear.bag.blocked);
      of.model.wake = found.gear.model.wake;
      codend::MeasureFrame frame = codend::measure_frame(read.gear, of.mesh);
      add("mesh", mesh_list(std::move(of), std::move(frame)));
    }
    return out;
  });
}

// Returns the modes of motion of rigid bodies as columns. They are the rate (real and imaginary
// part, 1/s), the body node with the largest motion, TRUE if the mode is certain, and the residual
// of the equations.
[[cpp11::register]] list engine_body_modes(SEXP handle, doubles position, doubles velocity) {
  return guarded([&]() -> list {
    codend::Model model = read_model(handle);
    codend::Assembly assembly(model);
    const std::vector<double> x = of_nodes(position, model, "position");
    const std::vector<double> v = of_nodes(velocity, model, "velocity");
    std::vector<double> growth, frequency, residual;
    writable::integers node;
    writable::logicals certain;
    for (const codend::BodyMode& mode : codend::body_modes(assembly, x.data(), v.data())) {
      growth.push_back(mode.rate.real());
      frequency.push_back(mode.rate.imag());
      residual.push_back(mode.residual);
      node.push_back(mode.node + 1);
      certain.push_back(static_cast<cpp11::r_bool>(mode.certain));
    }
    return writable::list({"growth"_nm = as_doubles(growth), "frequency"_nm = as_doubles(frequency),
                           "node"_nm = node, "certain"_nm = certain,
                           "residual"_nm = as_doubles(residual)});
  });
}
