// R interface: time integration.
#include <ctime>

#include "binding_model.h"
#include "binding_schedule.h"
#include "engine/model/evaluate.hpp"
#include "engine/motion/scheduled_conditions.hpp"
#include "engine/motion/schemes.hpp"
#include "engine/motion/substitution.hpp"
#include "engine/motion/time_integration.hpp"

using namespace binding;

namespace {

// Values of all nodes, 3 each.
codend::Values node_values(const list& from, const char* name, const codend::Model& model) {
  const std::vector<double> given = of_nodes(doubles(from[name]), model, name);
  return Eigen::Map<const codend::Values>(given.data(), static_cast<Eigen::Index>(given.size()));
}

codend::Motion read_motion(const list& from, const codend::Model& model) {
  return {number(from, "time"), node_values(from, "position", model),
          node_values(from, "velocity", model), node_values(from, "acceleration", model)};
}

void check_count(R_xlen_t count, std::size_t wanted, const char* name) {
  if (static_cast<std::size_t>(count) == wanted) return;
  throw codend::InputError(name, std::string(name) + " has " + std::to_string(count) +
                                     " values, must have " + std::to_string(wanted));
}

writable::list as_list(const codend::Motion& motion) {
  return writable::list({"time"_nm = motion.time, "position"_nm = as_doubles(motion.x),
                         "velocity"_nm = as_doubles(motion.v),
                         "acceleration"_nm = as_doubles(motion.a)});
}

// Parts of a motion's energy account (motion/energy_account.hpp) by their names in R, in the order
// of the R vector. The work of changing lengths is the work of winches.
struct EnergyPart {
  const char* name;
  double codend::EnergyTotals::*value;
};
constexpr EnergyPart energy_parts[] = {{"kinetic", &codend::EnergyTotals::kinetic},
                                       {"elastic", &codend::EnergyTotals::elastic},
                                       {"potential", &codend::EnergyTotals::potential},
                                       {"supports", &codend::EnergyTotals::supports},
                                       {"winches", &codend::EnergyTotals::lengths},
                                       {"water", &codend::EnergyTotals::water},
                                       {"damping", &codend::EnergyTotals::damping},
                                       {"put_through", &codend::EnergyTotals::put_through}};

codend::EnergyTotals read_energy(const list& from) {
  const doubles given(from["energy"]);
  check_count(given.size(), std::size(energy_parts), "energy");
  codend::EnergyTotals totals;
  R_xlen_t k = 0;
  for (const auto& part : energy_parts) totals.*part.value = given[k++];
  return totals;
}

writable::doubles as_doubles(const codend::EnergyTotals& totals) {
  writable::doubles out;
  for (const auto& part : energy_parts) out.push_back(totals.*part.value);
  return out;
}

// Error of positions in the energy balance, as a fraction of the smallest allowed error of a step.
constexpr double energy_error = 0.1;

// Change of the potential of all loads (J) by an error of position (m).
double potential_of(const codend::Model& model, double error) {
  double sum = 0.0;
  for (int p = 0; p < model.points(); ++p) sum += codend::at(model.load.data(), p).norm();
  return error * sum;
}

}  // namespace

[[cpp11::register]] list engine_integrate(SEXP handle, doubles position, doubles velocity,
                                          double step, int steps, double tolerance,
                                          int substitutions) {
  return guarded([&]() -> list {
    codend::Model model = read_model(handle);
    codend::Assembly assembly(model);
    std::vector<double> x = of_nodes(position, model, "position"),
                        v = of_nodes(velocity, model, "velocity");
    const codend::SubstitutionReport report = codend::integrate_by_substitution(
        assembly, step, steps, tolerance, substitutions, x.data(), v.data(), [] {
          check_user_interrupt();
          return true;
        });
    return writable::list({
        "position"_nm = as_doubles(x),
        "velocity"_nm = as_doubles(v),
        "converged"_nm = report.converged,
        "steps"_nm = report.steps,
        "substitutions"_nm = static_cast<double>(report.substitutions),
    });
  });
}

// Integrates from `past` (its `ordering`: see NewtonStep) through the stops of list(time, kept,
// broken, steered, filled, recorded). Times (s) increase. The logical columns mark stops to store a
// snapshot, to restart the motion, to steer winches, and to move the front of the catch. `recorded`
// has further times (s) of snapshots, which do not end steps.
//
// Callbacks:
//
// - `keep(frame)` receives the motion, tensions and all data needed to continue.
// - `steer(frame)` returns the target speed of every growing group.
// - `refill(frame)` returns weight, node and mass of the catch.
// - `watch(time, steps)` is called after steps, about ten times per second at most.
[[cpp11::register]] list engine_tow(SEXP handle, list schedule, list past, list control, list stops,
                                    function keep, function steer, function refill,
                                    function watch) {
  return guarded([&]() -> list {
    codend::Model model = read_model(handle);
    codend::Assembly assembly(model);
    codend::Past from;
    from.now = read_motion(list(past["now"]), model);
    from.before = read_motion(list(past["before"]), model);
    from.steps = as_cpp<int>(past["steps"]);
    from.caution = as_cpp<int>(past["caution"]);
    codend::ScheduledConditions conditions(model, assembly, read_schedule(schedule), from.now);
    conditions.to_time(from.now.time, codend::Side::after, from.now);
    const bool adaptive = number(control, "accuracy") > 0.0;
    const codend::Scheme& chosen = codend::scheme_named(as_cpp<std::string>(control["scheme"]));
    const codend::Values ordering = node_values(past, "ordering", model);
    codend::StepAccuracy accuracy;
    if (adaptive) {
      const double given = number(control, "accuracy");
      if (as_cpp<bool>(control["relative"])) {
        accuracy = codend::relative_accuracy(given, ordering);
      } else {
        accuracy.position = given;
      }
      accuracy.tension = number(control, "tension_accuracy");
    } else {
      accuracy.found = number(control, "tolerance");
    }
    const auto make = [&] { return chosen.make(assembly, accuracy, from.now, ordering); };
    const std::unique_ptr<codend::Stepper> scheme = make();
    // The second stepper computes states within steps.
    const doubles recorded(stops["recorded"]);
    const std::unique_ptr<codend::Stepper> inner = recorded.size() > 0 ? make() : nullptr;

    codend::IntegrationControl how;
    how.adaptive = adaptive;
    how.step = number(past, "step");
    how.least_step = number(control, "least_step");
    how.most_step = number(control, "most_step");
    how.account = as_cpp<bool>(control["account"]);
    how.energy_floor = adaptive ? potential_of(model, energy_error * accuracy.position) : 0.0;
    std::clock_t shown = std::clock();
    long long steps = 0;
    how.watch = [&](const codend::Motion& now) {
      check_user_interrupt();
      ++steps;
      if (std::clock() - shown > CLOCKS_PER_SEC / 10) {
        shown = std::clock();
        watch(now.time, static_cast<double>(steps));
      }
      return true;
    };
    codend::TimeIntegration integration(assembly, *scheme, conditions, how, from);
    integration.go_on_from(read_energy(past));
    auto report = [&] {
      const codend::IntegrationReport& r = integration.report();
      const char* const ends[] = {"reached", "stopped", "stuck", "unbalanced"};
      return writable::list(
          {"end"_nm = ends[static_cast<int>(r.end)], "steps"_nm = static_cast<double>(r.steps),
           "repeated"_nm = static_cast<double>(r.repeated),
           "not_found"_nm = static_cast<double>(r.not_found),
           "unbalanced"_nm = static_cast<double>(r.unbalanced),
           "iterations"_nm = static_cast<double>(r.iterations),
           "shortest_step"_nm = r.shortest_step, "longest_step"_nm = r.longest_step,
           "largest_error"_nm = r.largest_error, "worst_node"_nm = r.worst_node + 1,
           "time"_nm = integration.now().time,
           "factorisations"_nm = static_cast<double>(scheme->factorisations()),
           "force_evaluations"_nm = static_cast<double>(assembly.force_evaluations()),
           "factor_entries"_nm = static_cast<double>(scheme->factor_entries())});
    };
    auto frame = [&](const codend::Motion& now, const codend::Schedule& done,
                     const codend::EnergyTotals& energy) {
      const codend::Evaluation e = codend::evaluate(assembly, now.x.data(), now.v.data());
      // Only straight bars that exist.
      std::vector<double> straight_tension;
      for (std::size_t k = 0; k < e.straight_tension.size(); ++k) {
        if (model.hexagonal[k]) straight_tension.push_back(e.straight_tension[k]);
      }
      return writable::list(
          {"now"_nm = as_list(now), "before"_nm = as_list(integration.past().before),
           "steps"_nm = integration.past().steps, "caution"_nm = integration.past().caution,
           "step"_nm = integration.step(), "done"_nm = schedule_done(done),
           "energy"_nm = as_doubles(energy), "bar_tension"_nm = as_doubles(e.bar_tension),
           "u_tension"_nm = as_doubles(e.u_tension), "v_tension"_nm = as_doubles(e.v_tension),
           "straight_tension"_nm = as_doubles(straight_tension),
           "wake"_nm = as_doubles(assembly.has_wake() ? assembly.wake() : std::vector<double>()),
           "report"_nm = report()});
    };
    auto last_frame = [&] {
      return frame(integration.now(), conditions.schedule(), integration.energy());
    };
    R_xlen_t next = 0;
    how.passed = [&](const codend::Past& step) {
      if (next == recorded.size() || recorded[next] > step.now.time) return;
      for (; next < recorded.size() && recorded[next] <= step.now.time; ++next) {
        codend::Motion motion = integration.at(recorded[next], *inner);
        conditions.to_time(motion.time, codend::Side::before, motion);
        keep(
            frame(motion, conditions.schedule_at(motion.time), integration.energy_at(motion.time)));
      }
      codend::Motion end = step.now;
      conditions.to_time(end.time, codend::Side::before, end);
    };
    const doubles times(stops["time"]);
    const logicals kept(stops["kept"]), broken(stops["broken"]), steered(stops["steered"]),
        filled(stops["filled"]);
    for (R_xlen_t k = 0; k < times.size(); ++k) {
      if (integration.to(times[k]) != codend::IntegrationReport::End::reached) break;
      if (steered[k] == TRUE) {
        const doubles speed(steer(last_frame()));
        std::vector<codend::GrowingGroup>& growing = conditions.schedule().growing;
        check_count(speed.size(), growing.size(), "speed");
        for (std::size_t g = 0; g < growing.size(); ++g) {
          growing[g].control.target_speed = speed[static_cast<R_xlen_t>(g)];
        }
      }
      if (filled[k] == TRUE) {
        const list moved(refill(last_frame()));
        const doubles weight(moved["weight"]), mass(moved["mass"]);
        const std::vector<int> node = places(moved, "node");
        check_count(weight.size(), model.pressure.weight.size(), "weight");
        check_count(mass.size(), node.size(), "mass");
        conditions.model().set_pressure_weight(numbers(weight));
        for (std::size_t p = 0; p < node.size(); ++p) {
          if (node[p] < 0 || node[p] >= model.points()) {
            throw codend::InputError("node", "node is not a node of the model");
          }
          conditions.model().set_mass(node[p], mass[static_cast<R_xlen_t>(p)]);
        }
      }
      if (broken[k] == TRUE) integration.restart_iteration();
      if (kept[k] == TRUE) keep(last_frame());
    }
    return report();
  });
}

// Returns the names of the parts of the energy account.
[[cpp11::register]] strings engine_energy_parts() {
  return guarded([&]() -> strings {
    writable::strings name;
    for (const auto& part : energy_parts) name.push_back(part.name);
    return name;
  });
}

// Returns the names of the time integration schemes, and TRUE for schemes with adaptive steps.
[[cpp11::register]] list engine_schemes() {
  return guarded([&]() -> list {
    writable::strings name;
    writable::logicals adaptive;
    for (const codend::Scheme& scheme : codend::schemes()) {
      name.push_back(scheme.name);
      adaptive.push_back(scheme.adaptive ? TRUE : FALSE);
    }
    return writable::list({"name"_nm = name, "adaptive"_nm = adaptive});
  });
}
