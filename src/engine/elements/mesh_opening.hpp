// Stiffness of meshes against opening and closing: a couple at every knot between the two families
// of twine (D. Priour, A Finite Element Method for Netting, Springer 2013), on netting cells.
//
// With b the angle between the mean bar vectors e_u and e_v of the cell, over their rest length, a
// knot's energy is 1/2 H (b - b0)^2 and its couple H (b - b0). cos b = k = e_u.e_v / (|e_u| |e_v|), in
// which the lengths of slack twines, whose ends say less and less of their angle at the knot, are
// held above sqrt(3/4); sin b is taken as sqrt(1 - k^2 + 0.02^2), an angle changed by 0.02 at most.
#pragma once

#include "cell_shape.hpp"
#include "kind.hpp"

namespace codend {

class MeshOpenings : public ElementKind {
 public:
  std::vector<int> node;             // 4 per cell; of three corners the last one twice
  std::vector<double> twine;         // u0 v0 ... u3 v3 per cell, m of twine at rest
  std::vector<double> couple;        // H, N m/rad, of one knot
  std::vector<double> angle;         // b0, rad
  std::vector<double> multiplicity;  // that of the netting cell over the bar's length squared

  template <class Visit>
  void fields(Visit& visit) {
    visit("node", node, {4, Among::points});
    visit("twine", twine, {8});
    visit("couple", couple);
    visit("angle", angle);
    visit("multiplicity", multiplicity);
  }

  int count() const { return static_cast<int>(couple.size()); }
  // Call once after filling.
  void prepare();
  int nodes_per_element() const override { return 4; }
  const std::vector<int>& nodes() const override { return node; }
  // Energy (J) of all knots of a cell.
  double element_energy(int e, const Field& field) const;
  void add_force(const Field& field, double* force) const override;
  void add_jacobian(const Field& field, const JacobianRequest& request,
                    const BlockSink& sink) const override;
  void add_added_mass(const Field&, double*) const override {}
  void add_drag_scale(const Field&, double*) const override {}

 private:
  struct Opening {
    Vector u, v;  // e_u and e_v
    double energy;
    // By the squares of the lengths of u and v and by their product: first and second derivatives.
    double slope[3], curve[3][3];
  };
  Opening opening(int e, const Field& field) const;
  std::vector<CellShape> shape_;
};

}  // namespace codend
