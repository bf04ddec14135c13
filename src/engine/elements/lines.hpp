// All lines of a model, of bars, netting cells and hexagonal triangles, as structures of
// arrays: their vectors, tensions and drags at the last positions, and the forces and derivatives
// from them.
//
// Line numbers: the bars, then the u lines of all cells, then their v lines, then the straight
// lines of hexagonal triangles, then those along A, then those along B.
#pragma once

#include <initializer_list>
#include <vector>

#include "bar.hpp"
#include "bows.hpp"
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
  // What is passed must outlive this and not change.
  Lines(const std::vector<TwineMaterial>& materials, const Bars& bars, const NettingCells& cells,
        const HexagonalTriangles& hexagons, const Water& water, SlackDrag slack,
        const LineKernels& kernels = line_kernels());
  Lines(const Lines&) = delete;

  int count() const { return count_; }
  const LineArrays& arrays() const { return arrays_; }

  // Points that are held where they are, 1 each, and whose forces nobody asks for, or empty: cells
  // with no other points keep what was last known of them.
  void set_still(const std::vector<char>& point);
  // What is known of lines that are still is renewed once, with the others.
  void renew_still() { renew_ = true; }
  bool still(int line) const { return !still_.empty() && still_[static_cast<std::size_t>(line)]; }

  // To be called where a bar's rest length or multiplicity has changed; rate: dL0/dt over L0, 1/s.
  void update_bar(int bar, double rest_rate);
  // The flow past all lines: to be called where velocities, or depths in a current that varies with
  // them, have changed; before move_to().
  void set_flow(const Field& field);
  // Vectors and what follows from them.
  void move_to(const double* position);

  // Leads the bows of cells' twines by given tensions of one line each (N) to where these
  // balance; until the next move_to() lengths and strains are those of these bows, tensions are not.
  void bow_to(const double* tension);
  // Changes of strain that bows add, as they follow (bows.hpp).
  void share_bows(const double* tension, const double* modulus, const double* mismatch,
                  const double* change, double* strain) const;
  // Adds to tensions (N) what changes of strain by bows make of them.
  void add_bow_tensions(const double* tension, const double* modulus, const double* bow,
                        double* sum) const;
  // Adds to changes of strain what bows add that follow the law to their end (bows.hpp).
  void change_bows(double* strain) const;

  // Adds drag, and pull by given tensions of one line each (N), to force (N, 3 per point).
  void add_force(const double* tension, double* force) const;
  // Adds blocks; tension and modulus (N) of one line each, modulus null for the law's.
  void add_jacobian(const JacobianRequest& request, const double* tension, const double* modulus,
                    const BlockSink& bars, const BlockSink& cells, const BlockSink& hexagons) const;
  // Adds added mass (kg, 9 per point).
  void add_added_mass(double* mass) const;
  // Adds the drag's damping (N s/m, 1 per point) of lines at right angles to the flow.
  void add_drag_scale(double* scale) const;

  // Largest |change of e| / L0 when points move by dx; changes of strain, to first order, into
  // strain[0 .. count()).
  double change(const double* dx, double* strain) const;

 private:
  const std::vector<CellRange>& cells_to_move() const {
    return renew_ ? all_cells_ : moving_cells_;
  }
  template <int N>
  void describe(const Line<N>& line);
  // What lines meet the water with, means of their points.
  struct Meeting {
    Vector moving = Vector::Zero();  // velocity of the water but for the current's, m/s
    Vector slope = Vector::Zero();   // its derivative by height, 1/s
    double z = 0.0, surface = 0.0;   // heights of the line and of the water's surface, m
    double own = 0.0;                // share of the flow that is left
    void add(const Field& field, int point, double share);
  };
  // Of lines with these points, which have these shares in it; height: over which they leave the
  // water, m.
  void set_velocity(const Field& field, const int* node, const double* share, int points,
                    double height, std::initializer_list<int> lines);
  void set_velocity(std::size_t line, const Meeting& meeting, double height);
  // visit(begin, end) in strips whose arrays stay in the first-level cache.
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
  const LineKernels& kernels_;
  std::vector<double> led_bows_;                     // of cells, by a solver's tensions
  std::vector<char> still_;                          // per line; empty: none
  std::vector<CellRange> all_cells_, moving_cells_;  // in strips
  bool renew_ = true;
};

}  // namespace codend
