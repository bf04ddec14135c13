// Stiffness of ropes, pipes and poles against bending, at the node between two of their bars.
//
// With t the angle between the bars before and after the node and B/L the bending stiffness over
// the length that bends there, the energy is (B/L) (1 - cos t). That is 1/2 (B/L) t^2 for small
// angles, short of it by a share of t^2/12 for larger ones (0.3 % where a circle has 32 bars), and
// stays smooth where a line folds back on itself. Straight at rest; a ring that is bent from a
// straight pipe and closed is a circle, and its forces in its plane are those of a ring that was
// made as a circle, since the curvature of a closed plane curve has a given sum. No torsion.
#pragma once

#include "kind.hpp"

namespace codend {

class Bends : public ElementKind {
 public:
  std::vector<int> node;       // 3 per bend: before, at and after it along the line
  std::vector<double> couple;  // B/L, N m
  std::vector<double> length;  // L, half of both bars at rest, m

  template <class Visit>
  void fields(Visit& visit) {
    visit("node", node, {3, Among::points});
    visit("couple", couple);
    visit("length", length);
  }

  int count() const { return static_cast<int>(couple.size()); }
  int nodes_per_element() const override { return 3; }
  const std::vector<int>& nodes() const override { return node; }
  double element_energy(int e, const Field& field) const;  // J
  void add_force(const Field& field, double* force) const override;
  void add_jacobian(const Field& field, const JacobianRequest& request,
                    const BlockSink& sink) const override;
  void add_added_mass(const Field&, double*) const override {}
  void add_drag_scale(const Field&, double*) const override {}
  // The least length where any is in compression: beyond Euler's load it stands straight, but not
  // for long.
  double unstable_size(const Field& field) const override;
  double unstable_stiffness() const override;

 private:
  struct Bend {
    Vector u, v;  // unit vectors along the bars before and after the node
    double length_u, length_v, cosine;
  };
  Bend bend(int e, const Field& field) const;
};

}  // namespace codend
