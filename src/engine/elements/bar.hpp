// Bars: a rope element, a twine, or many twines of grouped netting as one equivalent bar.
// Grouping by lambda twines in both directions: length lambda times the real bar's, lambda lines
// in parallel; that keeps mass, weight, projected area and stiffness of the netting.
#pragma once

#include "line.hpp"

namespace codend {

class Bars : public ElementKind {
 public:
  std::vector<int> node;             // 2 per bar
  std::vector<double> rest;          // unstretched length, m
  std::vector<double> multiplicity;  // lines in parallel
  std::vector<int> material;         // index into materials
  const std::vector<TwineMaterial>* materials = nullptr;

  int count() const { return static_cast<int>(rest.size()); }
  Line<2> line(int bar) const {
    return {&node[2 * static_cast<std::size_t>(bar)], {-1.0, 1.0}, 0.5, rest[bar],
            multiplicity[bar], &(*materials)[material[bar]], bar};
  }

  int nodes_per_element() const override { return 2; }
  const std::vector<int>& nodes() const override { return node; }
  void add_force(const Field& field, double* force) const override;
  void add_jacobian(const Field& field, const JacobianRequest& request,
                    BlockSink& sink) const override;
  void add_added_mass(const Field& field, double* mass) const override;
  void add_drag_scale(const Field& field, double* scale) const override;
};

}  // namespace codend
