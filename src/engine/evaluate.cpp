#include "evaluate.hpp"

namespace codend {
namespace {

template <int N>
void read_line(const Line<N>& line, const Field& field, std::vector<double>& tension,
               std::vector<double>& length, Eigen::Map<Vector> drag) {
  const Vector e = line.vector(field.position);
  length.push_back(e.norm());
  tension.push_back(twine_tension(*line.material, e.norm(), line.rest));
  Vector u, slope;
  line.relative_velocity(field, u, slope);
  drag += line.multiplicity *
          twine_drag(*line.material, *field.water, field.slack, e, line.rest, u, false).force;
}

// Force of every one-point element: the kind is asked once, with one place per element.
template <class Kind>
std::vector<double> point_forces(const Kind& kind, const Field& field) {
  std::vector<double> out(3 * static_cast<std::size_t>(kind.count()), 0.0);
  for (int e = 0; e < kind.count(); ++e) kind.add_element_force(e, field, &out[3 * e]);
  return out;
}

}  // namespace

Evaluation evaluate(Assembly& assembly, const double* x, const double* v) {
  const Model& model = assembly.model();
  Evaluation out;
  out.force.resize(3 * static_cast<std::size_t>(model.nodes));
  out.mass.resize(9 * static_cast<std::size_t>(model.nodes));
  assembly.residual(x, v, out.force.data());
  assembly.mass(x, v, out.mass.data());
  const Field field = assembly.field(x, v);
  out.bar_drag.assign(3 * static_cast<std::size_t>(model.bars.count()), 0.0);
  for (int b = 0; b < model.bars.count(); ++b) {
    read_line(model.bars.line(b), field, out.bar_tension, out.bar_length,
              at(out.bar_drag.data(), b));
  }
  out.triangle_drag.assign(3 * static_cast<std::size_t>(model.triangles.count()), 0.0);
  for (int e = 0; e < model.triangles.count(); ++e) {
    const Eigen::Map<Vector> drag = at(out.triangle_drag.data(), e);
    read_line(model.triangles.u_line(e), field, out.u_tension, out.u_length, drag);
    read_line(model.triangles.v_line(e), field, out.v_tension, out.v_length, drag);
  }
  out.sphere_drag = point_forces(model.spheres, field);
  out.lift_force = point_forces(model.lifts, field);
  return out;
}

}  // namespace codend
