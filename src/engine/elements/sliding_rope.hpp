// A rope that slides through a chain of points, such as a purse wire through its rings or a rope
// over blocks. Its tension is uniform, without friction.
//
// With d_k the vectors from point to point, its length is l = sum_k sqrt(|d_k|^2 + b^2). b, the
// diameter of the rope, is the length of rope per ring if all rings meet. The energy is EA (l - L0)^2
// / (2 L0) for l > L0, and 0 otherwise. Therefore T = EA (l - L0) / L0, and with u_k = d_k /
// sqrt(|d_k|^2 + b^2) the pull on point k is T (u_k - u_k-1).
//
// The rope's bars, one from point to point, have its weight and drag and add up to its length L0.
// They have no stiffness of their own. Rope that slides past a point does not move weight and drag
// between bars: all bars keep their proportions of the rope's length.
#pragma once

#include "bar.hpp"
#include "kind.hpp"

namespace codend {

class SlidingRope : public ElementKind {
 public:
  std::vector<int> bar;          // in order from the start
  double axial_stiffness = 0.0;  // EA, N
  double bend = 0.02;            // b, m

  template <class Visit>
  void fields(Visit& visit) {
    visit("bar", bar, {1, Among::bars});
    visit("axial_stiffness", axial_stiffness);
    visit("bend", bend);
  }

  // Call once after filling, with the bars of the model. Later calls use the bars of the Field,
  // which may change their rest lengths at any time. A bar with multiplicity 0 has parted.
  void prepare(const Bars& bars);
  // N.
  double tension(const Field& field) const { return pull(field).tension; }
  // J.
  double energy(const Field& field) const;

  int nodes_per_element() const override { return static_cast<int>(node_.size()); }
  const std::vector<int>& nodes() const override { return node_; }
  void add_force(const Field& field, double* force) const override;
  void add_jacobian(const Field& field, const JacobianRequest& request,
                    const BlockSink& sink) const override;

 private:
  struct Pull {
    double length = 0.0, rest = 0.0, tension = 0.0;  // m, m, N
  };
  // Vector d_k from a point to the next, divided by sqrt(|d_k|^2 + b^2). `length` (m) returns the
  // divisor.
  Vector direction(std::size_t k, const Field& field, double& length) const;
  Pull pull(const Field& field) const;

  std::vector<int> node_;
};

}  // namespace codend
