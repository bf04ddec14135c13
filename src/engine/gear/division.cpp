#include "division.hpp"

#include <algorithm>
#include <cmath>

#include "sums.hpp"

namespace codend {

int EdgeNodes::cell_of(double x, int edge) const {
  const auto first = fraction.begin() + before[edge];
  const int past = static_cast<int>(std::upper_bound(first, first + count[edge], x) - first);
  return before[edge] + std::min(std::max(past - 1, 0), count[edge] - 2);
}

namespace {

// Piecewise linear interpolation at v; constant beyond the ends. x increases.
double between(double v, const std::vector<double>& x, const std::vector<double>& y) {
  std::size_t i = 0, j = x.size() - 1;
  if (v < x[i]) return y[i];
  if (v > x[j]) return y[j];
  while (i + 1 < j) {
    const std::size_t middle = (i + j) / 2;
    (v < x[middle] ? j : i) = middle;
  }
  if (v == x[j]) return y[j];
  if (v == x[i]) return y[i];
  return y[i] + (y[j] - y[i]) * ((v - x[i]) / (x[j] - x[i]));
}

// Converts fractions of a chain's stretched length to fractions of the rope's length. shares: parts
// of the rope's length along the chain's edges.
void share_out(std::vector<double>& at, const ChainTable& chains, int chain,
               const std::vector<double>& shares) {
  const double total = exact_sum(shares);
  std::vector<double> reached = exact_running_sum(shares);
  std::vector<double> x = {0.0}, y = {0.0}, number = {1.0};
  for (std::size_t k = 0; k < shares.size(); ++k) {
    const double end = chains.end[chains.first[chain] + k], share = reached[k] / total;
    if (end == x.back()) {
      y.back() = (y.back() * number.back() + share) / (number.back() + 1.0);
      number.back() += 1.0;
    } else {
      x.push_back(end);
      y.push_back(share);
      number.push_back(1.0);
    }
  }
  for (double& a : at) a = x.size() > 1 ? between(a, x, y) : y[0];
}

// Returns the first node nearest to a fraction.
int nearest(const NodeRun& run, double share) {
  std::size_t best = 0;
  for (std::size_t k = 1; k < run.at.size(); ++k) {
    if (std::abs(run.at[k] - share) < std::abs(run.at[best] - share)) best = k;
  }
  return run.node[best];
}

// Node numbers on the edges of panels before edges are joined. A panel of cells uses the numbers of
// its grid, a panel of bars consecutive numbers. Node k of edge e is offset[e] + step[e] k.
struct EdgeNumbers {
  std::vector<int> base, size;  // per panel: preceding nodes, own nodes
  std::vector<int> offset, step;
  int operator()(int edge, int k) const { return offset[edge] + step[edge] * k; }
};
EdgeNumbers number_edges(const std::vector<int>& count, const std::vector<char>& bars, int from) {
  EdgeNumbers out;
  for (std::size_t p = 0; p < bars.size(); ++p) {
    const int* of = &count[4 * p];
    const int size = bars[p] ? of[0] + of[1] + of[2] + of[3] : of[0] * of[2];
    if (bars[p]) {
      out.offset.insert(out.offset.end(),
                        {from, from + of[0], from + of[0] + of[1], from + size - of[3]});
      out.step.insert(out.step.end(), {1, 1, 1, 1});
    } else {
      out.offset.insert(out.offset.end(), {from, from + size - of[0], from, from + of[0] - 1});
      out.step.insert(out.step.end(), {1, 1, of[0], of[0]});
    }
    out.base.push_back(from);
    out.size.push_back(size);
    from += size;
  }
  return out;
}

}  // namespace

Division divide(const Gear& gear, const ChainTable& chains, const EdgePieces& pieces,
                const std::vector<int>& piece_counts, const std::vector<int>& rope_counts,
                const std::vector<char>& bars) {
  Division out;
  EdgeNodes& edges = out.edges;
  for (std::size_t e = 0; e < pieces.count_of.size(); ++e) {
    edges.before.push_back(static_cast<int>(edges.fraction.size()));
    for (int k = pieces.first[e]; k < pieces.first[e] + pieces.count_of[e]; ++k) {
      for (int step = 0; step < piece_counts[k]; ++step) {
        edges.fraction.push_back(pieces.from[k] +
                                 (pieces.to[k] - pieces.from[k]) * step / piece_counts[k]);
      }
    }
    edges.fraction.push_back(1.0);
    edges.count.push_back(static_cast<int>(edges.fraction.size()) - edges.before.back());
  }
  const int points = gear.point_count;
  const EdgeNumbers on = number_edges(edges.count, bars, points);
  const auto last_on = [&](int edge) { return on(edge, edges.count[edge] - 1); };

  // Numbers all nodes, before identical nodes are joined.
  int numbered = points;
  for (const int size : on.size) numbered += size;
  std::vector<NodeRun> ropes;
  for (std::size_t r = 0; r < gear.ropes.size(); ++r) {
    NodeRun run;
    if (!gear.ropes[r].laced()) {
      const int n = gear.ropes[r].through.empty()
                        ? rope_counts[r]
                        : static_cast<int>(gear.ropes[r].through.size()) + 1;
      for (int k = 0; k <= n; ++k) {
        run.node.push_back(numbered++);
        run.at.push_back(k == n ? 1.0 : k * (1.0 / n));
      }
    }
    ropes.push_back(std::move(run));
  }
  Joined joined(numbered);

  Covered cover = covered(chains, edges.count, [&](int row, int k) {
    const double f = edges.fraction[edges.before[chains.edge[row]] + k];
    return f > chains.low(row) - break_tolerance && f < chains.high(row) + break_tolerance;
  });
  // Two consecutive edges of a chain share one node.
  for (int c = 0; c < chains.chains(); ++c) {
    int ends = 0;
    for (int row = chains.first[c]; row < chains.first[c] + chains.rows[c]; ++row) {
      const int begins = on(chains.edge[row], cover.begin[row]);
      const int ends_now =
          on(chains.edge[row], cover.begin[row] + cover.way[row] * (cover.number[row] - 1));
      if (row > chains.first[c]) {
        joined.join(ends, begins);
        cover.begin[row] += cover.way[row];
        cover.number[row] -= 1;
      }
      ends = ends_now;
    }
  }
  const auto run_of = [&](int chain) {
    NodeRun run;
    for (const Thing& thing : along_chain(chains, cover, chain)) {
      const int row = thing.row, edge = chains.edge[row];
      run.node.push_back(on(edge, thing.k));
      run.at.push_back(chains.start[row] +
                       (edges.fraction[edges.before[edge] + thing.k] - chains.from[row]) /
                           (chains.to[row] - chains.from[row]) *
                           (chains.end[row] - chains.start[row]));
    }
    return run;
  };
  for (std::size_t s = 0; s < chains.seam_first.size(); ++s) {
    const NodeRun first = run_of(chains.seam_first[s]);
    for (int c = 1; c < chains.seam_count[s]; ++c) {
      const NodeRun other = run_of(chains.seam_first[s] + c);
      for (std::size_t k = 0; k < std::min(first.node.size(), other.node.size()); ++k) {
        joined.join(first.node[k], other.node[k]);
      }
    }
  }
  for (std::size_t p = 0; p < bars.size(); ++p) {
    const int upper = 4 * static_cast<int>(p), lower = upper + 1, left = upper + 2,
              right = upper + 3;
    if (bars[p]) {
      joined.join(on(upper, 0), on(left, 0));
      joined.join(on(lower, 0), last_on(left));
      joined.join(last_on(upper), on(right, 0));
      joined.join(last_on(lower), last_on(right));
    }
    // The tip of a pointed panel is one node, even if no seam gathers it.
    for (const int tip : {upper, lower}) {
      if ((tip == upper ? gear.panels[p].upper : gear.panels[p].lower) != 0.0) continue;
      for (int k = 1; k < edges.count[tip]; ++k) joined.join(on(tip, k - 1), on(tip, k));
    }
  }
  for (const ChainTable::Held& held : chains.held) {
    Division::Held found;
    static_cast<NodeRun&>(found) = run_of(held.chain);
    found.seam = held.seam;
    found.points = held.points;
    joined.join(found.node.front(), held.points[0]);
    joined.join(found.node.back(), held.points[1]);
    out.held_edges.push_back(std::move(found));
  }
  for (std::size_t r = 0; r < gear.ropes.size(); ++r) {
    if (!gear.ropes[r].laced()) continue;
    ropes[r] = run_of(chains.laced[r]);
    if (!gear.ropes[r].shares.empty()) {
      share_out(ropes[r].at, chains, chains.laced[r], gear.ropes[r].shares);
    }
  }

  std::vector<int> places;
  for (int k = 0; k < points; ++k) places.push_back(k);
  for (std::size_t p = 0; p < bars.size(); ++p) {
    for (int edge = 4 * static_cast<int>(p); edge % 4 < 2; ++edge) {
      places.push_back(on(edge, 0));
      places.push_back(last_on(edge));
    }
  }
  for (const NodeRun& rope : ropes) {
    places.insert(places.end(), {rope.node.front(), nearest(rope, 0.5), rope.node.back()});
  }
  for (const SharePlace& place : gear.share_places) {
    places.push_back(nearest(ropes[place.rope], place.share));
  }
  for (std::size_t r = 0; r < gear.ropes.size(); ++r) {
    const GearRope& rope = gear.ropes[r];
    if (rope.laced()) continue;
    joined.join(ropes[r].node.front(), places[rope.from]);
    joined.join(ropes[r].node.back(), places[rope.to]);
    for (std::size_t k = 0; k < rope.through.size(); ++k) {
      joined.join(ropes[r].node[k + 1], places[rope.through[k]]);
    }
  }
  for (int k = 0; k < points; ++k) {
    if (gear.points[k].at >= 0) joined.join(k, places[gear.points[k].at]);
  }
  for (const auto& [chain, place] : chains.gathered) {
    for (const int node : run_of(chain).node) joined.join(node, places[place]);
  }

  // Numbers nodes in order of first appearance.
  std::vector<int> number(static_cast<std::size_t>(numbered));
  for (int k = 0; k < numbered; ++k) {
    const int label = joined(k);
    number[k] = label == k ? out.nodes++ : number[label];
  }
  const auto renumber = [&](NodeRun run) {
    for (int& node : run.node) node = number[node];
    return run;
  };
  for (std::size_t e = 0; e < edges.count.size(); ++e) {
    for (int k = 0; k < edges.count[e]; ++k) {
      edges.edge_node.push_back(number[on(static_cast<int>(e), k)]);
    }
  }
  for (std::size_t p = 0; p < bars.size(); ++p) {
    Grid grid;
    if (!bars[p]) {
      grid.columns = edges.count[4 * p];
      for (int k = 0; k < on.size[p]; ++k) grid.node.push_back(number[on.base[p] + k]);
    }
    out.grids.push_back(std::move(grid));
  }
  for (const NodeRun& rope : ropes) out.ropes.push_back(renumber(rope));
  for (const int chain : chains.run) {
    out.runs.push_back(chain < 0 ? NodeRun() : renumber(run_of(chain)));
  }
  for (Division::Held& held : out.held_edges) static_cast<NodeRun&>(held) = renumber(held);
  for (const int place : places) out.places.push_back(number[place]);
  return out;
}

}  // namespace codend
