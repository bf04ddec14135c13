// Bending stiffness of ropes, pipes and poles, at the node between two of their bars.
//
// With t the angle between the bars before and after the node, B the bending stiffness and L the
// length that bends there, the energy is (B/L) (1 - cos t). For small angles this is 1/2 (B/L) t^2.
// For larger angles it is lower by the fraction t^2/12 (0.3 % for a circle of 32 bars). It stays
// smooth if a line folds back on itself. The line is straight at rest and has no torsional
// stiffness.
// A straight pipe that is bent and closed to a ring takes the shape of a circle. Its in-plane
// forces equal the forces in a ring made as a circle, because the total curvature of a closed plane
// curve is fixed.
#pragma once

#include "kind.hpp"

namespace codend {

class Bends : public ElementKind {
 public:
  std::vector<int> node;       // 3 per bend: the nodes before, at and after the bend
  std::vector<double> couple;  // B/L, N m
  std::vector<double> length;  // L, half the rest length of both bars, m

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
  // Smallest length L of the bends in compression, m; 0 if there are none. A straight line under
  // more than Euler's load is in unstable equilibrium.
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
