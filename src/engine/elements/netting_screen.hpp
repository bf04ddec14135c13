// Netting as a screen: drag and lift of whole triangles of netting (netting_screen_law.hpp),
// instead of the sum over their twines.
//
// With S the triangle's area vector, A = |S|, n = S/A turned so that n.U >= 0, U the mean velocity
// of the water relative to its corners, cos th = n.U/|U| and Sn its solidity, from twine area / A:
//
//   F = 1/2 rho A |U|^2 (C_D U/|U| + C_L l),  l = n - cos th U/|U|, made a unit vector
//
// shared equally by the corners. Where twines of two families cross without a knot the crossing would
// count twice in their areas. With bars a, width d and angle b between the families the twine is
// s = 2 d / (a sin b) of the area and the crossings s^2 / 4, so that Sn = s - s^2/4 at every opening
// (2 d/a - (d/a)^2 in square meshes), 1 from s = 2 on. A triangle that closes up loses its area: Sn
// is held at the law's end, and the force goes to zero.
#pragma once

#include "kind.hpp"
#include "netting_screen_law.hpp"

namespace codend {

// A triangle in the flow.
struct ScreenFlow {
  Vector x[3], area;   // corners and S
  Vector u, slope[3];  // mean U, and its derivative by every corner's height
  double share[3];     // of every corner's own velocity in it
};
// height: over which the netting leaves the water, m.
ScreenFlow screen_flow(const Field& field, const int* node, double height);
// Derivative of S by the place of corner l.
Matrix area_slope(const ScreenFlow& flow, int l);

// Force (N) on a whole triangle and its derivatives by S and U.
struct ScreenForce {
  Vector value = Vector::Zero();
  Matrix by_area = Matrix::Zero(), by_velocity = Matrix::Zero();
};
// twine_area (m2), overlap, diameter (m) and multiplicity as of NettingScreens.
ScreenForce screen_force(NettingScreenLaw law, const ScreenFlow& flow, double twine_area,
                         double overlap, double diameter, double multiplicity, const Water& water);

class NettingScreens : public ElementKind {
 public:
  std::vector<int> node;             // 3 per triangle
  std::vector<double> twine_area;    // projected area of its twine and knots, m2
  std::vector<double> overlap;       // Sn = s - overlap s^2: 1/4, or 0 where crossings are knots
  std::vector<double> diameter;      // of the twine, m
  std::vector<double> height;        // over which they leave the water, m
  std::vector<double> multiplicity;  // 1, or 1/2 where two triangulations share a cell
  std::vector<NettingScreenLaw> law;

  template <class Visit>
  void fields(Visit& visit) {
    visit("node", node, {3, Among::points});
    visit("twine_area", twine_area);
    visit("overlap", overlap);
    visit("diameter", diameter);
    visit("height", height);
    visit("multiplicity", multiplicity);
    visit("law", law);
  }

  int count() const { return static_cast<int>(law.size()); }
  int nodes_per_element() const override { return 3; }
  const std::vector<int>& nodes() const override { return node; }
  void add_force(const Field& field, double* force) const override;
  // Force (N) on the whole triangle.
  Vector element_force(int e, const Field& field) const;
  void add_jacobian(const Field& field, const JacobianRequest& request,
                    const BlockSink& sink) const override;
  void add_added_mass(const Field&, double*) const override {}
  void add_drag_scale(const Field& field, double* scale) const override;

 private:
  ScreenFlow flow(int e, const Field& field) const {
    return screen_flow(field, &node[3 * static_cast<std::size_t>(e)],
                       height[static_cast<std::size_t>(e)]);
  }
  ScreenForce force(int e, const ScreenFlow& flow, const Water& water) const;
};

}  // namespace codend
