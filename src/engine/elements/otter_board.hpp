// Otter boards, kites and depressors as rigid bodies with six degrees of freedom, which find their
// own angle of attack, heel and trim.
//
// A board is three points, the places where its warp and backstrops are fastened, held at their
// distances by struts (lines that also push: TwineMaterial::strut). What else belongs to it, its
// axes, centres and edges, goes with them: with e1 = x1 - x0 and e2 = x2 - x0,
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
// alpha is the angle of U_p to the chord, positive where the flow meets the inner face. Added mass
// is that of a plate across its face (DNV-RP-C205), spread over the three points.
#pragma once

#include "../base/ground.hpp"
#include "kind.hpp"
#include "polar.hpp"

namespace codend {

// Lengths in m in the board's own axes: x from its leading to its trailing edge, z along its span,
// up, y to starboard of a board that stands upright along the flow. Origin: the middle of the
// leading edge. Kites and depressors are boards whose span lies level, to port.
struct OtterBoard {
  Vector attachment[3];
  double side = 1.0;           // +1: pushes to starboard or, level, up; -1: to port or down
  bool level = false;          // whether a kite or depressor
  double chord = 0.0, span = 0.0, area = 0.0;  // m, m, m2
  double height = 1.0;           // over which it leaves the water, m
  double pressure_centre = 0.5;  // on the chord, share of it from the leading edge
  bool pressure_wanders = false; // with the angle of attack, see pressure_centre() below
  double weight = 0.0, buoyancy = 0.0;  // N
  Vector gravity_centre = Vector::Zero(), buoyancy_centre = Vector::Zero();
  double added_mass = 0.0;       // across its face, at density 1 kg/m3 of water, m3
  double shoe_area = 0.0;        // on the ground, m2, at each end of the lower edge
  Polar polar;
};

// Where lift and drag act on a flat plate, share of its chord from the edge that meets the flow:
// 0.2 + 0.3 |sin alpha| (Joessel, 1873), and its derivative by the angle of attack; the kink at 0 is
// rounded, over a hundredth.
struct PressureCentre {
  double share, slope;
};
PressureCentre joessel_pressure_centre(double attack);

// How a board stands and what the water does to it.
struct BoardAttitude {
  double attack = 0.0;  // rad
  double heel = 0.0;    // rad; positive where the upper edge leans outward, of a level board where
                        // its starboard end is high
  double trim = 0.0;    // rad; positive where the leading edge is high
  double lift = 0.0, drag = 0.0;         // N, across and along the flow
  Vector force = Vector::Zero();         // hydrodynamic, N
  Vector ground_force = Vector::Zero();  // N
  double lost_buoyancy = 0.0;            // above the surface, N, upward: not positive
};

class OtterBoards : public ElementKind {
 public:
  std::vector<int> node;  // 3 per board
  std::vector<OtterBoard> board;
  Ground ground;

  // Call once after filling.
  void prepare();
  int count() const { return static_cast<int>(board.size()); }
  int nodes_per_element() const override { return 3; }
  const std::vector<int>& nodes() const override { return node; }
  void add_force(const Field& field, double* force) const override;
  void add_jacobian(const Field& field, const JacobianRequest& request,
                    const BlockSink& sink) const override;
  void add_added_mass(const Field& field, double* mass) const override;
  void add_drag_scale(const Field& field, double* scale) const override;
  BoardAttitude attitude(int board, const Field& field) const;

 private:
  // A vector of the board in terms of e1, e2 and e1 x e2.
  template <class Scalar>
  struct PartsOf {
    Scalar a = Scalar(0.0), b = Scalar(0.0), c = Scalar(0.0);
  };
  using Parts = PartsOf<double>;
  // What of a board goes with its points.
  struct Fixed {
    Parts leading, chord, span, outward;  // place; unit vectors
    Parts gravity, buoyancy, middle, shoe[2];
  };
  template <class Scalar>
  struct Motion;
  template <class Scalar>
  void add_forces(int board, const Field& field, const Motion<Scalar>& motion,
                  Eigen::Matrix<Scalar, 3, 1> force[3], BoardAttitude* attitude) const;

  std::vector<Fixed> fixed_;
};

}  // namespace codend
