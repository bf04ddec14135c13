// Triangles of netting with a pressure p = 1/2 C_d rho |U|^2 from inside, due to contents that
// press against them, such as the catch in a codend (D. Priour, Ocean Engineering, 2014,
// doi:10.1016/j.oceaneng.2014.09.037; C_d = 1.4).
//
// Corner k takes p w_k S. S = 1/2 (x2 - x1) x (x3 - x1) is the triangle's area vector. The weight
// w_k is the integral of the corner's linear shape function over the covered part, divided by the
// triangle's area: 1/3 if all is covered. Its sign is positive if S points outward.
//
// U is the mean velocity of the water at the corners relative to the mean velocity of all
// triangles. With the velocity of the triangle itself, a wall that moves outward would increase the
// pressure that moves it.
#pragma once

#include "kind.hpp"

namespace codend {

class InnerPressure : public ElementKind {
 public:
  std::vector<int> node;          // 3 per triangle
  std::vector<double> weight;     // w_1 w_2 w_3 per triangle, signed
  std::vector<double> height;     // of each triangle at the free surface, m
  double drag_coefficient = 1.4;  // C_d

  template <class Visit>
  void fields(Visit& visit) {
    visit("node", node, {3, Among::points});
    visit("weight", weight, {3});
    visit("height", height);
    visit("drag_coefficient", drag_coefficient);
  }

  int count() const { return static_cast<int>(node.size() / 3); }
  int nodes_per_element() const override { return 3; }
  const std::vector<int>& nodes() const override { return node; }
  void add_force(const Field& field, double* force) const override;
  // Returns the mean velocity of the triangles under pressure, by weight (m/s).
  Vector mean_velocity(const Field& field) const;
  // Force (N) on the whole triangle. mean: from mean_velocity().
  Vector element_force(int e, const Field& field, const Vector& mean) const;
  // The derivatives by velocity are those of a triangle that moves with the mean velocity: exact if
  // all triangles move alike.
  void add_jacobian(const Field& field, const JacobianRequest& request,
                    const BlockSink& sink) const override;
  void add_drag_scale(const Field& field, double, double* scale) const override;

 private:
  struct Push {
    Vector x[3], area;   // corners and S
    Vector u, slope[3];  // mean U, and its derivative by the height of each corner
    double share = 0.0;  // of each corner's velocity in U, if all triangles move alike
    double pressure;
  };
  Push push(int e, const Field& field, const Vector& mean) const;
};

}  // namespace codend
