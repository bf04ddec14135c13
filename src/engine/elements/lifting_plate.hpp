// Plates with lift: rigid bodies with six degrees of freedom. Angle of attack, heel and trim are
// results.
//
// A plate is three points, where lines are attached. Struts (lines that also push:
// TwineMaterial::strut) keep their distances. All other positions X of the plate (axes, centres,
// edges) move with them. With e1 = x1 - x0 and e2 = x2 - x0,
//   X = x0 + a e1 + b e2 + c e1 x e2.
// A force F at X acts on the three points by the gradient of X, so that force and moment are exact:
//
//   f1 = a F + c e2 x F,  f2 = b F + c F x e1,  f0 = F - f1 - f2.
//
// Hydrodynamic force at the centre of pressure, from the component U_p of the relative velocity U
// normal to the span s (flow along the span gives no lift):
//
//   L = 1/2 rho S C_L(alpha) |U_p| (+-s x U),
//   D = 1/2 rho S (C_D(alpha) |U_p|^2 + C_D(0) |U_s|^2) u
//
// alpha is the angle between U_p and the chord, positive if the flow meets the inner face.
//
// Mass: let q = (1, a, b, c) of a position, J the integral of q q^T over the body's mass, and x0,
// e1, e2, e1 x e2 the columns of Q. The kinetic energy is 1/2 tr(Q' J Q'^T) (natural coordinates:
// Garcia de Jalon and Bayo, Kinematic and Dynamic Simulation of Multibody Systems, 1994, ch. 4).
// The last column has the acceleration 2 e1' x e2' due to velocities alone. Its inertia is treated
// as a force.
//
// Added mass and damping of a plate that turns at rates q about its span and p about its chord. The
// rates are positive if the trailing edge and the upper edge move outward. n is the outward axis, m
// mid-chord.
//
// - Added mass in translation is m_a n d/dt(n . V), V the velocity of m relative to the water.
// - Added inertia in turning is m_a r^2, with one radius r about the span and one about the chord.
//   Four equal masses at m +- r_chord, +- r_span represent both. They have inertia only normal to
//   the face.
// - In turning, U is the velocity at the mirror image of the centre of pressure in m.
// - Couples 1/2 rho |U| S (c^2 C_q + C_N g^2) q and 1/2 rho |U| S s^2 C_p p act against q and p.
//   Here g is the distance from the centre of pressure to m. C_N, C_q and C_p are `normal_slope`,
//   `yaw_damping` and `roll_damping`.
//
// These terms reproduce the moment about m and the normal force in the linear theory of a thin
// plate in steady rotation. By reverse flow, the effect of q on the force equals the effect of the
// normal velocity on the moment, with opposite sign (Heaslet and Spreiter, NACA Report 1119, 1953).
// The terms are zero for a plate that does not turn.
#pragma once

#include "kind.hpp"
#include "polar.hpp"

namespace codend {

// Lengths in m in the plate's own axes: x from leading to trailing edge, z along the span, upward,
// y to starboard of a vertical plate along the flow. The origin is the middle of the leading edge.
// A level plate has its span across the flow, to port.
struct LiftingPlate {
  std::array<int, 3> node{};
  std::array<Vector, 3> attachment;
  double side = 1.0;   // +1: force to starboard or (level) up; -1: to port or down
  bool level = false;  // span horizontal
  double chord = 0.0, span = 0.0, area = 0.0;  // m, m, m2
  double height = 1.0;                         // vertical size at the free surface, m
  double pressure_centre = 0.5;                // from the leading edge, fraction of the chord
  bool pressure_wanders = false;               // centre of pressure from joessel_pressure_centre()
  double weight = 0.0, buoyancy = 0.0;         // N
  Vector gravity_centre = Vector::Zero(), buoyancy_centre = Vector::Zero();
  double mass = 0.0;                      // kg
  Vector second_moment = Vector::Zero();  // mass moment about the centre of gravity, by axis, kg m2
  double added_mass = 0.0;                // normal to the face, at water density 1 kg/m3, m3
  // Radii of the added mass in turning about the span and about the chord, m.
  double added_radius_chord = 0.0, added_radius_span = 0.0;
  // Derivatives of the normal force by the angle of attack, and of the moments by the rates of
  // turning.
  double normal_slope = 0.0, yaw_damping = 0.0, roll_damping = 0.0;
  double shoe_area = 0.0;  // ground contact area at each end of the lower edge, m2
  // Friction of the shoes on the ground, along the chord and across it, if own_friction is true.
  bool own_friction = false;
  double friction_along = 0.0, friction_across = 0.0;
  Polar polar;

  template <class Visit>
  void fields(Visit& visit) {
    visit("node", node, {1, Among::points});
    visit("attachment", attachment);
    visit("side", side);
    visit("level", level);
    visit("chord", chord);
    visit("span", span);
    visit("area", area);
    visit("height", height);
    visit("pressure_centre", pressure_centre);
    visit("pressure_wanders", pressure_wanders);
    visit("weight", weight);
    visit("buoyancy", buoyancy);
    visit("gravity_centre", gravity_centre);
    visit("buoyancy_centre", buoyancy_centre);
    visit("mass", mass);
    visit("second_moment", second_moment);
    visit("added_mass", added_mass);
    visit("added_radius_chord", added_radius_chord);
    visit("added_radius_span", added_radius_span);
    visit("normal_slope", normal_slope);
    visit("yaw_damping", yaw_damping);
    visit("roll_damping", roll_damping);
    visit("shoe_area", shoe_area);
    visit("own_friction", own_friction);
    visit("friction_along", friction_along);
    visit("friction_across", friction_across);
    visit.group("polar", polar);
  }
};

// Centre of pressure of a flat plate, as a fraction of the chord from the edge that meets the flow:
// 0.2 + 0.3 |sin alpha| (Joessel, 1873). Also returns its derivative by the angle of attack. The
// kink at 0 is rounded over a range of 0.01.
struct PressureCentre {
  double share, slope;
};
PressureCentre joessel_pressure_centre(double attack);

struct PlateAttitude {
  double attack = 0.0;  // rad
  double heel = 0.0;    // rad; positive: upper edge leans outward, or (level) starboard end is high
  double trim = 0.0;    // rad; positive if the leading edge is high
  double lift = 0.0, drag = 0.0;          // N, normal to the flow and along it
  Vector force = Vector::Zero();          // hydrodynamic, N
  Vector ground_force = Vector::Zero();   // N
  Vector lost_buoyancy = Vector::Zero();  // of the emerged part, N: downward
};

class LiftingPlates : public ElementKind {
 public:
  std::vector<LiftingPlate> plate;
  // Anchor point on the ground to which each shoe sticks (m), two per plate. If empty, shoes slide.
  // Time integration sets it.
  std::vector<Vector> anchor;

  // Call once after filling.
  void prepare();
  int count() const { return static_cast<int>(plate.size()); }
  int nodes_per_element() const override { return 3; }
  const std::vector<int>& nodes() const override { return node_; }
  void add_force(const Field& field, double* force) const override;
  void add_jacobian(const Field& field, const JacobianRequest& request,
                    const BlockSink& sink) const override;
  bool has_bodies() const override { return !plate.empty(); }
  double heaviest_body(const Field& field) const override;
  void add_body_mass(const Field& field, double factor, const BlockSink& sink) const override;
  void add_body_inertia(const Field& field, const double* acceleration,
                        double* force) const override;
  void add_drag_scale(const Field& field, double time, double* scale) const override;
  double unstable_size(const Field&) const override;  // smallest chord
  PlateAttitude attitude(int plate, const Field& field) const;
  // Positions of the shoes, two per plate, m.
  std::vector<Vector> shoes(const Field& field) const;
  // Updates the anchors after an accepted time step: a shoe that slips drags its anchor along.
  void draw_anchors(const Field& field);
  // Largest relative change of any side between attachment points, to first order, when points move
  // by dx (m).
  double turn(const double* dx) const;

 private:
  // A vector of the plate in terms of e1, e2 and e1 x e2.
  template <class Scalar>
  struct PartsOf {
    Scalar a = Scalar(0.0), b = Scalar(0.0), c = Scalar(0.0);
  };
  using Parts = PartsOf<double>;
  // Positions and vectors fixed to the plate.
  struct Fixed {
    Parts leading, chord, span, outward;  // position; unit vectors
    Parts gravity, buoyancy, middle, centre, shoe[2];
    Parts added[4];           // positions of the added mass
    Eigen::Matrix4d moments;  // J
  };
  using BodyMass = Eigen::Matrix<double, 9, 9>;
  template <class Scalar>
  struct Motion;
  Motion<double> motion_of(int plate, const Field& field) const;
  template <class Scalar>
  void add_forces(int plate, const Field& field, const Motion<Scalar>& motion,
                  Eigen::Matrix<Scalar, 3, 1> force[3], PlateAttitude* attitude) const;

  // Mass matrix of the three points, by all their components.
  BodyMass body_mass(std::size_t plate, const Field& field) const;

  // Subtracts inertia forces due to `bending`, the velocity-dependent acceleration of e1 x e2
  // (m/s2).
  template <class Scalar>
  static void hand_on_inertia(const Fixed& fixed, const Motion<Scalar>& motion,
                              const Eigen::Matrix<Scalar, 3, 1>& bending,
                              Eigen::Matrix<Scalar, 3, 1> force[3]);

  std::vector<int> node_;  // 3 per plate
  std::vector<Fixed> fixed_;
};

}  // namespace codend
