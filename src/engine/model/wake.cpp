#include "wake.hpp"

#include <algorithm>
#include <cmath>

#include "../base/solidity.hpp"

namespace codend {
namespace {

// Cosines of 80 and 70 deg.
constexpr double along = 0.174, aslant = 0.342;

// A sheet is upstream of a point from this distance on, as a fraction of the sheet's side.
constexpr double nearest = 0.1;

// Offset of a line of sight from its point towards the adjacent sheets, as a fraction.
constexpr double inside = 0.1;

// Grid over the plane normal to the flow. Each cell lists the sheets that cover it.
struct Cells {
  double a0, b0, size;
  int columns, rows;
  std::vector<int> start, sheet;

  int column(double a) const {
    return std::clamp(static_cast<int>((a - a0) / size), 0, columns - 1);
  }
  int row(double b) const { return std::clamp(static_cast<int>((b - b0) / size), 0, rows - 1); }
};

}  // namespace

double speed_reduction(WakeLaw law, double solidity, double cosine) {
  const double sn = std::min(solidity, range_of(law).most_solidity);
  double r = 1.0;
  if (law == WakeLaw::loland) {
    r = 1.0 - 0.46 * sn * (0.33 + sn * (6.54 - 4.88 * sn));
  } else if (law == WakeLaw::cheng) {
    r = std::max(0.0, (cosine + 0.05 - 0.38 * sn) / (cosine + 0.05));
  }
  const double s = std::clamp((cosine - along) / (aslant - along), 0.0, 1.0);
  return 1.0 - s * s * (3.0 - 2.0 * s) * (1.0 - r);
}

void Wake::search(const double* position, const Vector& flow) {
  const int sheets_in_all = sheets_.count(), points = static_cast<int>(share_.size());
  const Vector f = flow.normalized();
  const Vector p = f.unitOrthogonal(), q = f.cross(p);
  std::vector<double> a(points), b(points), along_flow(points);
  for (int n = 0; n < points; ++n) {
    const Vector x = at(position, n);
    a[n] = p.dot(x);
    b[n] = q.dot(x);
    along_flow[n] = f.dot(x);
  }
  // A line of sight starts slightly inside the adjacent sheets. Otherwise the edge of a sheet could
  // miss another sheet that covers it.
  std::vector<Vector> around(points, Vector::Zero());
  std::vector<int> sheets(points, 0);
  for (int e = 0; e < sheets_in_all; ++e) {
    const int* n = &sheets_.node[3 * static_cast<std::size_t>(e)];
    const Vector middle = (at(position, n[0]) + at(position, n[1]) + at(position, n[2])) / 3.0;
    for (int k = 0; k < 3; ++k) {
      around[n[k]] += middle;
      ++sheets[n[k]];
    }
  }
  double low[2] = {1e300, 1e300}, high[2] = {-1e300, -1e300};
  for (const int n : sheets_.node) {
    low[0] = std::min(low[0], a[n]);
    low[1] = std::min(low[1], b[n]);
    high[0] = std::max(high[0], a[n]);
    high[1] = std::max(high[1], b[n]);
  }
  Cells cells;
  const double wide = std::max(high[0] - low[0], 1e-9), tall = std::max(high[1] - low[1], 1e-9);
  cells.a0 = low[0];
  cells.b0 = low[1];
  cells.size = std::max(std::sqrt(wide * tall / sheets_in_all), std::max(wide, tall) / 2000.0);
  cells.columns = static_cast<int>(wide / cells.size) + 1;
  cells.rows = static_cast<int>(tall / cells.size) + 1;
  cells.start.assign(static_cast<std::size_t>(cells.columns) * cells.rows + 1, 0);
  auto each_cell = [&](int e, auto visit) {
    const int* n = &sheets_.node[3 * static_cast<std::size_t>(e)];
    const auto across = std::minmax({a[n[0]], a[n[1]], a[n[2]]});
    const auto up = std::minmax({b[n[0]], b[n[1]], b[n[2]]});
    for (int r = cells.row(up.first); r <= cells.row(up.second); ++r) {
      for (int c = cells.column(across.first); c <= cells.column(across.second); ++c) {
        visit(static_cast<std::size_t>(r) * cells.columns + c);
      }
    }
  };
  for (int e = 0; e < sheets_in_all; ++e)
    each_cell(e, [&](std::size_t c) { ++cells.start[c + 1]; });
  for (std::size_t c = 1; c < cells.start.size(); ++c) cells.start[c] += cells.start[c - 1];
  cells.sheet.resize(cells.start.back());
  std::vector<int> next(cells.start.begin(), cells.start.end() - 1);
  for (int e = 0; e < sheets_in_all; ++e) {
    each_cell(e, [&](std::size_t c) { cells.sheet[next[c]++] = e; });
  }

  start_.assign(1, 0);
  crossed_.clear();
  // Points of regular nets are exactly behind edges of other sheets. A small offset makes each line
  // of sight cross one sheet only.
  const double aside_a = 1e-5 * cells.size, aside_b = 0.618e-5 * cells.size;
  for (int n = 0; n < points; ++n) {
    double x = a[n] + aside_a, y = b[n] + aside_b;
    if (sheets[n] > 0) {
      const Vector inward = around[n] / sheets[n] - at(position, n);
      x += inside * p.dot(inward);
      y += inside * q.dot(inward);
    }
    if (x >= low[0] && x <= high[0] && y >= low[1] && y <= high[1]) {
      const std::size_t c =
          static_cast<std::size_t>(cells.row(y)) * cells.columns + cells.column(x);
      for (int k = cells.start[c]; k < cells.start[c + 1]; ++k) {
        const int e = cells.sheet[k];
        const int* corner = &sheets_.node[3 * static_cast<std::size_t>(e)];
        if (corner[0] == n || corner[1] == n || corner[2] == n) continue;
        // Barycentric coordinates at (x, y).
        double w[3], whole = 0.0;
        for (int i = 0; i < 3; ++i) {
          const int j = corner[(i + 1) % 3], l = corner[(i + 2) % 3];
          w[i] = (a[j] - x) * (b[l] - y) - (a[l] - x) * (b[j] - y);
          whole += w[i];
        }
        if (whole == 0.0 || w[0] / whole < 0.0 || w[1] / whole < 0.0 || w[2] / whole < 0.0)
          continue;
        double there = 0.0;
        for (int i = 0; i < 3; ++i) there += w[i] / whole * along_flow[corner[i]];
        const Vector side = at(position, corner[1]) - at(position, corner[0]);
        if (along_flow[n] - there > nearest * side.norm()) crossed_.push_back(e);
      }
    }
    start_.push_back(static_cast<int>(crossed_.size()));
  }
}

double Wake::renew(const double* position, const Vector& flow, bool search_again, double tolerance,
                   double follow) {
  if (start_.empty() || (search_again && apart_.empty())) search(position, flow);
  const Vector f = flow.normalized();
  std::vector<double> r(static_cast<std::size_t>(sheets_.count()));
  for (int e = 0; e < sheets_.count(); ++e) {
    const int* n = &sheets_.node[3 * static_cast<std::size_t>(e)];
    const Vector x = at(position, n[0]);
    const Vector normal = (at(position, n[1]) - x).cross(at(position, n[2]) - x);
    const double twice = normal.norm();
    const double twine = 2.0 * sheets_.twine_area[e] / twice;
    r[e] = twice > 0.0
               ? speed_reduction(sheets_.law[e], solidity_of(twine, sheets_.overlap[e]).value,
                                 std::abs(normal.dot(f)) / twice)
               : 1.0;
  }
  double change = 0.0;
  std::vector<double> found(share_.size(), 1.0);
  for (std::size_t p = 0; p < found.size(); ++p) {
    for (int k = start_[p]; k < start_[p + 1]; ++k) found[p] *= r[crossed_[k]];
    if (!apart_.empty()) found[p] += apart_[p];
    change = std::max(change, std::abs(found[p] - share_[p]));
  }
  if (change <= tolerance) return change;
  if (follow < 1.0) {
    for (std::size_t p = 0; p < found.size(); ++p) {
      found[p] = share_[p] + follow * (found[p] - share_[p]);
    }
  }
  share_ = std::move(found);
  return change;
}

void Wake::keep(const double* position, const Vector& flow) {
  const std::vector<double> kept = share_;
  apart_.clear();
  renew(position, flow, true, -1.0);
  for (std::size_t p = 0; p < kept.size(); ++p) apart_.push_back(kept[p] - share_[p]);
  share_ = kept;
}

void Wake::keep_to(const Wake& other) {
  if (sheets_.count() != other.sheets_.count() || share_.size() != other.share_.size()) return;
  share_ = other.share_;
  apart_ = other.apart_;
  start_ = other.start_;
  crossed_ = other.crossed_;
}

}  // namespace codend
