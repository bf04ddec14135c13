// Equilibria for R.
#include <algorithm>

#include "binding_model.h"
#include "engine/solve/body_modes.hpp"
#include "engine/solve/settle.hpp"

using namespace binding;

// from: what the start is, a name of codend::Start; part: of every line, counted from 1, or empty.
[[cpp11::register]] list engine_settle(list lattice, doubles start, std::string from,
                                       doubles strain, integers part, double tolerance,
                                       int iterations, function watch) {
  return guarded([&]() -> list {
    codend::Model model = read_model(lattice);
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
    control.watch = [&](const codend::SettleProgress& progress) {
      check_user_interrupt();
      watch(progress.iteration, progress.residual);
      return true;
    };
    control.pause = [] { check_user_interrupt(); };
    const codend::SettleReport report = codend::settle_from(assembly, control, v.data(), x.data());
    std::vector<double> line_strain;
    assembly.strain(line_strain);
    line_strain.resize(static_cast<std::size_t>(model.lines()));
    return writable::list({
        "position"_nm = as_doubles(x),
        "strain"_nm = as_doubles(line_strain),
        "converged"_nm = report.converged,
        "iterations"_nm = report.iterations,
        "factorisations"_nm = report.factorisations,
        "residual"_nm = report.residual,
        "largest_tension"_nm = report.largest_tension,
        "wake_renewals"_nm = report.wake_renewals,
        "perturbations"_nm = report.perturbations,
        "unstable"_nm = report.unstable,
        "wake_change"_nm = report.wake_change,
        "wake"_nm = as_doubles(assembly.has_wake() ? assembly.wake() : std::vector<double>()),
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
  });
}

// Per motion in which a rigid body takes part: its rate (1/s) by real and imaginary part, the node of a
// body that moves most, whether it is certain, and what is left of the equations.
[[cpp11::register]] list engine_body_modes(list lattice, doubles position, doubles velocity) {
  return guarded([&]() -> list {
    codend::Model model = read_model(lattice);
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
