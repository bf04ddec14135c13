// Points of ropes, netting and rigid pieces that can touch the seabed (ground.hpp).
//
// The ground pushes and never pulls, as a rope pulls and never pushes. A solver therefore treats
// both in the same manner: normal forces may be dual unknowns (DualTension), stored after the
// tensions of the lines.
#pragma once

#include "kind.hpp"

namespace codend {

// Lines with different friction along and across their axis. At each point `node`, the axis is the
// line between the two points `between`.
struct LineFriction {
  std::vector<int> node, between;     // 1 and 2 per entry
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
  std::vector<double> area;       // contact area, m2
  std::vector<double> clearance;  // from the point to the underside, m

  template <class Visit>
  void fields(Visit& visit) {
    visit("node", node, {1, Among::points});
    visit("area", area);
    visit("clearance", clearance);
  }

  LineFriction lines;  // of the contacts with anisotropic friction
  // Anchor point on the ground to which each contact sticks, m. If empty, all contacts slide. Time
  // integration sets it.
  std::vector<Vector> anchor;

  int count() const { return static_cast<int>(node.size()); }
  // Call once after filling.
  void prepare();
  // Updates the anchors after an accepted time step: a contact that slips drags its anchor along.
  void draw_anchors(const Field& field);
  double penetration(int e, const Field& field) const {
    return field.ground->penetration(at(field.position, node[e]), clearance[e]);
  }
  // Adds the force on every contact to its point (N). press: dual normal forces (N); null: by the
  // contact law.
  void add_force(const Field& field, const double* press, double* force) const;
  // Force on one contact by the contact law, N.
  Vector element_force(int e, const Field& field) const;
  // modulus: of the dual normal forces, N/m; null: by the contact law.
  void add_jacobian(const Field& field, const JacobianRequest& request, const double* press,
                    const double* modulus, const BlockSink& sink) const;
  void add_drag_scale(const Field& field, double* scale) const;

 private:
  // Force of the ground per unit of normal force, and its derivatives (Ground::per_press()).
  Vector per_press(int e, const Field& field, Matrix* by_position = nullptr,
                   Matrix* by_velocity = nullptr) const;
  double law(int e, const Field& field, double& slope) const {
    double press;
    field.ground->press(penetration(e, field), area[e], press, slope);
    return press;
  }
  std::vector<int> line_;  // index of each contact in `lines`, or -1
};

}  // namespace codend
