// Points of ropes, netting and pieces that may lie on the sea bed (ground.hpp).
//
// The ground pushes and never pulls, as a rope pulls and never pushes, so a solver treats both
// alike: normal forces may be dual unknowns (DualTension), behind the tensions of the lines.
#pragma once

#include "kind.hpp"

namespace codend {

// Lines on the ground that rub differently along and across themselves: at a point, on the way between
// two others.
struct LineFriction {
  std::vector<int> node, between;     // 1 and 2 each
  std::vector<double> along, across;  // coefficients of friction

  template <class Visit>
  void fields(Visit& visit) {
    visit("node", node, {1, Among::points});
    visit("between", between, {2, Among::points});
    visit("along", along);
    visit("across", across);
  }
  bool present() const { return !node.empty(); }
};

class GroundContacts {
 public:
  std::vector<int> node;
  std::vector<double> area;       // on the ground, m2
  std::vector<double> clearance;  // from the point to the underside, m

  template <class Visit>
  void fields(Visit& visit) {
    visit("node", node, {1, Among::points});
    visit("area", area);
    visit("clearance", clearance);
  }

  LineFriction lines;  // of some contacts
  // Where each contact sticks to the ground (m), along it; empty: they slide. It is for a march to set.
  std::vector<Vector> anchor;

  int count() const { return static_cast<int>(node.size()); }
  // Call once after filling.
  void prepare();
  // Lets every contact stick where it is (after a step that was taken), which draws the anchors of
  // those that slip along.
  void draw_anchors(const Field& field);
  double penetration(int e, const Field& field) const {
    return field.ground->penetration(at(field.position, node[e]), clearance[e]);
  }
  // Adds every contact's force (N) to its point; press: dual normal forces (N), null for the
  // law's.
  void add_force(const Field& field, const double* press, double* force) const;
  // Force (N) on one contact, by the law.
  Vector element_force(int e, const Field& field) const;
  // modulus: of the dual forces (N/m), null for the law's.
  void add_jacobian(const Field& field, const JacobianRequest& request, const double* press,
                    const double* modulus, const BlockSink& sink) const;
  void add_drag_scale(const Field& field, double* scale) const;

 private:
  // Force of the ground per normal force, and its derivatives.
  Vector per_press(int e, const Field& field, Matrix& by_position, Matrix& by_velocity) const;
  double law(int e, const Field& field, double& slope) const {
    double press;
    field.ground->press(penetration(e, field), area[e], press, slope);
    return press;
  }
  std::vector<int> line_;  // of every contact its place among `lines`, -1: none
};

}  // namespace codend
