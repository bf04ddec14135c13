// Bodies without lift at one point: knots, balls, weights. The drag is 1/2 rho A C |U| U.
//
// Knots are spheres with C(Re) = 24/Re + 6/(1 + sqrt Re) + 0.4 and Re = |U| d / nu (F. White,
// Viscous Fluid Flow; valid below Re = 2e5). Smooth spheres include the drag crisis (F. A.
// Morrison, Data Correlation for Drag Coefficient for Sphere, Michigan Technological University,
// 2013; to Re = 1e6):
//
//   C(Re) = 24/Re + 2.6 (Re/5) / (1 + (Re/5)^1.52) + 0.411 r^-7.94 / (1 + r^-8) + Re^0.8 / 461000,
//   r = Re / 263000.
//
// Other bodies have one coefficient for all speeds, given by diameter 0 and their drag area C A.
#pragma once

#include "kind.hpp"

namespace codend {

class Spheres : public ElementKind {
 public:
  std::vector<int> node;
  std::vector<double> drag_area;   // C A if diameter is 0, else projected area A of all knots, m2
  std::vector<double> diameter;    // m; 0: coefficient included in drag_area
  std::vector<char> smooth;        // smooth sphere instead of a knot
  std::vector<double> added_mass;  // m3: kg at a water density of 1 kg/m3
  std::vector<double> height;      // vertical size at the free surface, m

  template <class Visit>
  void fields(Visit& visit) {
    visit("node", node, {1, Among::points});
    visit("drag_area", drag_area);
    visit("diameter", diameter);
    visit("smooth", smooth);
    visit("added_mass", added_mass);
    visit("height", height);
  }

  int count() const { return static_cast<int>(node.size()); }
  int nodes_per_element() const override { return 1; }
  const std::vector<int>& nodes() const override { return node; }
  void add_force(const Field& field, double* force) const override;
  // Force on one element, N.
  Vector element_force(int e, const Field& field) const;
  void add_jacobian(const Field& field, const JacobianRequest& request,
                    const BlockSink& sink) const override;
  void add_added_mass(const Field& field, double* mass) const override;
  void add_drag_scale(const Field& field, double, double* scale) const override;

 private:
  // C |U| and its derivative by |U|.
  void coefficient(int e, double speed, double viscosity, double& value, double& slope) const;
};

}  // namespace codend
