// Mesh sizes of gears: ropes next to netting, and cell counts that are nearly whole.
#include <doctest/doctest.h>

#include <cmath>
#include <numeric>

#include "gear/resolution.hpp"

namespace {

using namespace codend;

Gear ropes(bool with_netting) {
  Gear gear;
  for (const double length : {15.0, 72.0, 576.0}) {
    GearRope rope;
    rope.length = length;
    gear.ropes.push_back(rope);
  }
  gear.rope_count = 3;
  if (with_netting) {
    GearPanel panel;
    panel.mesh_size = 0.1;
    panel.upper = panel.lower = panel.deep = 50;
    gear.panels.push_back(panel);
    gear.panel_count = 1;
  }
  return gear;
}

EdgePieces whole_edges(const Gear& gear) {
  const std::vector<char> linked(gear.panels.size(), 1);
  const ChainTable chains = chain_table(gear);
  return edge_pieces(chains, edge_breaks(chains, linked), linked);
}

}  // namespace

TEST_CASE("resolution limits rope segments next to netting by a cube root") {
  // at 1.5 m a segment, ropes would have 10, 48 and 8 times 48
  for (const bool netting : {false, true}) {
    const Gear gear = ropes(netting);
    const EdgePieces pieces = whole_edges(gear);
    const std::vector<int> count = Resolution(gear, pieces).counts(1.0).ropes;
    CHECK(count == std::vector<int>{10, 48, netting ? 96 : 384});
  }
}

TEST_CASE("resolution chooses the nearly whole cell counts within a sixth") {
  Gear gear = ropes(true);
  GearPanel panel = gear.panels[0];
  for (const double deep : {17.0, 31.0, 120.0}) {
    panel.deep = deep;
    panel.lower = 0.7 * panel.upper;
    panel.lost_left = panel.lost_right = (panel.upper - panel.lower) / 2;
    gear.panels.push_back(panel);
  }
  gear.panel_count = static_cast<int>(gear.panels.size());
  const EdgePieces pieces = whole_edges(gear);
  const Resolution resolution(gear, pieces);
  const auto off = [&](double h, double nodes) {
    const std::vector<double> count = resolution.node_counts(h);
    return std::abs(std::log(std::accumulate(count.begin(), count.end(), 0.0) / nodes));
  };
  int moved = 0;
  for (const double nodes : {1000.0, 1500.0, 2300.0}) {
    const double plain = resolution.counted_length(nodes), h = resolution.element_length(nodes);
    CHECK(resolution.rounding(h) <= resolution.rounding(plain));
    CHECK(off(h, nodes) <= std::max(0.16, off(plain, nodes)));
    moved += h != plain;
  }
  CHECK(moved > 0);
}
