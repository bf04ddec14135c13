// Bodies at one point with lift at a fixed angle of attack, such as plates, sheets of canvas and
// depressors. Lift is perpendicular to the flow.
//   F = 1/2 rho |U|^2 A_L l,  l = (I - u u^T) r / |(I - u u^T) r|,  u = U/|U|
// A_L = C_L A is the lift area. The direction r is up (0, 0, 1) or sideways, z x u: to starboard of
// the flow, so that a plate continues to push outward while the gear turns. A Sphere adds the drag.
#pragma once

#include "kind.hpp"

namespace codend {

enum class LiftDirection { up, sideways };
constexpr std::array<const char*, 2> names_of(LiftDirection) { return {"up", "sideways"}; }

class LiftingSurfaces : public ElementKind {
 public:
  std::vector<int> node;
  std::vector<double> lift_area;  // C_L A, m2; negative: downward or to port
  std::vector<LiftDirection> direction;
  std::vector<double> height;  // vertical size at the free surface, m

  template <class Visit>
  void fields(Visit& visit) {
    visit("node", node, {1, Among::points});
    visit("lift_area", lift_area);
    visit("direction", direction);
    visit("height", height);
  }

  int count() const { return static_cast<int>(node.size()); }
  int nodes_per_element() const override { return 1; }
  const std::vector<int>& nodes() const override { return node; }
  void add_force(const Field& field, double* force) const override;
  // Force (N) on one element.
  Vector element_force(int e, const Field& field) const;
  void add_jacobian(const Field& field, const JacobianRequest& request,
                    const BlockSink& sink) const override;
  void add_drag_scale(const Field& field, double, double* scale) const override;

 private:
  // Force / (1/2 rho A_L) and its derivative by U.
  static void lift(LiftDirection direction, const Vector& u, Vector& value, Matrix& by_velocity);
};

}  // namespace codend
