// All lines of a model (bars, netting cells and hexagonal triangles) as a structure of arrays. It
// holds their vectors, tensions and drag at the last positions, and computes forces and derivatives
// from them.
//
// Line order: bars, u lines of all cells, v lines of all cells, straight lines of hexagonal
// triangles, their lines along A, their lines along B.
#pragma once

#include <initializer_list>
#include <vector>

#include "bar.hpp"
#include "hexagonal_triangle.hpp"
#include "kind.hpp"
#include "netting_cell.hpp"

namespace codend {

// Cells [begin, end).
struct CellRange {
  int begin, end;
};

class Lines {
 public:
  // The arguments must outlive this object and must not change.
  Lines(const std::vector<TwineMaterial>& materials, const Bars& bars, const NettingCells& cells,
        const HexagonalTriangles& hexagons, const Water& water, SlackDrag slack,
        const LineKernels& kernels = line_kernels());
  Lines(const Lines&) = delete;

  int count() const { return count_; }
  const LineArrays& arrays() const { return arrays_; }

  // point: 1 for fixed points whose forces are not needed, or empty. Cells with only such points
  // are skipped and keep their last results.
  void set_still(const std::vector<char>& point);
  // Updates the skipped lines once, in the next update of the others.
  void renew_still() { renew_ = true; }
  bool still(int line) const { return !still_.empty() && still_[static_cast<std::size_t>(line)]; }

  // Call after a change of a bar's rest length or multiplicity. rest_rate: dL0/dt over L0, 1/s.
  void update_bar(int bar, double rest_rate);
  // Updates the flow past all lines. Call before move_to() after a change of velocities, or of
  // depths in a depth-dependent current.
  void set_flow(const Field& field);
  // Updates vectors, and everything that depends on them.
  void move_to(const double* position);

  // Updates the sag of the cells' twines to equilibrium with given tensions (N, one line each).
  // Until the next move_to(), lengths and strains correspond to this sag, but tensions do not.
  void sag_to(const double* tension);
  // Adds the changes of strain due to sag, to first order (add_sag_strains() of sag.inl).
  void distribute_sag(const double* tension, const double* modulus, const double* mismatch,
                      const double* change, double* strain) const;
  // Adds the changes of tension (N) due to changes of strain by sag.
  void add_sag_tensions(const double* tension, const double* modulus, const double* sag,
                        double* sum) const;
  // Adds the changes of strain due to sag in its new equilibrium (change_sag() of sag.inl).
  void change_sag(double* strain) const;

  // Adds drag and pull to force (N, 3 per point). tension: of one line, N.
  void add_force(const double* tension, double* force) const;
  // Adds blocks. tension, modulus: of one line, N; modulus null: by the constitutive law.
  void add_jacobian(const JacobianRequest& request, const double* tension, const double* modulus,
                    const BlockSink& bars, const BlockSink& cells, const BlockSink& hexagons) const;
  // Adds added mass (kg, 9 per point).
  void add_added_mass(double* mass) const;
  // Adds the damping by drag of lines normal to the flow (N s/m, 1 per point).
  void add_drag_scale(double* scale) const;

  // Returns the largest |change of e| / L0 when points move by dx (m). Writes changes of strain, to
  // first order, to strain[0 .. count()).
  double change(const double* dx, double* strain) const;

 private:
  const std::vector<CellRange>& cells_to_move() const {
    return renew_ ? all_cells_ : moving_cells_;
  }
  template <int N>
  void describe(const Line<N>& line);
  // Flow at a line: means over its points.
  struct Meeting {
    Vector moving = Vector::Zero();  // water velocity without the current, m/s
    Vector slope = Vector::Zero();   // its derivative by height, 1/s
    double z = 0.0, surface = 0.0;   // heights of the line and of the water surface, m
    double own = 0.0;                // fraction of the undisturbed flow
    void add(const Field& field, int point, double share);
  };
  // Sets the flow of `lines`, which have these points and fractions per point. height: vertical
  // size at the free surface, m.
  void set_velocity(const Field& field, const int* node, const double* share, int points,
                    double height, std::initializer_list<int> lines);
  void set_velocity(std::size_t line, const Meeting& meeting, double height);
  // Calls visit(begin, end) for strips whose arrays fit in the first-level cache.
  template <class Visit>
  static void in_strips(int count, Visit visit);

  const std::vector<TwineMaterial>& materials_;
  const Bars& bars_;
  const NettingCells& cells_;
  const HexagonalTriangles& hexagons_;
  const Water& water_;
  int count_;
  std::vector<double> numbers_;
  std::vector<const TwineMaterial*> speed_law_, load_law_;
  LineArrays arrays_{};
  CellArrays cell_arrays_;
  const LineKernels& kernels_;
  std::vector<double> led_sag_;                      // sag of cells by a solver's tensions
  std::vector<char> still_;                          // per line; empty: none
  std::vector<CellRange> all_cells_, moving_cells_;  // in strips
  bool renew_ = true;
};

}  // namespace codend
