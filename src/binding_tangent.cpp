// Small changes of an equilibrium for R.
#include "binding_model.h"
#include "engine/solve/tangent.hpp"

using namespace binding;

// The factors at these positions, or NULL where the matrix is singular.
[[cpp11::register]] SEXP engine_tangent(list lattice, doubles position) {
  return guarded([&]() -> SEXP {
    const codend::Model model = read_model(lattice);
    codend::Assembly assembly(model);
    const std::vector<double> x = of_nodes(position, model, "position");
    auto tangent = std::make_unique<codend::Tangent>(assembly, x.data());
    if (!tangent->regular()) return R_NilValue;
    return external_pointer<codend::Tangent>(tangent.release());
  });
}

// A lattice of the same nodes brought to balance from these positions with factors that
// engine_tangent() gave.
[[cpp11::register]] list engine_balance(SEXP tangent, list lattice, doubles position,
                                        double tolerance, int steps) {
  return guarded([&]() -> list {
    const external_pointer<codend::Tangent> factors(tangent);
    const codend::Model model = read_model(lattice);
    codend::Assembly assembly(model);
    std::vector<double> x = of_nodes(position, model, "position");
    const codend::ChordReport report = factors->balance(assembly, tolerance, steps, x.data());
    return writable::list({
        "position"_nm = as_doubles(x),
        "converged"_nm = report.converged,
        "steps"_nm = report.steps,
        "residual"_nm = report.residual,
        "wake"_nm = as_doubles(assembly.has_wake() ? assembly.wake() : std::vector<double>()),
    });
  });
}
