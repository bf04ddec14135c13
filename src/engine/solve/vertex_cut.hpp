// Minimum vertex separators near a given cut of a graph.
#pragma once

#include <cstdint>
#include <vector>

namespace codend {

enum Side : unsigned char { near_side, far_side, separator_side };

// Nodes are numbers in a range; node p is adjacent to neighbour[first[p] .. last[p]).
struct CutGraph {
  const int* first;
  const int* last;
  const int* neighbour;
  const int* weight;
};

class VertexCut {
 public:
  // `nodes` is one more than the largest node number.
  explicit VertexCut(int nodes) : band_place_(nodes, -1) {}

  // Replaces a cut by a minimum separator. `side` is near_side or far_side for every node in
  // [begin, end) on entry. On return, some nodes have separator_side, and no edge joins the sides.
  //
  // The separator is a smallest one within `layers` nodes of the cut (Menger's theorem; paths by
  // Dinic 1970). The choice is between the two extreme smallest separators: the one that divides
  // `total`, the weight of the range, more evenly. Layers stop before less than `share` of the
  // weight would remain behind them.
  void separate(const CutGraph& graph, int begin, int end, int64_t total, int layers, double share,
                Side* side);

 private:
  struct Flow {
    int next;
    int previous;
  };

  void find_band(int begin, int end, int64_t total, int layers, double share, const Side* side);
  void add_layers(Side mine, int64_t behind, int layers, int64_t least, const Side* side);
  bool layer_paths();
  void augment();
  void follow_to_sink();
  void divide(int64_t total, Side* side);
  template <class Visit>
  void for_each_neighbour(int v, Visit visit) const;

  CutGraph graph_{};
  std::vector<int> band_place_;  // index of a node in the band, or -1
  std::vector<int> band_;        // candidate nodes for the separator
  std::vector<char> end_;        // per band node: start or end of a path
  int64_t near_core_ = 0;        // weight of the near nodes outside the band
  std::vector<Flow> flow_;
  // state 2 v is before node v of the band, state 2 v + 1 after it
  std::vector<int> level_, cursor_, queue_, path_;
};

}  // namespace codend
