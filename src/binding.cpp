// R interface: evaluation of a model at given positions, and tables of the engine's fields and
// forces.
#include <cmath>

#include "binding_model.h"
#include "engine/base/field_table.hpp"
#include "engine/model/evaluate.hpp"
#include "engine/model/wake.hpp"

using namespace binding;

namespace {

// Columns, one row per plate: angles (rad), lift and drag (N).
list plate_table(const std::vector<codend::PlateAttitude>& plates) {
  writable::doubles attack, heel, trim, lift, drag;
  for (const codend::PlateAttitude& plate : plates) {
    attack.push_back(plate.attack);
    heel.push_back(plate.heel);
    trim.push_back(plate.trim);
    lift.push_back(plate.lift);
    drag.push_back(plate.drag);
  }
  return writable::list({"attack"_nm = attack, "heel"_nm = heel, "trim"_nm = trim, "lift"_nm = lift,
                         "drag"_nm = drag});
}

}  // namespace

[[cpp11::register]] list engine_evaluate(SEXP handle, doubles position, doubles velocity) {
  return guarded([&]() -> list {
    const codend::Model model = read_model(handle);
    codend::Assembly assembly(model);
    const std::vector<double> x = of_nodes(position, model, "position"),
                              v = of_nodes(velocity, model, "velocity");
    const codend::Evaluation e = codend::evaluate(assembly, x.data(), v.data());
    writable::list forces;
    for (std::size_t k = 0; k < e.forces.size(); ++k) {
      forces.push_back(cpp11::named_arg(codend::reported_forces()[k].name) =
                           as_doubles(e.forces[k]));
    }
    return writable::list({
        "force"_nm = as_doubles(e.force),
        "mass"_nm = as_doubles(e.mass),
        "bar_tension"_nm = as_doubles(e.bar_tension),
        "bar_length"_nm = as_doubles(e.bar_length),
        "u_tension"_nm = as_doubles(e.u_tension),
        "v_tension"_nm = as_doubles(e.v_tension),
        "straight_tension"_nm = as_doubles(e.straight_tension),
        "u_length"_nm = as_doubles(e.u_length),
        "v_length"_nm = as_doubles(e.v_length),
        "straight_length"_nm = as_doubles(e.straight_length),
        "forces"_nm = forces,
        "plates"_nm = plate_table(e.plates),
        "ground_places"_nm = as_doubles(e.ground_places),
    });
  });
}

// Returns the fields of a model as columns, one row per field (FieldRow).
[[cpp11::register]] list engine_fields() {
  return guarded([&]() -> list {
    writable::strings kind, name, type, per, among;
    writable::integers width;
    for (const codend::FieldRow& row : codend::field_table<codend::Model>()) {
      kind.push_back(row.kind);
      name.push_back(row.name);
      type.push_back(row.type);
      width.push_back(row.width);
      per.push_back(row.per);
      among.push_back(row.among);
    }
    return writable::list({"kind"_nm = kind, "name"_nm = name, "type"_nm = type, "width"_nm = width,
                           "per"_nm = per, "among"_nm = among});
  });
}

// Returns the forces of an evaluation as columns, one row per force (ReportedForce).
[[cpp11::register]] list engine_forces() {
  return guarded([&]() -> list {
    writable::strings name, kind, cause;
    for (const codend::ReportedForce& force : codend::reported_forces()) {
      name.push_back(force.name);
      kind.push_back(force.kind);
      cause.push_back(codend::name_of(force.cause));
    }
    return writable::list({"name"_nm = name, "kind"_nm = kind, "cause"_nm = cause});
  });
}

// Returns the speed behind a sheet of netting as a fraction of the upstream speed, by a wake model.
[[cpp11::register]] doubles engine_speed_reduction(std::string law, doubles solidity,
                                                   doubles cosine) {
  return guarded([&]() -> doubles {
    const codend::WakeLaw kind = codend::by_name<codend::WakeLaw>(law, "law");
    writable::doubles out;
    for (R_xlen_t k = 0; k < solidity.size(); ++k) {
      out.push_back(codend::speed_reduction(kind, solidity[k], cosine[k]));
    }
    return out;
  });
}

// Returns wave numbers (1/m) of angular frequencies (1/s) in water of a depth (m; 0: deep water).
[[cpp11::register]] doubles engine_wave_number(doubles frequency, double depth) {
  return guarded([&]() -> doubles {
    writable::doubles out;
    for (const double w : frequency) {
      out.push_back(codend::wave_number(w, depth > 0.0 ? depth : INFINITY));
    }
    return out;
  });
}

// Returns the surface elevation by waves (m) at positions (m) and times (s). waves: as in the water
// of a model.
[[cpp11::register]] doubles engine_elevation(list waves, doubles x, doubles y, doubles time) {
  return guarded([&]() -> doubles {
    codend::Waves read = codend::read_fields<codend::Waves>(ListSource(waves));
    read.prepare();
    writable::doubles out;
    for (R_xlen_t k = 0; k < x.size(); ++k) {
      read.time = time[k];
      out.push_back(read.at(codend::Vector(x[k], y[k], 0.0)).elevation);
    }
    return out;
  });
}
