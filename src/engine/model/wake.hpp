// Wakes of netting: the flow speed at every point, as a fraction of the free flow.
//
// Each sheet of netting straight upstream of a point multiplies the speed by r:
//
// Loland (1991, Current forces on and flow through fish farms, NTH Trondheim), normal to the flow:
//   r = 1 - 0.46 C_D, C_D = 0.33 Sn + 6.54 Sn^2 - 4.88 Sn^3
// Cheng et al. (2020, Aquacultural Engineering 90:102070), t from the sheet's normal to the flow:
//   r = max(0, (cos t + 0.05 - 0.38 Sn) / (cos t + 0.05))
//
// Sn (base/solidity.hpp) is the solidity of the deformed sheet, limited to the range of the wake
// model (base/drag_models.hpp). A sheet along the flow casts no wake: r fades to 1 from 70 to 80 deg.
//
// Repeated searches for upstream sheets can prevent convergence, because shape and wake change each
// other. renew() can therefore reuse the last search and only update r.
#pragma once

#include <vector>

#include "../base/drag_models.hpp"
#include "../base/fields.hpp"
#include "../base/geometry.hpp"

namespace codend {

// Triangles of netting that slow the water behind them.
struct WakeSheets {
  std::vector<int> node;           // 3 points each
  std::vector<double> twine_area;  // twine diameter times twine length per triangle, m2
  std::vector<double> overlap;     // overlap of crossings (base/solidity.hpp)
  std::vector<WakeLaw> law;

  template <class Visit>
  void fields(Visit& visit) {
    visit("node", node, {3, Among::points});
    visit("twine_area", twine_area);
    visit("overlap", overlap);
    visit("law", law);
  }
  int count() const { return static_cast<int>(law.size()); }
};

// Smaller changes of the fractions are ignored.
constexpr double wake_tolerance = 1e-5;

// Returns r for a solidity and the absolute cosine between the sheet's normal and the flow.
double speed_reduction(WakeLaw law, double solidity, double cosine);

class Wake {
 public:
  Wake(const WakeSheets& sheets, int points) : sheets_(sheets), share_(points, 1.0) {}
  bool present() const { return sheets_.count() > 0; }
  const std::vector<double>& share() const { return share_; }
  void set_share(const std::vector<double>& share) { share_ = share; }
  // Updates the speed fractions of all points if a change exceeds `tolerance`. Returns the largest
  // difference between the old fractions and the computed ones.
  //
  // position: m, 3 per point. flow: direction, of any length above 0. search: also search the
  // upstream sheets again. follow: relaxation factor, 1 for the full change.
  double renew(const double* position, const Vector& flow, bool search, double tolerance,
               double follow = 1.0);
  // keep() fixes the set of upstream sheets; later calls of renew() do not search. The present
  // fractions remain as an offset, so they change only with r, as finite differences require.
  // keep_to() copies the set and the offset of another wake with equal sheets.
  void keep(const double* position, const Vector& flow);
  void keep_to(const Wake& other);

 private:
  void search(const double* position, const Vector& flow);
  const WakeSheets& sheets_;
  std::vector<double> share_;
  std::vector<double> apart_;         // offset between the fractions and the product of r
  std::vector<int> start_, crossed_;  // sheets upstream of point p: crossed_[start_[p] ..)
};

}  // namespace codend
