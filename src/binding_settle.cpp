// Equilibria for R.
#include <algorithm>

#include "binding_list.h"
#include "binding_model.h"
#include "engine/measure/settled_gear.hpp"
#include "engine/solve/body_modes.hpp"
#include "engine/solve/settle.hpp"

using namespace binding;

namespace {

// What R checks of a lattice.
struct CheckedLattice {
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

// Tells R of every step, and stops where R is interrupted. how: SettleControl or GearSettling.
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

// from: what the start is, a name of codend::Start; part: of every line, counted from 1, or empty.
[[cpp11::register]] list engine_settle(SEXP mesh, doubles start, std::string from, doubles strain,
                                       integers part, double tolerance, int iterations,
                                       function watch) {
  return guarded([&]() -> list {
    codend::Model model = read_model(mesh);
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

// Settles a gear from its numbers (measure/settled_gear.hpp). from: list as BegunShape has it, or NULL;
// told: whether the lattice is wanted; built: a function of what is checked of every lattice; levels: NULL,
// or nodes of lattices beside one of so many nodes: then it is settled on one more where these say too
// little of its errors (extra_lattice()), else nothing is returned. Returns what engine_settle() does, levels = list(nodes, measures (SI), steps and seconds) of each, lattice = as
// engine_lattice() has it or NULL, asked = nodes that it was asked for, seconds_lattice, blocked, full_bag.
[[cpp11::register]] list engine_settle_gear(list numbers, double nodes, SEXP from,
                                            bool through_levels, bool told, double tolerance,
                                            int iterations, function watch, function built,
                                            SEXP levels) {
  return guarded([&]() -> list {
    const auto read = codend::read_fields<codend::GearNumbers>(ListSource(numbers));
    read.gear.check();
    codend::GearSettling how;
    codend::BegunShape begun;
    if (!Rf_isNull(from)) {
      begun = codend::read_fields<codend::BegunShape>(ListSource(from));
      how.from = &begun;
    }
    how.nodes = nodes;
    how.through_levels = through_levels;
    how.tolerance = tolerance;
    how.iterations = iterations;
    report_to(watch, how);
    how.built = [&](const codend::Lattice& lattice) {
      CheckedLattice checked{lattice.twine, lattice.bag.encloses, lattice.division};
      built(ListWriter::written(checked));
    };
    codend::SettledGear found;
    double asked = nodes;
    if (Rf_isNull(levels)) {
      found = codend::settle_gear(read, how);
    } else {
      auto extra =
          codend::extra_lattice(read, how, begun, nodes, binding::numbers(doubles(levels)), asked);
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
                                      "seconds_lattice"_nm = level.seconds_lattice}));
    }
    writable::list out =
        settled_list(found.report, found.position, found.strain, found.gear.model.wake);
    const auto add = [&](const char* name, SEXP value) {
      out.push_back(cpp11::named_arg(name) = value);
    };
    add("levels", below);
    add("asked", cpp11::as_sexp(asked));
    add("seconds_lattice", cpp11::as_sexp(found.seconds_lattice));
    add("blocked", cpp11::as_sexp(found.gear.bag.blocked));
    add("full_bag", cpp11::as_sexp(found.full_bag));
    if (told) {
      codend::MeasuredGear of = codend::unprepared_gear(
          read.gear, read.model, std::move(found.gear.lattice), found.gear.bag.blocked);
      of.model.wake = found.gear.model.wake;
      codend::MeasureFrame frame = codend::measure_frame(read.gear, of.lattice);
      add("lattice", mesh_list(std::move(of), std::move(frame)));
    }
    return out;
  });
}

// Per motion in which a rigid body takes part: its rate (1/s) by real and imaginary part, the node of a
// body that moves most, whether it is certain, and what is left of the equations.
[[cpp11::register]] list engine_body_modes(SEXP mesh, doubles position, doubles velocity) {
  return guarded([&]() -> list {
    codend::Model model = read_model(mesh);
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
