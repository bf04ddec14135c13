#include "edges.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sums.hpp"

namespace codend {

Joined::Joined(int count) : label_(static_cast<std::size_t>(count)) {
  std::iota(label_.begin(), label_.end(), 0);
}
int Joined::operator()(int a) {
  while (label_[a] != a) a = label_[a] = label_[label_[a]];
  return a;
}
void Joined::join(int a, int b) {
  a = (*this)(a);
  b = (*this)(b);
  label_[std::max(a, b)] = std::min(a, b);
}

bool ChainTable::whole(int row) const { return std::abs(to[row] - from[row]) == 1.0; }

double edge_length(const GearPanel& panel, int side) {
  const double across = std::abs(side == 0   ? panel.upper
                                 : side == 1 ? panel.lower
                                 : side == 2 ? panel.lost_left
                                             : panel.lost_right);
  const double down = side >= 2 ? panel.deep : 0.0;
  if (panel.square()) return panel.mesh_size / 2 * (across + down);
  const bool turned = panel.orientation == MeshOrientation::hexagonal_turned;
  if (turned || panel.orientation == MeshOrientation::hexagonal) {
    // Steps along straight bars and adjacent oblique bars advance equally down and across. The
    // remaining distance follows oblique bars, and also straight bars if it is in their direction.
    const double short_way = panel.mesh_size - 2 * panel.straight_bar;
    const double long_way = turned ? across : down;
    return panel.mesh_size * long_way +
           short_way * std::max(0.0, (turned ? down : across) - long_way);
  }
  return panel.mesh_size * std::max(across, down);
}

namespace {

int add_chain(ChainTable& table, const Gear& gear, const std::vector<Link>& links) {
  const std::size_t first = table.edge.size();
  std::vector<double> length;
  for (const Link& link : links) {
    table.edge.push_back(link.edge);
    table.from.push_back(link.from);
    table.to.push_back(link.to);
    table.start.push_back(0.0);
    table.end.push_back(1.0);
    length.push_back(std::abs(link.to - link.from) *
                     edge_length(gear.panels[link.edge / 4], link.edge % 4));
  }
  if (links.size() > 1) {
    if (exact_sum(length) == 0.0) std::fill(length.begin(), length.end(), 1.0);
    const double total = exact_sum(length);
    const std::vector<double> reached = exact_running_sum(length);
    for (std::size_t k = 0; k < links.size(); ++k) {
      table.start[first + k] = k == 0 ? 0.0 : reached[k - 1] / total;
      table.end[first + k] = reached[k] / total;
    }
  }
  table.first.push_back(static_cast<int>(first));
  table.rows.push_back(static_cast<int>(links.size()));
  return table.chains() - 1;
}

// Inserts breaks that are not yet known.
std::vector<double> merge_breaks(std::vector<double> known, const std::vector<double>& found) {
  for (const double f : found) {
    double nearest = INFINITY;
    int before = 0;
    for (const double k : known) {
      nearest = std::min(nearest, std::abs(f - k));
      before += k < f;
    }
    if (nearest > break_tolerance) known.insert(known.begin() + before, f);
  }
  return known;
}

}  // namespace

ChainTable chain_table(const Gear& gear) {
  ChainTable table;
  for (std::size_t s = 0; s < gear.seams.size(); ++s) {
    const GearSeam& seam = gear.seams[s];
    if (seam.gathered_at >= 0) continue;
    table.seam_first.push_back(table.chains());
    table.seam_count.push_back(static_cast<int>(seam.chains.size()));
    for (const Chain& chain : seam.chains) add_chain(table, gear, chain.links);
    if (seam.held_between[0] >= 0) {
      table.held.push_back({static_cast<int>(s), table.seam_first.back(), seam.held_between});
    }
  }
  for (const GearRope& rope : gear.ropes) {
    table.laced.push_back(rope.laced() ? add_chain(table, gear, rope.along) : -1);
  }
  for (const GearPiece& piece : gear.pieces) {
    table.run.push_back(piece.along.empty() ? -1 : add_chain(table, gear, piece.along));
  }
  for (const GearSeam& seam : gear.seams) {
    if (seam.gathered_at < 0) continue;
    for (const Chain& chain : seam.chains) {
      table.gathered.emplace_back(add_chain(table, gear, chain.links), seam.gathered_at);
    }
  }
  for (const SharePlace& place : gear.share_places) {
    const int chain = table.laced[place.rope];
    if (chain < 0) continue;
    int row = table.first[chain];
    for (int k = 1; k < table.rows[chain]; ++k) {
      if (table.start[table.first[chain] + k] <= place.share) row = table.first[chain] + k;
    }
    const double within = (place.share - table.start[row]) / (table.end[row] - table.start[row]);
    table.marks.push_back(
        {table.edge[row], table.from[row] + within * (table.to[row] - table.from[row])});
  }
  return table;
}

std::vector<Thing> along_chain(const ChainTable& chains, const Covered& covered, int chain) {
  std::vector<Thing> out;
  for (int row = chains.first[chain]; row < chains.first[chain] + chains.rows[chain]; ++row) {
    for (int k = 0; k < covered.number[row]; ++k) {
      out.push_back({row, covered.begin[row] + covered.way[row] * k});
    }
  }
  return out;
}

Breaks edge_breaks(const ChainTable& chains, const std::vector<char>& linked) {
  Breaks breaks(4 * linked.size(), {0.0, 1.0});
  const int rows = static_cast<int>(chains.edge.size());
  for (int row = 0; row < rows; ++row) {
    std::vector<double>& known = breaks[chains.edge[row]];
    if (!chains.whole(row)) known = merge_breaks(known, {chains.from[row], chains.to[row]});
  }
  for (const ChainTable::Mark& mark : chains.marks) {
    breaks[mark.edge] = merge_breaks(breaks[mark.edge], {mark.share});
  }

  // Chains of seams come first in the table.
  const int seams = static_cast<int>(chains.seam_first.size());
  std::vector<std::vector<int>> rows_of(static_cast<std::size_t>(seams));
  std::vector<std::vector<int>> seams_of(breaks.size());
  for (int s = 0; s < seams; ++s) {
    for (int c = chains.seam_first[s]; c < chains.seam_first[s] + chains.seam_count[s]; ++c) {
      for (int k = 0; k < chains.rows[c]; ++k) rows_of[s].push_back(chains.first[c] + k);
    }
    for (const int row : rows_of[s]) {
      std::vector<int>& known = seams_of[chains.edge[row]];
      if (known.empty() || known.back() != s) known.push_back(s);
    }
  }

  // Edges with interior breaks pass them to their neighbours. A seam between two whole edges passes
  // breaks only when it receives some.
  std::vector<int> waiting;
  std::vector<char> waits(breaks.size(), 0);
  const auto wait = [&](int edge) {
    if (waits[edge]) return;
    waits[edge] = 1;
    waiting.push_back(edge);
  };
  for (std::size_t e = 0; e < breaks.size(); ++e) {
    if (breaks[e].size() > 2) wait(static_cast<int>(e));
  }
  for (int s = 0; s < seams; ++s) {
    if (static_cast<int>(rows_of[s].size()) <= chains.seam_count[s]) continue;
    for (const int row : rows_of[s]) wait(chains.edge[row]);
  }
  const auto give = [&](int edge, const std::vector<double>& found) {
    std::vector<double> merged = merge_breaks(breaks[edge], found);
    if (merged.size() <= breaks[edge].size()) return;
    breaks[edge] = std::move(merged);
    wait(edge);
  };
  for (std::size_t next = 0; next < waiting.size(); ++next) {
    const int e = waiting[next];
    waits[e] = 0;
    if (linked[e / 4]) give(opposite_edge(e), breaks[e]);
    for (const int s : seams_of[e]) {
      std::vector<double> on_seam;
      for (int c = 0; c < chains.seam_count[s]; ++c) {
        const int chain = chains.seam_first[s] + c;
        std::vector<double> on_chain;
        for (int row = chains.first[chain]; row < chains.first[chain] + chains.rows[chain]; ++row) {
          for (const double f : breaks[chains.edge[row]]) {
            if (f < chains.low(row) - break_tolerance || f > chains.high(row) + break_tolerance)
              continue;
            on_chain.push_back(chains.start[row] + (f - chains.from[row]) /
                                                       (chains.to[row] - chains.from[row]) *
                                                       (chains.end[row] - chains.start[row]));
          }
        }
        on_seam = c == 0 ? on_chain : merge_breaks(on_seam, on_chain);
      }
      for (const int row : rows_of[s]) {
        std::vector<double> found;
        for (const double f : on_seam) {
          if (f <= chains.start[row] - break_tolerance || f >= chains.end[row] + break_tolerance)
            continue;
          found.push_back(chains.from[row] + (f - chains.start[row]) /
                                                 (chains.end[row] - chains.start[row]) *
                                                 (chains.to[row] - chains.from[row]));
        }
        give(chains.edge[row], found);
      }
    }
  }
  return breaks;
}

EdgePieces edge_pieces(const ChainTable& chains, const Breaks& breaks,
                       const std::vector<char>& linked) {
  EdgePieces out;
  for (std::size_t e = 0; e < breaks.size(); ++e) {
    out.first.push_back(out.count());
    out.count_of.push_back(static_cast<int>(breaks[e].size()) - 1);
    for (std::size_t k = 0; k + 1 < breaks[e].size(); ++k) {
      out.edge.push_back(static_cast<int>(e));
      out.from.push_back(breaks[e][k]);
      out.to.push_back(breaks[e][k + 1]);
    }
  }
  Joined joined(out.count());
  for (std::size_t p = 0; p < linked.size(); ++p) {
    for (int side = 0; linked[p] && side < 4; side += 2) {
      const int e = 4 * static_cast<int>(p) + side;
      for (int k = 0; k < out.count_of[e]; ++k) joined.join(out.first[e] + k, out.first[e + 1] + k);
    }
  }
  const Covered cover = covered(chains, out.count_of, [&](int row, int k) {
    const int piece = out.first[chains.edge[row]] + k;
    return out.from[piece] > chains.low(row) - break_tolerance &&
           out.to[piece] < chains.high(row) + break_tolerance;
  });
  for (std::size_t s = 0; s < chains.seam_first.size(); ++s) {
    const int first = chains.seam_first[s];
    const std::vector<Thing> of = along_chain(chains, cover, first);
    for (int c = 1; c < chains.seam_count[s]; ++c) {
      const std::vector<Thing> other = along_chain(chains, cover, first + c);
      for (std::size_t k = 0; k < std::min(of.size(), other.size()); ++k) {
        joined.join(out.first[chains.edge[of[k].row]] + of[k].k,
                    out.first[chains.edge[other[k].row]] + other[k].k);
      }
    }
  }
  for (int k = 0; k < out.count(); ++k) out.joined.push_back(joined(k));
  return out;
}

}  // namespace codend
