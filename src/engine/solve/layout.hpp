// A crude shape of a net of strings under given loads, by force densities.
#pragma once

#include <functional>
#include <vector>

namespace codend {

struct StringNet {
  std::vector<char> held;       // per node
  std::vector<int> ends;        // 2 per string
  std::vector<double> rest;     // length that a string should have at most, m
  std::vector<double> tension;  // first guess per string, N, > 0
  std::vector<double> load;     // N, 3 per node
  std::vector<char> buoyant;    // per node: 1 if the water's surface, z = 0, stops it; empty: none
};

// x: 3 per node (m); held nodes on entry, all on return. Every connected group needs a held node.
// Repeats: with force densities q = T/L the balance sum q (x_j - x_i) + load = 0 is linear in x;
// then each q is multiplied by the string's length over its rest, so that long strings pull harder
// and short ones let go. watch: called before every repetition; returns false to stop there.
void lay_out(const StringNet& net, double* x, const std::function<bool()>& watch = nullptr);

}  // namespace codend
