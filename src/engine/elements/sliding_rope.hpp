// A rope that slides through a chain of points, such as a purse wire through its rings or a rope
// over blocks: one tension throughout, without friction.
//
// With d_k the vectors from point to point, it is as long as l = sum_k sqrt(|d_k|^2 + b^2): b, of
// the size of a ring, is what a ring takes of the rope where all of them meet in one place. Energy
// EA (l - L0)^2 / (2 L0) where l > L0, none below. So T = EA (l - L0) / L0, and with
// u_k = d_k / sqrt(|d_k|^2 + b^2) point k is pulled by T (u_k - u_k-1).
//
// The rope's bars, one from point to point, carry its weight and drag and share its length L0; they
// have no stiffness of their own. What slides past a point takes its share of both along only as
// the length of all bars changes: they keep their proportions.
#pragma once

#include "bar.hpp"
#include "kind.hpp"

namespace codend {

class SlidingRope : public ElementKind {
 public:
  std::vector<int> bar;          // in order from its start
  double axial_stiffness = 0.0;  // EA, N
  double bend = 0.02;            // b, m

  template <class Visit>
  void fields(Visit& visit) {
    visit("bar", bar, {1, Among::bars});
    visit("axial_stiffness", axial_stiffness);
  }

  // Call once after filling, with the bars of the model. In use it asks those of the Field, whose rest
  // lengths may change at any time; one whose multiplicity is 0 has parted.
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
  void add_added_mass(const Field&, double*) const override {}
  void add_drag_scale(const Field&, double*) const override {}

 private:
  struct Pull {
    double length = 0.0, rest = 0.0, tension = 0.0;  // m, m, N
  };
  // Vector from a point to the next over its length b included, and that length.
  Vector direction(std::size_t k, const Field& field, double& length) const;
  Pull pull(const Field& field) const;

  std::vector<int> node_;
};

}  // namespace codend
