// Water behind netting is slower: the speed of the flow past every point as a share of the free
// flow's, from the netting that lies straight upstream of it.
//
// Every sheet of netting that the line upstream from a point crosses multiplies the speed by r:
//   Loland (1991, Current forces on and flow through fish farms, NTH Trondheim):
//     r = 1 - 0.46 C_D, C_D = 0.33 Sn + 6.54 Sn^2 - 4.88 Sn^3, of a sheet across the flow;
//   Cheng et al. (2020, Aquacultural Engineering 90:102070):
//     r = max(0, (cos t + 0.05 - 0.38 Sn) / (cos t + 0.05)), t from the sheet's normal to the flow.
// Sn (base/solidity.hpp) is that of the sheet in its present shape, held at the end of the law's range
// (base/laws.hpp). A sheet along the flow casts no wake of its own: r fades to 1 between 70 and 80 deg.
//
// Crossings come and go when the gear moves, so that shape and wake may chase each other;
// renew() can therefore keep the crossings that were found and only renew r.
#pragma once

#include <vector>

#include "../base/fields.hpp"
#include "../base/geometry.hpp"
#include "../base/laws.hpp"

namespace codend {

// Sheets of netting, as triangles, that slow the water behind them.
struct WakeSheets {
  std::vector<int> node;           // 3 points each
  std::vector<double> twine_area;  // diameter times length of the twine in each, m2
  std::vector<double> overlap;     // of its crossings (base/solidity.hpp)
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

// Shares that are off by no more than this are left as they are.
constexpr double wake_tolerance = 1e-5;

// r of a sheet of this solidity whose normal has this cosine (not negative) to the flow.
double speed_reduction(WakeLaw law, double solidity, double cosine);

class Wake {
 public:
  Wake(const WakeSheets& sheets, int points) : sheets_(sheets), share_(points, 1.0) {}
  bool present() const { return sheets_.count() > 0; }
  const std::vector<double>& share() const { return share_; }
  void set_share(const std::vector<double>& share) { share_ = share; }
  // Renews the shares of all points at these positions (m, 3 each) in a flow of this direction (of
  // any length but zero), if one of them is off by more than a tolerance; search: also which sheets
  // lie upstream; follow: how far the shares go towards what is found, 1 all the way. Returns by how
  // much they were off at most.
  double renew(const double* position, const Vector& flow, bool search, double tolerance,
               double follow = 1.0);
  // Keeps to the sheets that lie upstream at these positions: no search finds others from now on, and
  // shares change from what they are by as much as these sheets' do. What differences between shapes
  // need. The second: to those, and from where, another wake of like sheets does.
  void keep(const double* position, const Vector& flow);
  void keep_to(const Wake& other);

 private:
  void search(const double* position, const Vector& flow);
  const WakeSheets& sheets_;
  std::vector<double> share_;
  std::vector<double> apart_;         // of shares from those of the sheets that are kept to
  std::vector<int> start_, crossed_;  // sheets upstream of point p: crossed_[start_[p] ...)
};

}  // namespace codend
