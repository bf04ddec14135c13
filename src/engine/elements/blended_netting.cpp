#include "blended_netting.hpp"

#include <algorithm>
#include <cmath>

namespace codend {
namespace {

// Cosines of 60 and 80 degrees.
constexpr double first_cosine = 0.5, last_cosine = 0.17364817766693034;
constexpr double screen_solidity = 0.05, open_solidity = 0.35, closed_solidity = 1.0;

// Sets `value` to a cubic that rises from 0 at `first` to 1 at `last`, and `slope` to its
// derivative by x.
void rise(double x, double first, double last, double& value, double& slope) {
  const double s = std::clamp((x - first) / (last - first), 0.0, 1.0);
  value = s * s * (3.0 - 2.0 * s);
  slope = 6.0 * s * (1.0 - s) / (last - first);
}

}  // namespace

void BlendedNetting::prepare() {
  shape_.clear();
  for (std::size_t e = 0; e < rest.size(); ++e) shape_.push_back(cell_shape(&twine[8 * e]));
}

double BlendedNetting::bars(int e) const {
  const std::size_t i = static_cast<std::size_t>(e);
  return shape_[i].bars * multiplicity[i];
}

BlendedNetting::Blended BlendedNetting::blended(int e, const Field& field) const {
  const std::size_t i = static_cast<std::size_t>(e);
  const Water& water = *field.water;
  const TwineMaterial& m = materials[static_cast<std::size_t>(material[i])];
  Blended out;
  const CellShape& shape = shape_[i];
  out.flow = screen_flow(field, shape, &node[4 * i], height[i]);
  const Vector& u = out.flow.u;
  Vector vector[2] = {Vector::Zero(), Vector::Zero()};
  for (int k = 1; k < 4; ++k) {
    for (int f = 0; f < 2; ++f) vector[f] += shape.along[f][k] * (out.flow.x[k] - out.flow.x[0]);
  }
  const double metres = bars(e) * rest[i];
  TwineDrag drag[2];
  for (int f = 0; f < 2; ++f) {
    drag[f] = twine_drag(m, metres, rest[i], vector[f], u, water, slack);
  }
  out.force =
      screen_force(NettingScreenLaw::kristiansen_faltinsen, out.flow, 2.0 * metres * m.diameter,
                   overlap[i], m.diameter, multiplicity[i], water, multipliers);

  const double area = out.flow.area.norm(), speed = u.norm();
  double w = 0.0;
  // Derivatives of w.
  Eigen::RowVector3d by_area = Eigen::RowVector3d::Zero(), by_velocity = by_area;
  if (area > 0.0 && speed > 0.0) {
    const double along = out.flow.area.dot(u), sign = along < 0.0 ? -1.0 : 1.0;
    const double cosine = std::abs(along) / (area * speed);
    const double solidity = 2.0 * metres * m.diameter / (multiplicity[i] * area);
    double lies, lies_slope, shields, shields_slope, closes, closes_slope;
    rise(cosine, first_cosine, last_cosine, lies, lies_slope);
    rise(solidity, 0.0, screen_solidity, shields, shields_slope);
    rise(solidity, open_solidity, closed_solidity, closes, closes_slope);
    const double screens = shields * (1.0 - closes);
    const double by_solidity = shields_slope * (1.0 - closes) - shields * closes_slope;
    w = lies * screens;
    const Eigen::RowVector3d normal = out.flow.area.transpose() / area;
    by_area =
        screens * lies_slope * (sign / (area * speed) * u.transpose() - cosine / area * normal) -
        lies * by_solidity * solidity / area * normal;
    by_velocity =
        screens * lies_slope * (sign / speed * normal - cosine / (speed * speed) * u.transpose());
  }
  const Vector sum = drag[0].value + drag[1].value, change = out.force.value - sum;
  out.force.value = (1.0 - w) * sum + w * out.force.value;
  out.force.by_area = w * out.force.by_area + change * by_area;
  out.force.by_velocity = w * out.force.by_velocity + change * by_velocity +
                          (1.0 - w) * (drag[0].by_velocity + drag[1].by_velocity);
  for (int f = 0; f < 2; ++f) out.by_vector[f] = (1.0 - w) * drag[f].by_vector;
  return out;
}

Vector BlendedNetting::element_force(int e, const Field& field) const {
  return blended(e, field).force.value;
}

void BlendedNetting::add_force(const Field& field, double* out) const {
  for (int e = 0; e < count(); ++e) {
    const std::size_t i = static_cast<std::size_t>(e);
    const Vector whole = element_force(e, field);
    for (std::size_t k = 0; k < 4; ++k) at(out, node[4 * i + k]) += shape_[i].share[k] * whole;
  }
}

void BlendedNetting::add_jacobian(const Field& field, const JacobianRequest& request,
                                  const BlockSink& sink) const {
  for (int e = 0; e < count(); ++e) {
    const CellShape& shape = shape_[static_cast<std::size_t>(e)];
    const Blended s = blended(e, field);
    for (int l = 0; l < 4; ++l) {
      Matrix by = s.force.by_area * area_slope(s.flow, l);
      for (int f = 0; f < 2; ++f) by += shape.along[f][l] * s.by_vector[f];
      Matrix block =
          -request.stiffness * by + request.damping * s.flow.own[l] * s.force.by_velocity;
      block.col(2) -= request.stiffness * (s.force.by_velocity * s.flow.slope[l]);
      for (int k = 0; k < 4; ++k) sink.add(e, k, l, (shape.share[k] * block).eval());
    }
  }
}

void BlendedNetting::add_drag_scale(const Field& field, double* scale) const {
  for (int e = 0; e < count(); ++e) {
    const std::size_t i = static_cast<std::size_t>(e);
    const TwineMaterial& m = materials[static_cast<std::size_t>(material[i])];
    // Drag coefficient of about 1.2 on the twine area, as for screens.
    const double whole = 1.2 * field.water->density * bars(e) * rest[i] * m.diameter *
                         screen_flow(field, shape_[i], &node[4 * i], height[i]).u.norm();
    for (std::size_t k = 0; k < 4; ++k) scale[node[4 * i + k]] += shape_[i].share[k] * whole;
  }
}

}  // namespace codend
