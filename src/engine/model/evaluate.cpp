#include "evaluate.hpp"

#include <cmath>

namespace codend {
namespace {

// Numbers [first, first + count) of lines whose drag is shared by `points` equal points.
void read_lines(const LineArrays& lines, int points, int first, int count,
                std::vector<double>& tension, std::vector<double>& length,
                std::vector<double>& drag) {
  tension.assign(lines.tension + first, lines.tension + first + count);
  length.resize(static_cast<std::size_t>(count));
  drag.resize(3 * static_cast<std::size_t>(count), 0.0);
  for (int k = 0; k < count; ++k) {
    const int line = first + k;
    length[k] = Vector(lines.e[0][line], lines.e[1][line], lines.e[2][line]).norm();
    at(drag.data(), k) += points * Vector(lines.drag[0][line], lines.drag[1][line],
                                          lines.drag[2][line]);
  }
}

// Force of every one-point element: the kind is asked once, with one place per element.
template <class Kind>
std::vector<double> point_forces(const Kind& kind, const Field& field) {
  std::vector<double> out(3 * static_cast<std::size_t>(kind.count()), 0.0);
  for (int e = 0; e < kind.count(); ++e) kind.add_element_force(e, field, &out[3 * e]);
  return out;
}

template <class Kind>
std::vector<double> element_forces(const Kind& kind, const Field& field) {
  std::vector<double> out(3 * static_cast<std::size_t>(kind.count()));
  for (int e = 0; e < kind.count(); ++e) at(out.data(), e) = kind.element_force(e, field);
  return out;
}

void read_hexagons(const Model& model, const LineArrays& lines, Evaluation& out) {
  const int hexagons = model.hexagons.count(), first = model.hexagons.first_line;
  std::vector<double> drag;
  read_lines(lines, 1, first, 3 * hexagons, out.hexagon_tension, out.hexagon_length, drag);
  out.hexagon_drag.assign(3 * static_cast<std::size_t>(hexagons), 0.0);
  for (int which = 0; which < 3; ++which) {
    for (int e = 0; e < hexagons; ++e) {
      at(out.hexagon_drag.data(), e) += at(drag.data(), which * hexagons + e);
    }
  }
}

}  // namespace

Evaluation evaluate(Assembly& assembly, const double* x, const double* v) {
  const Model& model = assembly.model();
  Evaluation out;
  out.force.resize(3 * static_cast<std::size_t>(model.nodes));
  out.mass.resize(9 * static_cast<std::size_t>(model.nodes));
  assembly.move_to(x, v);
  assembly.residual(out.force.data());
  assembly.mass(out.mass.data());
  const int bars = model.bars.count(), triangles = model.triangles.count();
  const LineArrays& lines = assembly.lines();
  read_lines(lines, 2, 0, bars, out.bar_tension, out.bar_length, out.bar_drag);
  for (const SlidingRope& rope : model.sliding) {
    for (const int bar : rope.bar) out.bar_tension[bar] = rope.tension(assembly.field());
  }
  read_lines(lines, 3, bars, triangles, out.u_tension, out.u_length, out.triangle_drag);
  read_lines(lines, 3, bars + triangles, triangles, out.v_tension, out.v_length,
             out.triangle_drag);
  read_hexagons(model, lines, out);
  out.sphere_drag = point_forces(model.spheres, assembly.field());
  out.lift_force = point_forces(model.lifts, assembly.field());
  out.catch_force = element_forces(model.pressure, assembly.field());
  out.screen_force = element_forces(model.drag_screens, assembly.field());
  out.blended_force = element_forces(model.blended, assembly.field());
  out.contact_force = point_forces(model.contacts, assembly.field());
  out.volume_force = point_forces(model.volumes, assembly.field());
  for (int b = 0; b < model.boards.count(); ++b) {
    out.boards.push_back(model.boards.attitude(b, assembly.field()));
  }
  return out;
}

}  // namespace codend
