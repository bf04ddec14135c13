// Plates with lift as rigid bodies with six degrees of freedom, which find their own angle of attack,
// heel and trim.
//
// A plate is three points, the places where lines are fastened to it, held at their distances by struts
// (lines that also push: TwineMaterial::strut). What else belongs to it, its axes, centres and edges,
// goes with them: with e1 = x1 - x0 and e2 = x2 - x0,
//
//   X = x0 + a e1 + b e2 + c e1 x e2,
//
// which turns and moves as the three points do. A force F at X acts on them as the gradient of X
// says, so that force and moment are both exact:
//   f1 = a F + c e2 x F,  f2 = b F + c F x e1,  f0 = F - f1 - f2.
//
// Hydrodynamic force, at the centre of pressure, by the part U_p of the relative velocity U across
// the span s (the flow along the span passes without lift):
//   L = 1/2 rho S C_L(alpha) |U_p| (+-s x U),  D = 1/2 rho S (C_D(alpha) |U_p|^2 + C_D(0) |U_s|^2) u
// alpha is the angle of U_p to the chord, positive where the flow meets the inner face.
//
// Mass: with q = (1, a, b, c) of a place and J the integral of q q^T over the body's mass, and x0, e1,
// e2, e1 x e2 the columns of Q, the kinetic energy is 1/2 tr(Q' J Q'^T) (natural coordinates: Garcia
// de Jalon and Bayo, Kinematic and Dynamic Simulation of Multibody Systems, 1994, ch. 4). What of the
// accelerations of its points is due to their velocities alone, 2 e1' x e2' of the last column, is a
// force like any other.
//
// Water, for a plate that turns at rates q about its span and p about its chord (positive where the
// trailing, the upper edge moves outward), n its outward axis, m mid-chord:
//   added mass   m_a n d/dt(n . V), V the velocity of m in the water, of translation, and
//                m_a r^2 of turning, with a radius r each about span and chord: four equal masses
//                that only move across the face, at m +- r_chord, +- r_span;
//   turning      U is that at the mirror image of the centre of pressure in m, and against q and p
//                there are couples 1/2 rho |U| S (c^2 C_q + C_N g^2) q and 1/2 rho |U| S s^2 C_p p,
//                g the way from the centre of pressure to m and C_N, C_q, C_p its normal_slope,
//                yaw_damping and roll_damping.
// In the linear theory of a thin plate in steady rotation that is what its moment about m is, and its
// normal force: q makes of the force what the normal velocity makes of the moment, with the other
// sign (by reverse flow: Heaslet and Spreiter, NACA Report 1119, 1953). A plate that moves without
// turning knows nothing of it.
#pragma once

#include "kind.hpp"
#include "polar.hpp"

namespace codend {

// Lengths in m in the plate's own axes: x from its leading to its trailing edge, z along its span,
// up, y to starboard of a plate that stands upright along the flow. Origin: the middle of the
// leading edge. A level plate has its span across the flow, to port.
struct LiftingPlate {
  std::array<int, 3> node{};
  std::array<Vector, 3> attachment;
  double side = 1.0;   // +1: pushes to starboard or, level, up; -1: to port or down
  bool level = false;  // whether its span lies level
  double chord = 0.0, span = 0.0, area = 0.0;  // m, m, m2
  double height = 1.0;                         // over which it leaves the water, m
  double pressure_centre = 0.5;                // on the chord, share of it from the leading edge
  bool pressure_wanders = false;        // with the angle of attack, see pressure_centre() below
  double weight = 0.0, buoyancy = 0.0;  // N
  Vector gravity_centre = Vector::Zero(), buoyancy_centre = Vector::Zero();
  double mass = 0.0;                      // kg
  Vector second_moment = Vector::Zero();  // of its mass about its centre of gravity, by axis, kg m2
  double added_mass = 0.0;                // across its face, at density 1 kg/m3 of water, m3
  // Of the added mass where it turns about its span and about its chord, along these, m.
  double added_radius_chord = 0.0, added_radius_span = 0.0;
  // Of the normal force by the angle of attack, of the moments by the rates of turning.
  double normal_slope = 0.0, yaw_damping = 0.0, roll_damping = 0.0;
  double shoe_area = 0.0;  // on the ground, m2, at each end of the lower edge
  // Of the shoes on the ground, along the chord and across it, where they have their own.
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

// Where lift and drag act on a flat plate, share of its chord from the edge that meets the flow:
// 0.2 + 0.3 |sin alpha| (Joessel, 1873), and its derivative by the angle of attack; the kink at 0 is
// rounded, over a hundredth.
struct PressureCentre {
  double share, slope;
};
PressureCentre joessel_pressure_centre(double attack);

// How a plate stands and what the water does to it.
struct PlateAttitude {
  double attack = 0.0;  // rad
  double heel = 0.0;    // rad; positive where the upper edge leans outward, of a level plate where
                        // its starboard end is high
  double trim = 0.0;    // rad; positive where the leading edge is high
  double lift = 0.0, drag = 0.0;          // N, across and along the flow
  Vector force = Vector::Zero();          // hydrodynamic, N
  Vector ground_force = Vector::Zero();   // N
  Vector lost_buoyancy = Vector::Zero();  // above the surface, N: downward
};

class LiftingPlates : public ElementKind {
 public:
  std::vector<LiftingPlate> plate;
  // Where each shoe sticks to the ground (m), two per plate; empty: they slide. It is for a march to
  // set.
  std::vector<Vector> anchor;

  // Call once after filling.
  void prepare();
  int count() const { return static_cast<int>(plate.size()); }
  int nodes_per_element() const override { return 3; }
  const std::vector<int>& nodes() const override { return node_; }
  void add_force(const Field& field, double* force) const override;
  void add_jacobian(const Field& field, const JacobianRequest& request,
                    const BlockSink& sink) const override;
  void add_added_mass(const Field&, double*) const override {}
  bool has_bodies() const override { return !plate.empty(); }
  double heaviest_body(const Field& field) const override;
  void add_body_mass(const Field& field, double factor, const BlockSink& sink) const override;
  void add_body_inertia(const Field& field, const double* acceleration,
                        double* force) const override;
  void add_drag_scale(const Field& field, double* scale) const override;
  double unstable_size(const Field&) const override;  // the least chord
  PlateAttitude attitude(int plate, const Field& field) const;
  // Places of the shoes, two per plate, m.
  std::vector<Vector> shoes(const Field& field) const;
  // Lets every shoe stick where it is (after a step that was taken), which draws the anchors of those
  // that slip along.
  void draw_anchors(const Field& field);
  // Largest change of any plate's sides over their length, to first order, when points move by dx (m).
  double turn(const double* dx) const;

 private:
  // A vector of the plate in terms of e1, e2 and e1 x e2.
  template <class Scalar>
  struct PartsOf {
    Scalar a = Scalar(0.0), b = Scalar(0.0), c = Scalar(0.0);
  };
  using Parts = PartsOf<double>;
  // What of a plate goes with its points.
  struct Fixed {
    Parts leading, chord, span, outward;  // place; unit vectors
    Parts gravity, buoyancy, middle, centre, shoe[2];
    Parts added[4];           // places of the added mass
    Eigen::Matrix4d moments;  // J
  };
  using BodyMass = Eigen::Matrix<double, 9, 9>;
  template <class Scalar>
  struct Motion;
  Motion<double> motion_of(int plate, const Field& field) const;
  template <class Scalar>
  void add_forces(int plate, const Field& field, const Motion<Scalar>& motion,
                  Eigen::Matrix<Scalar, 3, 1> force[3], PlateAttitude* attitude) const;

  // Of three points, by all their components.
  BodyMass body_mass(std::size_t plate, const Field& field) const;

  // Takes off what mass makes of accelerations that are due to velocities, m/s2 of e1 x e2.
  template <class Scalar>
  static void hand_on_inertia(const Fixed& fixed, const Motion<Scalar>& motion,
                              const Eigen::Matrix<Scalar, 3, 1>& bending,
                              Eigen::Matrix<Scalar, 3, 1> force[3]);

  std::vector<int> node_;  // 3 per plate
  std::vector<Fixed> fixed_;
};

}  // namespace codend
