#include "evaluate.hpp"

#include <cmath>
#include <stdexcept>

namespace codend {
namespace {

// points: number of points that each carry the stored drag.
void add_line_drag(const LineArrays& lines, int points, int first, int count,
                   std::vector<double>& drag) {
  for (int k = 0; k < count; ++k) {
    const int line = first + k;
    at(drag.data(), k) +=
        points * Vector(lines.drag[0][line], lines.drag[1][line], lines.drag[2][line]);
  }
}

std::vector<double> vectors(int count) {
  return std::vector<double>(3 * static_cast<std::size_t>(count), 0.0);
}

std::vector<double> bar_drag(const Assembly& assembly) {
  const int bars = assembly.model().bars.count();
  std::vector<double> drag = vectors(bars);
  add_line_drag(assembly.lines(), 2, 0, bars, drag);
  return drag;
}

std::vector<double> cell_drag(const Assembly& assembly) {
  const Model& model = assembly.model();
  const int cells = model.cells.count(), hexagons = model.hexagons.count();
  std::vector<double> plain = vectors(cells), hexagonal = vectors(hexagons);
  for (int family = 0; family < 2; ++family) {
    add_line_drag(assembly.lines(), 1, model.cells.first_line + family * cells, cells, plain);
  }
  for (int family = 0; family < 3; ++family) {
    add_line_drag(assembly.lines(), 1, model.hexagons.first_line + family * hexagons, hexagons,
                  hexagonal);
  }
  return in_list_order(model.hexagonal, 3, plain, hexagonal.data(),
                       static_cast<std::size_t>(hexagons));
}

template <auto kind>
std::vector<double> of_elements(const Assembly& assembly) {
  const auto& elements = assembly.model().*kind;
  std::vector<double> out = vectors(elements.count());
  for (int e = 0; e < elements.count(); ++e) {
    at(out.data(), e) = elements.element_force(e, assembly.field());
  }
  return out;
}

template <auto kind>
std::vector<double> of_cells(const Assembly& assembly) {
  return (assembly.model().*kind).element_forces(assembly.field());
}

std::vector<double> pressure_force(const Assembly& assembly) {
  const InnerPressure& pressure = assembly.model().pressure;
  const Vector mean = pressure.mean_velocity(assembly.field());
  std::vector<double> out = vectors(pressure.count());
  for (int e = 0; e < pressure.count(); ++e) {
    at(out.data(), e) = pressure.element_force(e, assembly.field(), mean);
  }
  return out;
}

template <auto force>
std::vector<double> of_plates(const Assembly& assembly) {
  const LiftingPlates& plates = assembly.model().plates;
  std::vector<double> out = vectors(plates.count());
  for (int p = 0; p < plates.count(); ++p) {
    at(out.data(), p) = plates.attitude(p, assembly.field()).*force;
  }
  return out;
}

void read_lines(const LineArrays& lines, int first, int count, std::vector<double>& tension,
                std::vector<double>& length) {
  tension.assign(lines.tension + first, lines.tension + first + count);
  length.resize(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) {
    const int line = first + k;
    double square = Vector(lines.e[0][line], lines.e[1][line], lines.e[2][line]).squaredNorm();
    if (lines.twist_weight && lines.twist_weight[line] > 0.0) {
      square +=
          lines.twist_weight[line] *
          Vector(lines.twist[0][line], lines.twist[1][line], lines.twist[2][line]).squaredNorm();
    }
    length[k] = std::sqrt(square);
  }
}

void read_cells(const Model& model, const LineArrays& lines, Evaluation& out) {
  const int cells = model.cells.count(), hexagons = model.hexagons.count();
  std::vector<double> tension, length, hexagon_tension, hexagon_length;
  auto family = [&](int plain, int hexagonal, std::vector<double>& tensions,
                    std::vector<double>& lengths) {
    if (plain < 0) {
      tension.assign(static_cast<std::size_t>(cells), 0.0);
      length = tension;
    } else {
      read_lines(lines, model.cells.first_line + plain * cells, cells, tension, length);
    }
    read_lines(lines, model.hexagons.first_line + hexagonal * hexagons, hexagons, hexagon_tension,
               hexagon_length);
    const std::size_t n = static_cast<std::size_t>(hexagons);
    tensions = in_list_order(model.hexagonal, 1, tension, hexagon_tension.data(), n);
    lengths = in_list_order(model.hexagonal, 1, length, hexagon_length.data(), n);
  };
  family(-1, 0, out.straight_tension, out.straight_length);
  family(0, 1, out.u_tension, out.u_length);
  family(1, 2, out.v_tension, out.v_length);
}

}  // namespace

const std::vector<ReportedForce>& reported_forces() {
  static const std::vector<ReportedForce> all = {
      {"bar_drag", "bars", Cause::flow, bar_drag},
      {"cell_drag", "cells", Cause::flow, cell_drag},
      {"screen_force", "screens", Cause::flow, of_cells<&Model::screens>},
      {"blended_force", "blended", Cause::flow, of_cells<&Model::blended>},
      {"sphere_drag", "spheres", Cause::flow, of_elements<&Model::spheres>},
      {"lift_force", "lifts", Cause::flow, of_elements<&Model::lifts>},
      {"plate_force", "plates", Cause::flow, of_plates<&PlateAttitude::force>},
      {"pressure_force", "pressure", Cause::flow, pressure_force},
      {"contact_force", "contacts", Cause::ground, of_elements<&Model::contacts>},
      {"plate_ground_force", "plates", Cause::ground, of_plates<&PlateAttitude::ground_force>},
      {"volume_force", "volumes", Cause::surface, of_elements<&Model::volumes>},
      {"plate_lost_buoyancy", "plates", Cause::surface, of_plates<&PlateAttitude::lost_buoyancy>},
  };
  return all;
}

const std::vector<double>& Evaluation::reported(const std::string& name) const {
  for (std::size_t k = 0; k < forces.size(); ++k) {
    if (name == reported_forces()[k].name) return forces[k];
  }
  throw std::out_of_range("no reported force is called " + name);
}

Evaluation evaluate(Assembly& assembly, const double* x, const double* v) {
  assembly.renew_still();
  assembly.move_to(x, v);
  return evaluate_here(assembly);
}

Evaluation evaluate_here(Assembly& assembly) {
  const Model& model = assembly.model();
  Evaluation out;
  out.force.resize(3 * static_cast<std::size_t>(model.nodes));
  out.mass.resize(9 * static_cast<std::size_t>(model.nodes));
  assembly.residual(out.force.data());
  assembly.mass(out.mass.data());
  read_lines(assembly.lines(), 0, model.bars.count(), out.bar_tension, out.bar_length);
  for (const SlidingRope& rope : model.sliding) {
    for (const int bar : rope.bar) out.bar_tension[bar] = rope.tension(assembly.field());
  }
  read_cells(model, assembly.lines(), out);
  for (const ReportedForce& force : reported_forces()) out.forces.push_back(force.of(assembly));
  for (int p = 0; p < model.plates.count(); ++p) {
    out.plates.push_back(model.plates.attitude(p, assembly.field()));
  }
  for (const Vector& place : assembly.ground_places()) {
    out.ground_places.insert(out.ground_places.end(), place.data(), place.data() + 3);
  }
  return out;
}

}  // namespace codend
