// Stiffness of meshes against opening and closing, on netting cells: a couple at every knot between
// the two families of twine (D. Priour, A Finite Element Method for Netting, Springer 2013).
//
// Let b be the angle between the mean bar vectors e_u and e_v of the cell, over their rest length.
// A knot has the energy 1/2 H (b - b0)^2 and the couple H (b - b0). Here cos b = k = e_u.e_v /
// (|e_u| |e_v|). The lengths of slack twines in k are bounded below by sqrt(3/4), because their
// ends no longer determine the angle at the knot. The code computes sin b as
// sqrt(1 - k^2 + 0.02^2), which changes the angle by at most 0.02 rad.
#pragma once

#include "cell_shape.hpp"
#include "kind.hpp"

namespace codend {

class MeshOpenings : public ElementKind {
 public:
  std::vector<int> node;             // 4 per cell; a triangle repeats its last corner
  std::vector<double> twine;         // u0 v0 ... u3 v3 per cell, m of twine at rest
  std::vector<double> couple;        // H of one knot, N m/rad
  std::vector<double> angle;         // b0, rad
  std::vector<double> multiplicity;  // multiplicity of the netting cell over the squared bar length

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
  // Energy of all knots of a cell, J.
  double element_energy(int e, const Field& field) const;
  void add_force(const Field& field, double* force) const override;
  void add_jacobian(const Field& field, const JacobianRequest& request,
                    const BlockSink& sink) const override;

 private:
  struct Opening {
    Vector u, v;  // e_u and e_v
    double energy;
    // First and second derivatives by the squares of the lengths of u and v and by their product.
    double slope[3], curve[3][3];
  };
  Opening opening(int e, const Field& field) const;
  std::vector<CellShape> shape_;
};

}  // namespace codend
