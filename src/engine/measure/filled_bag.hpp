// A bag of netting that is filled up to a front: which part of its netting lies behind the front, as
// weights of the pressure on its triangles, and the volume and surface that this encloses.
#pragma once

#include <vector>

#include "../base/fields.hpp"
#include "dual.hpp"

namespace codend {

// The triangles of gear/lattice.hpp's BagTriangles, and how far the front lies from the bag's end.
struct FilledBag {
  int points = 0;                     // of the lattice
  std::vector<int> node;              // 3 each, points
  std::vector<double> depth, across;  // of these, meshes from the lower edge and along it
  std::vector<double> real, weight;   // shares of each, see BagTriangles
  double blocked = 0.0;               // meshes behind the front

  template <class Visit>
  void fields(Visit& visit) {
    visit("points", points);
    visit.count(Among::points, static_cast<std::size_t>(points));
    visit("node", node, {3, Among::points});
    visit("depth", depth, {3});
    visit("across", across, {3});
    visit("real", real);
    visit("weight", weight);
    visit("blocked", blocked);
  }
};

// Weights of the pressure at the triangles' corners, 3 each (elements/inner_pressure.hpp).
std::vector<double> pressure_weights(const FilledBag& bag);

// Volume (m3) that netting behind the front encloses with a front drawn from its edge to the edge's
// middle; x: positions of all points, 3 each (m).
template <class T>
T bag_volume(const FilledBag& bag, const std::vector<T>& x);

// Area (m2) of the netting behind the front.
template <class T>
T bag_surface(const FilledBag& bag, const std::vector<T>& x);

}  // namespace codend
