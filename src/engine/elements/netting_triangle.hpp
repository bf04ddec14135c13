// Netting triangles: three points with twine coordinates (u, v), linear inside, so that all twines
// of one family in a triangle are parallel and equally long (D. Priour, A Finite Element Method
// for Netting, Springer 2013). One unit of u is one bar along a u twine.
//
// With d = (u2-u1)(v3-v1) - (u3-u1)(v2-v1) the bar vectors are e_u = sum_k a_k x_k,
// a = (v2-v3, v3-v1, v1-v2)/d, and e_v = sum_k b_k x_k, b = (u3-u2, u1-u3, u2-u1)/d. The triangle
// holds |d|/2 bars of each family and |d|/2 knots, times `multiplicity`.
#pragma once

#include "line.hpp"

namespace codend {

class NettingTriangles : public ElementKind {
 public:
  std::vector<int> node;             // 3 per triangle
  std::vector<double> twine;         // u1 v1 u2 v2 u3 v3 per triangle
  std::vector<double> rest;          // bar length, m
  std::vector<double> multiplicity;  // 1, or 1/2 where two triangulations share a cell
  std::vector<int> material;
  const std::vector<TwineMaterial>* materials = nullptr;
  int first_line = 0;  // number of its first line among the model's

  int count() const { return static_cast<int>(rest.size()); }
  Line<3> u_line(int triangle) const { return family(triangle, 1); }
  Line<3> v_line(int triangle) const { return family(triangle, 0); }

  int nodes_per_element() const override { return 3; }
  const std::vector<int>& nodes() const override { return node; }
  void add_force(const Field& field, double* force) const override;
  void add_jacobian(const Field& field, const JacobianRequest& request,
                    BlockSink& sink) const override;
  void add_added_mass(const Field& field, double* mass) const override;
  void add_drag_scale(const Field& field, double* scale) const override;

 private:
  // across: which of (u, v) stays the same along the family's twines (1: v, so the u twines).
  Line<3> family(int triangle, int across) const;
};

}  // namespace codend
