// R interface: measures of gears near a solved one.
#include "binding_list.h"
#include "binding_model.h"
#include "engine/measure/near_gear.hpp"

using namespace binding;

// numbers: of a gear (measure/measured_gear.hpp); counts, position (3 x points) and wake: of its
// solved discretisation. Returns list(near, measures (SI)), or NULL if the gear is not regular
// (NearGear::regular()).
[[cpp11::register]] SEXP engine_near_gear(list numbers, list counts, doubles position,
                                          doubles wake) {
  return guarded([&]() -> SEXP {
    auto near = std::make_unique<codend::NearGear>(
        codend::read_fields<codend::GearNumbers>(ListSource(numbers)),
        codend::read_fields<codend::Counts>(ListSource(counts)), binding::numbers(position),
        binding::numbers(wake));
    if (!near->regular()) return R_NilValue;
    const sexp measures = as_doubles(near->measures());
    return writable::list({
        "near"_nm = external_pointer<codend::NearGear>(near.release()),
        "measures"_nm = measures,
    });
  });
}

// Returns list(up, down, factorisations): changes of measures (SI, see NearGear::towards()) for
// numbers at the fraction `share` of the way to `numbers`, and at the opposite distance. Changes
// are empty without convergence. tolerance, steps, renewals, closes_in, reach: see NearControl.
[[cpp11::register]] list engine_near_changes(SEXP near, list numbers, double share,
                                             double tolerance, int steps, int renewals,
                                             bool closes_in, double reach) {
  return guarded([&]() -> list {
    const external_pointer<codend::NearGear> from(near);
    const auto found = from->towards(codend::read_fields<codend::GearNumbers>(ListSource(numbers)),
                                     share, {tolerance, steps, renewals, closes_in, reach});
    return writable::list({
        "up"_nm = as_doubles(found[0].change),
        "down"_nm = as_doubles(found[1].change),
        "factorisations"_nm = found[0].factorisations + found[1].factorisations,
    });
  });
}

// Returns list(change, factorisations): changes of measures (SI) to a gear with other numbers in a
// new equilibrium that starts from `near`. `change` is empty without convergence. tolerance,
// iterations: see SettleControl.
[[cpp11::register]] list engine_near_settled(SEXP near, list numbers, double tolerance,
                                             int iterations) {
  return guarded([&]() -> list {
    const external_pointer<codend::NearGear> from(near);
    codend::SettleControl control;
    control.tolerance = tolerance;
    control.iterations = iterations;
    control.pause = [] { check_user_interrupt(); };
    const codend::NearMeasures found =
        from->settled(codend::read_fields<codend::GearNumbers>(ListSource(numbers)), control);
    return writable::list(
        {"change"_nm = as_doubles(found.change), "factorisations"_nm = found.factorisations});
  });
}
