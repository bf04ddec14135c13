// Least vertex separators near a given cut of a graph.
#pragma once

#include <cstdint>
#include <vector>

namespace codend {

enum Side : unsigned char { near_side, far_side, separator_side };

// Nodes are the numbers in some range; node p touches neighbour[first[p] .. last[p]).
struct CutGraph {
  const int* first;
  const int* last;
  const int* neighbour;
  const int* weight;
};

class VertexCut {
 public:
  // nodes: one more than the largest node that will be seen.
  explicit VertexCut(int nodes) : band_place_(nodes, -1) {}

  // side: near_side or far_side of every node in [begin, end), on entry. On return some nodes are in
  // separator_side and no edge joins the other two. Of all separators within `layers` nodes of the
  // cut this is one of the smallest, and of the two extreme ones among these the one that divides
  // `total`, the weight of the range, more evenly (Menger's theorem; paths by Dinic 1970). The
  // layers end early where less than `share` of the weight would lie behind them.
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
  std::vector<int> band_place_;  // of a node in the band, or -1
  std::vector<int> band_;        // the nodes where a separator may lie
  std::vector<char> end_;        // of band nodes: starts or ends a path
  int64_t near_core_ = 0;        // weight of the near nodes outside the band
  std::vector<Flow> flow_;
  // states: 2 v before the node v of the band, 2 v + 1 behind it
  std::vector<int> level_, cursor_, queue_, path_;
};

}  // namespace codend
