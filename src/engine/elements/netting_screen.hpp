// Screen drag model: drag and lift of a whole netting cell (netting_screen_drag.hpp) instead of
// Morison-type (twine-by-twine) drag.
//
// Let S = 1/2 (x2-x0) x (x3-x1) be the cell's area vector, A = |S|, and n = S/A with the sign that
// makes n.U >= 0. U is the mean velocity of the water relative to the cell, cos th = n.U/|U|, and
// Sn its solidity from twine area / A (base/solidity.hpp). Then
//   F = 1/2 rho A |U|^2 (C_D U/|U| + C_L l),  l = n - cos th U/|U|, made a unit vector.
// The corners share F and U as an evenly distributed load (cell_shape.hpp). The area of a closing
// cell vanishes: Sn is bounded by the range of the drag model, and the force tends to zero.
#pragma once

#include "cell_shape.hpp"
#include "kind.hpp"
#include "netting_screen_drag.hpp"

namespace codend {

// Flow at a cell.
struct ScreenFlow {
  Vector x[4], area;   // corners and S
  Vector u, slope[4];  // mean U, and its derivative by the height of each corner
  double own[4];       // fraction of each corner's own velocity in U
};
// node: 4 corners; height: vertical size of the netting at the free surface, m.
ScreenFlow screen_flow(const Field& field, const CellShape& shape, const int* node, double height);
// Derivative of S by the position of corner l.
Matrix area_slope(const ScreenFlow& flow, int l);

// Force (N) on a whole cell and its derivatives by S and U.
struct ScreenForce {
  Vector value = Vector::Zero();
  Matrix by_area = Matrix::Zero(), by_velocity = Matrix::Zero();
};
// twine_area (m2), overlap, diameter (m) and multiplicity: see NettingScreens.
ScreenForce screen_force(NettingScreenLaw law, const ScreenFlow& flow, double twine_area,
                         double overlap, double diameter, double multiplicity, const Water& water,
                         ScreenMultipliers multipliers = {});

class NettingScreens : public ElementKind {
 public:
  std::vector<int> node;             // 4 per cell; a triangle repeats its last corner
  std::vector<double> twine;         // u0 v0 ... u3 v3 per cell
  std::vector<double> twine_area;    // projected area of twine and knots, m2
  std::vector<double> overlap;       // Sn = s - overlap s^2: 1/4, or 0 if crossings are knots
  std::vector<double> diameter;      // of the twine, m
  std::vector<double> height;        // vertical size at the free surface, m
  std::vector<double> multiplicity;  // 1, or 1/2 where two triangulations overlap
  std::vector<NettingScreenLaw> law;
  ScreenMultipliers multipliers;

  template <class Visit>
  void fields(Visit& visit) {
    visit("node", node, {4, Among::points});
    visit("twine", twine, {8});
    visit("twine_area", twine_area);
    visit("overlap", overlap);
    visit("diameter", diameter);
    visit("height", height);
    visit("multiplicity", multiplicity);
    visit("law", law);
  }

  int count() const { return static_cast<int>(law.size()); }
  // Call once after filling.
  void prepare();
  int nodes_per_element() const override { return 4; }
  const std::vector<int>& nodes() const override { return node; }
  void add_force(const Field& field, double* force) const override;
  // Force on the whole cell, N.
  Vector element_force(int e, const Field& field) const;
  void add_jacobian(const Field& field, const JacobianRequest& request,
                    const BlockSink& sink) const override;
  void add_added_mass(const Field&, double*) const override {}
  void add_drag_scale(const Field& field, double* scale) const override;

 private:
  ScreenFlow flow(int e, const Field& field) const {
    const std::size_t i = static_cast<std::size_t>(e);
    return screen_flow(field, shape_[i], &node[4 * i], height[i]);
  }
  ScreenForce force(int e, const ScreenFlow& flow, const Water& water) const;
  std::vector<CellShape> shape_;
};

}  // namespace codend
