// A bag of netting filled up to a front: the netting behind the front, as weights of the pressure
// on its triangles, and the volume and surface that it encloses.
#pragma once

#include <vector>

#include "../base/fields.hpp"
#include "dual.hpp"

namespace codend {

// Triangles (BagTriangles of gear/mesh.hpp) and the distance of the front from the bag's end.
struct FilledBag {
  int points = 0;                     // of the discretisation
  std::vector<int> node;              // 3 per triangle, points
  std::vector<double> depth, across;  // of the nodes, meshes from the lower edge and along it
  std::vector<double> real, weight, height;  // see BagTriangles
  double blocked = 0.0;                      // meshes behind the front

  template <class Visit>
  void fields(Visit& visit) {
    visit("points", points);
    visit.count(Among::points, static_cast<std::size_t>(points));
    visit("node", node, {3, Among::points});
    visit("depth", depth, {3});
    visit("across", across, {3});
    visit("real", real);
    visit("weight", weight);
    visit("height", height);
    visit("blocked", blocked);
  }
};

// Weights of the pressure at the triangles' corners, 3 each (elements/inner_pressure.hpp).
std::vector<double> pressure_weights(const FilledBag& bag);

// Volume (m3) enclosed by the netting behind the front and by the front, a surface from its edge to
// the edge's centroid. x: positions of all points, 3 each (m).
template <class T>
T bag_volume(const FilledBag& bag, const std::vector<T>& x);

// Area of the netting behind the front, m2.
template <class T>
T bag_surface(const FilledBag& bag, const std::vector<T>& x);

}  // namespace codend
