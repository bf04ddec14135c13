// Screen drag model: drag and lift of a whole netting cell (netting_screen.inl) instead of
// Morison-type (twine-by-twine) drag.
//
// Let S = 1/2 (x2-x0) x (x3-x1) be the cell's area vector, A = |S|, and n = S/A with the sign that
// makes n.U >= 0. U is the mean velocity of the water relative to the cell, cos th = n.U/|U|, and
// Sn its solidity from twine area / A (base/solidity.hpp). Then
//   F = 1/2 rho A |U|^2 (C_D U/|U| + C_L l),  l = n - cos th U/|U|, made a unit vector.
// The corners share F and U as an evenly distributed load (cell_shape.hpp). The area of a closing
// cell vanishes: Sn is bounded by the range of the drag model, and the force tends to zero.
#pragma once

#include "cell_shape.hpp"
#include "kind.hpp"
#include "line_kernels.hpp"

namespace codend {

struct ScreenMultipliers {
  double drag = 1.0, lift = 1.0;
};

// Netting cells whose drag is computed for whole cells.
class WholeCells : public ElementKind {
 public:
  std::vector<int> node;             // 4 per cell; a triangle repeats its last corner
  std::vector<double> twine;         // u0 v0 ... u3 v3 per cell
  std::vector<double> overlap;       // Sn = s - overlap s^2: 1/4, or 0 if crossings are knots
  std::vector<double> height;        // vertical size at the free surface, m
  std::vector<double> multiplicity;  // 1, or 1/2 where two triangulations overlap
  ScreenMultipliers multipliers;     // of the screen force

  int count() const { return static_cast<int>(multiplicity.size()); }
  // Call once after filling. density: of the water, kg/m3.
  void prepare(double density);
  int nodes_per_element() const override { return 4; }
  const std::vector<int>& nodes() const override { return node; }
  void add_force(const Field& field, double* force) const override;
  // Forces on whole cells, N, 3 per cell.
  std::vector<double> element_forces(const Field& field) const;
  void add_jacobian(const Field& field, const JacobianRequest& request,
                    const BlockSink& sink) const override;
  void add_drag_scale(const Field& field, double, double* scale) const override;

 private:
  // Sets the other properties of cell `e` at a place of its strip. twines: null without twines.
  virtual void describe(std::size_t e, std::size_t place, double density, const CellShape& shape,
                        NettingProperties& to, TwineProperties* twines) const = 0;
  virtual bool has_twines() const { return false; }
  // Sets the drag models of the twines in the strip that begins with cell `first`.
  virtual void set_laws(std::size_t /*first*/, NettingStrip::Twines&) const {}
  void read_corners(std::size_t e, std::size_t place, const Field& field, bool by_velocity,
                    NettingCorners& to, NettingStrip& strip) const;
  // Calls visit(first cell, strip) for strips of all cells.
  template <class Visit>
  void in_strips(const Field& field, bool by_velocity, Visit visit) const;
  // Per strip.
  std::vector<NettingProperties> properties_;
  std::vector<TwineProperties> twines_;
};

class NettingScreens : public WholeCells {
 public:
  std::vector<double> twine_area;  // projected area of twine and knots, m2
  std::vector<double> diameter;    // of the twine, m
  std::vector<NettingScreenLaw> law;

  template <class Visit>
  void fields(Visit& visit) {
    visit("node", node, {4, Among::points});
    visit("twine", twine, {8});
    visit("twine_area", twine_area);
    visit("overlap", overlap);
    visit("diameter", diameter);
    visit("height", height);
    visit("multiplicity", multiplicity);
    visit("law", law);
  }

 private:
  void describe(std::size_t e, std::size_t place, double density, const CellShape& shape,
                NettingProperties& to, TwineProperties* twines) const override;
};

}  // namespace codend
