#include "resolution.hpp"

#include <algorithm>
#include <cmath>

#include "sums.hpp"

namespace codend {

namespace {

// Maximum number of automatic segments per mesh bar. Slack bars of more segments prevent
// convergence without more accuracy. For a shipped gear with meshes of 32 m and 3,000 to 15,000
// nodes, 2 (4) segments give a drag of 360 to 369 kN (359 to 371), settle in 24 to 32 iterations
// (26 to 116), and settle again at another speed within 3 % in at most 14 (165).
constexpr double greatest_bar_segments = 2;
// Number of segments above which ropes in gears with netting get only the cube root of further
// refinement. A rope is smooth between its ends, so that the error with n segments is less than 1 /
// n^2 of its length. Netting errors are percents. (Half as many segments in all ropes of two nets
// of 1,500 nodes changed no spread or height by 0.01 %.)
constexpr double ample_segments = 48;
// element_length() tests `fitting_tries` element lengths within +-`fitting_range` (logarithm) of
// the length for the requested number of nodes. Below `least_fitting` nodes no test is useful.
constexpr double fitting_range = 0.08;
constexpr int fitting_tries = 33;
constexpr double least_fitting = 500;

}  // namespace

int at_least_one(double count) {
  return static_cast<int>(std::min(std::max(count, 1.0), static_cast<double>(most_nodes)));
}

Resolution::Resolution(const Gear& gear, const EdgePieces& pieces) : gear_(gear), pieces_(pieces) {
  // Cells with equal numbers of meshes across and deep follow the twines best in any shape.
  // Therefore width and depth are stretched lengths times one factor. It gives the area of netting
  // at the nominal hanging ratio.
  const double depth_ratio = std::sqrt(1 - nominal_hanging_ratio * nominal_hanging_ratio);
  for (const GearPanel& panel : gear.panels) {
    const double even =
        panel.unit() * (panel.square() ? 1.0 : std::sqrt(nominal_hanging_ratio * depth_ratio));
    width_.push_back(even * std::max(panel.upper, panel.lower));
    depth_.push_back(even * panel.deep);
    any_bars_ = any_bars_ || panel.bars;
  }
  for (int k = 0; k < pieces.count(); ++k) {
    const int p = pieces.edge[k] / 4, side = pieces.edge[k] % 4;
    const GearPanel& panel = gear.panels[p];
    const double share = pieces.to[k] - pieces.from[k];
    reach_.push_back(share * (side < 2 ? width_[p] : depth_[p]));
    weight_.push_back(share * (width_[p] * depth_[p]));
    asked_.push_back(share * (side < 2 ? panel.columns : panel.rows));
    // Maximum number of twines of one family that end on the edge. An edge that runs i meshes
    // across and j deep is crossed by |i - j| twines of one family and i + j of the other.
    const double across = std::abs(side == 2 ? panel.lost_left : panel.lost_right);
    const double ends = side == 0        ? panel.upper
                        : side == 1      ? panel.lower
                        : panel.square() ? std::max(across, panel.deep)
                                         : across + panel.deep;
    twines_.push_back(share * ends);
  }
}

Grouping Resolution::grouping(double h) const {
  Grouping out;
  for (std::size_t p = 0; p < gear_.panels.size(); ++p) {
    const GearPanel& panel = gear_.panels[p];
    const double across = (panel.upper + panel.lower) / 2;
    const double nodes_per_mesh = panel.square() ? 3 : 6;
    const double cells = std::max(3.0, width_[p] * depth_[p] / (nodes_per_mesh * (h * h)));
    double lambda = std::max(1.0, std::sqrt(across * panel.deep / cells));
    if (panel.rows > 0) lambda = panel.deep / panel.rows;
    if (panel.columns > 0) lambda = std::max(panel.upper, panel.lower) / panel.columns;
    // Whole half-rows (whole rows of square meshes), so that upper and lower edges have knots.
    const double steps = panel.square() ? 1 : 2;
    lambda = steps * panel.deep / std::max(1.0, std::nearbyint(steps * panel.deep / lambda));
    int segments = std::max(1, panel.bar_segments);
    // Screen drag acts on knots only and would leave interior nodes of bars without a force.
    const bool open = panel.bar_segments == 0 && panel.columns == 0 && panel.rows == 0;
    if (open && lambda <= 1 + 1e-9 && panel.drag == NettingDrag::morison && std::isfinite(h)) {
      segments = static_cast<int>(
          std::min(greatest_bar_segments, std::ceil(lambda * panel.mesh_size / 2 / (1.5 * h))));
    }
    out.lambda.push_back(lambda);
    out.segments.push_back(segments);
  }
  return out;
}

std::vector<double> Resolution::wanted_counts(double h) const {
  std::vector<double> wanted;
  for (std::size_t k = 0; k < reach_.size(); ++k) {
    wanted.push_back(asked_[k] > 0 ? asked_[k] : reach_[k] / h);
  }
  return wanted;
}

template <class Value>
std::vector<Value> Resolution::largest_of_joined(const std::vector<Value>& x) const {
  std::vector<Value> most = x, out;
  for (std::size_t k = 0; k < x.size(); ++k) {
    most[pieces_.joined[k]] = std::max(most[pieces_.joined[k]], x[k]);
  }
  for (std::size_t k = 0; k < x.size(); ++k) out.push_back(most[pieces_.joined[k]]);
  return out;
}

std::vector<int> Resolution::piece_counts(double h, const Grouping* grouping) const {
  std::vector<int> count;
  for (const double wanted : wanted_counts(h))
    count.push_back(at_least_one(std::nearbyint(wanted)));
  if (any_bars_ && grouping) {
    std::vector<int> least(count.size(), most_nodes);
    std::vector<char> with_cells(count.size(), 0);
    for (std::size_t k = 0; k < count.size(); ++k) {
      const int panel = pieces_.edge[k] / 4;
      int& low = least[pieces_.joined[k]];
      low = std::min(low, at_least_one(std::floor(twines_[k] / grouping->lambda[panel] + 1e-9)));
      if (!gear_.panels[panel].bars) with_cells[pieces_.joined[k]] = 1;
    }
    // Between panels of bars the coarser side determines the count, so that every seam node is
    // attached.
    for (std::size_t k = 0; k < count.size(); ++k) {
      if (!with_cells[pieces_.joined[k]]) {
        count[k] = least[pieces_.joined[k]];
      } else if (gear_.panels[pieces_.edge[k] / 4].bars) {
        count[k] = 1;
      }
    }
  }
  return largest_of_joined(count);
}

std::vector<int> Resolution::rope_counts(double h) const {
  std::vector<int> out;
  for (const GearRope& rope : gear_.ropes) {
    double wanted = rope.length / (1.5 * h);
    if (!gear_.panels.empty() && wanted > ample_segments) {
      wanted = ample_segments * std::pow(wanted / ample_segments, 1.0 / 3.0);
    }
    double count = std::isfinite(h) ? std::max(4.0, std::nearbyint(wanted)) : 1.0;
    if (rope.segments > 0) count = rope.segments;
    // A sliding rope has one element between consecutive locations.
    if (!rope.through.empty()) count = static_cast<double>(rope.through.size()) + 1;
    out.push_back(rope.laced() ? 0 : static_cast<int>(count));
  }
  return out;
}

Counts Resolution::counts(double h) const {
  Counts out;
  out.grouping = grouping(h);
  out.pieces = piece_counts(h, &out.grouping);
  out.ropes = rope_counts(h);
  return out;
}

std::vector<double> Resolution::node_counts(double h) const {
  const Counts count = counts(h);
  std::vector<double> out;
  for (std::size_t p = 0; p < gear_.panels.size(); ++p) {
    const GearPanel& panel = gear_.panels[p];
    double along[2] = {0.0, 0.0};
    for (int which = 0; which < 2; ++which) {
      const std::size_t e = 4 * p + 2 * static_cast<std::size_t>(which);
      for (int k = 0; k < pieces_.count_of[e]; ++k) {
        along[which] += count.pieces[pieces_.first[e] + k];
      }
    }
    // Hexagonal netting has an inner node in each half of a cell.
    double nodes = along[0] * along[1] * (panel.straight_bar > 0 ? 3 : 1);
    if (panel.bars) {
      const double lambda = count.grouping.lambda[p];
      const double cells = (panel.upper + panel.lower) / 2 * panel.deep / (lambda * lambda);
      const double inner = count.grouping.segments[p] - 1;
      nodes = cells * (panel.square() ? 1 + 2 * inner : 2 + 4 * inner);
    }
    out.push_back(nodes);
  }
  out.insert(out.end(), count.ropes.begin(), count.ropes.end());
  return out;
}

double Resolution::count_nodes(double h) const { return exact_sum(node_counts(h)); }

bool Resolution::is_divided() const {
  for (const GearRope& rope : gear_.ropes) {
    if (!rope.laced() && rope.through.empty() && rope.segments == 0) return false;
  }
  for (const GearPanel& panel : gear_.panels) {
    if (panel.bars && panel.rows == 0 && panel.columns == 0) return false;
    if (!panel.bars && (panel.rows == 0 || panel.columns == 0)) return false;
  }
  return true;
}

double Resolution::counted_length(double nodes) const {
  double size = 0.0;
  for (const GearRope& rope : gear_.ropes) size = std::max(size, rope.length);
  for (const double width : width_) size = std::max(size, width);
  for (const double depth : depth_) size = std::max(size, depth);
  if (is_divided()) return size;
  double low = std::log(1e-6), high = std::log(10.0);
  for (int step = 0; step < 40; ++step) {
    const double middle = (low + high) / 2;
    (count_nodes(size * std::exp(middle)) > nodes ? low : high) = middle;
    if (high - low < 1e-3) break;
  }
  return size * std::exp(high);
}

double Resolution::element_length(double nodes) const {
  const double h = counted_length(nodes);
  if (gear_.panels.empty() || any_bars_ || is_divided() || nodes < least_fitting) return h;
  const auto off = [&](double at) { return std::log(count_nodes(at) / nodes); };
  const double most = std::max(2 * fitting_range, std::abs(off(h)));
  double best = h, least = rounding(h);
  for (int k = 0; k < fitting_tries; ++k) {
    double by = -fitting_range + k * ((fitting_range + fitting_range) / (fitting_tries - 1));
    if (k == fitting_tries - 1) by = fitting_range;
    const double tried = h * std::exp(by);
    if (std::abs(off(tried)) > most) continue;
    const double rounds = rounding(tried);
    if (rounds < least) {
      least = rounds;
      best = tried;
    }
  }
  return best;
}

double Resolution::rounding(double h) const {
  const std::vector<double> wanted = largest_of_joined(wanted_counts(h));
  const std::vector<int> count = piece_counts(h, nullptr);
  std::vector<double> squares;
  for (std::size_t k = 0; k < count.size(); ++k) {
    const double off = std::log(count[k] / std::max(wanted[k], 1.0));
    squares.push_back(weight_[k] * (off * off));
  }
  return std::sqrt(exact_sum(squares) / exact_sum(weight_));
}

}  // namespace codend
