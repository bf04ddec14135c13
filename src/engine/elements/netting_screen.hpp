// Netting as a screen: drag and lift of whole cells of netting (netting_screen_law.hpp), instead of
// the sum over their twines.
//
// With S = 1/2 (x2-x0) x (x3-x1) the cell's area vector, A = |S|, n = S/A turned so that n.U >= 0, U
// the mean velocity of the water relative to it, cos th = n.U/|U| and Sn its solidity, from twine
// area / A:
//
//   F = 1/2 rho A |U|^2 (C_D U/|U| + C_L l),  l = n - cos th U/|U|, made a unit vector
//
// and C_F in C_D besides, C_F A the friction coefficient that is asked for times the twine area;
// it is shared by the corners as what is spread evenly (cell_shape.hpp), and so is U. Sn: base/solidity.hpp.
// A cell that closes up loses its area: Sn is held at the law's end, and the force goes to zero.
#pragma once

#include "cell_shape.hpp"
#include "kind.hpp"
#include "netting_screen_law.hpp"

namespace codend {

// A cell in the flow.
struct ScreenFlow {
  Vector x[4], area;   // corners and S
  Vector u, slope[4];  // mean U, and its derivative by every corner's height
  double own[4];       // share of every corner's own velocity in it
};
// node: its 4 corners; height: over which the netting leaves the water, m.
ScreenFlow screen_flow(const Field& field, const CellShape& shape, const int* node, double height);
// Derivative of S by the place of corner l.
Matrix area_slope(const ScreenFlow& flow, int l);

// Force (N) on a whole cell and its derivatives by S and U.
struct ScreenForce {
  Vector value = Vector::Zero();
  Matrix by_area = Matrix::Zero(), by_velocity = Matrix::Zero();
};
// twine_area (m2), overlap, diameter (m) and multiplicity as of NettingScreens.
ScreenForce screen_force(NettingScreenLaw law, const ScreenFlow& flow, double twine_area,
                         double overlap, double diameter, double multiplicity, const Water& water,
                         ScreenMultipliers multipliers = {});

class NettingScreens : public ElementKind {
 public:
  std::vector<int> node;             // 4 per cell; of three corners the last one twice
  std::vector<double> twine;         // u0 v0 ... u3 v3 per cell
  std::vector<double> twine_area;    // projected area of its twine and knots, m2
  std::vector<double> overlap;       // Sn = s - overlap s^2: 1/4, or 0 where crossings are knots
  std::vector<double> diameter;      // of the twine, m
  std::vector<double> height;        // over which they leave the water, m
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
  // Force (N) on the whole cell.
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
