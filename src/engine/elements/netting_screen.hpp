// Netting as a screen: drag and lift of whole triangles of netting (netting_screen_law.hpp), instead
// of the sum over their twines.
//
// With S the triangle's area vector, A = |S|, n = S/A turned so that n.U >= 0, U the mean velocity of
// the water relative to its corners, cos th = n.U/|U| and Sn = twine area / A:
//
//   F = 1/2 rho A |U|^2 (C_D U/|U| + C_L l),  l = n - cos th U/|U|, made a unit vector
//
// shared equally by the corners. A triangle that closes up loses its area: Sn is held at the law's
// end, and the force goes to zero.
#pragma once

#include "kind.hpp"
#include "netting_screen_law.hpp"

namespace codend {

class NettingScreens : public ElementKind {
 public:
  std::vector<int> node;             // 3 per triangle
  std::vector<double> twine_area;    // projected area of its twine and knots, m2
  std::vector<double> diameter;      // of the twine, m
  std::vector<double> multiplicity;  // 1, or 1/2 where two triangulations share a cell
  std::vector<int> law;              // NettingScreenLaw

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
  struct Flow {
    Vector x[3], area;   // corners and S
    Vector u, slope[3];  // mean U, and its derivative by every corner's height
  };
  Flow flow(int e, const Field& field) const;
  // Force and its derivatives by S and U.
  void force(int e, const Flow& flow, const Water& water, Vector& value, Matrix& by_area,
             Matrix& by_velocity) const;
};

}  // namespace codend
