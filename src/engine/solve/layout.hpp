// Approximate shape of a net of strings under given loads, by the force density method.
#pragma once

#include <functional>
#include <vector>

namespace codend {

struct StringNet {
  std::vector<char> held;       // per node
  std::vector<int> ends;        // 2 per string
  std::vector<double> rest;     // maximum length of a string, m
  std::vector<double> tension;  // initial guess per string, N, > 0
  std::vector<double> load;     // N, 3 per node
  std::vector<char> buoyant;    // per node: 1 if the water surface, z = 0, stops it; empty: none
};

// Computes x (m, 3 per node); fixed nodes are given. Every connected group needs a fixed node.
//
// With force densities q = T/L, equilibrium sum q (x_j - x_i) + load = 0 is linear in x. Each
// iteration multiplies q by the string's length over its rest length, which tightens long strings
// and slackens short ones. watch: called before every iteration; returns false to stop.
void lay_out(const StringNet& net, double* x, const std::function<bool()>& watch = nullptr);

}  // namespace codend
