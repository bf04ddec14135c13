// Fields of a struct by name. Each struct lists its fields once, in reading order:
//
//   template <class Visit>
//   void fields(Visit& visit) {
//     visit("node", node, {2, Among::points});
//     visit("rest", rest);
//   }
//
// The reader with its checks (read_fields.hpp) and the field table (field_table.hpp) use this list.
// Visit provides, with `shape` omitted for one number per element:
//
//   visit(name, value, shape)             numbers, indices, flags (char), enumerations, Vectors
//   visit.component(name, vectors, k)     component k of each Vector
//   visit.list(name, array, shape)        an array of independent length
//
// and for groups, where `given` (bool) may be omitted:
//
//   visit.group(name, struct)             its fields under this name
//   visit.optional(name, struct, given)   an optional group
//   visit.columns(name, vector<struct>)   one array per field
//   visit.items(name, vector<struct>)     one group per element
//
// visit.count(among, n) sets the number of objects that later indices refer to.
#pragma once

#include <array>

namespace codend {

// Type of integer values: plain numbers, or indices of other objects.
enum class Among {
  numbers,
  nodes,
  points,
  bars,
  materials,
  own_materials,
  places,
  edges,
  ropes,
  panels,
  parts,
  elements
};
constexpr std::array<const char*, 12> names_of(Among) {
  return {"numbers", "nodes", "points", "bars",   "materials", "own materials",
          "places",  "edges", "ropes",  "panels", "parts",     "elements"};
}

// Object that has one entry.
enum class Per { element, node, point };
constexpr std::array<const char*, 3> names_of(Per) { return {"element", "node", "point"}; }

struct Shape {
  int width = 1;  // numbers per entry
  Among among = Among::numbers;
  Per per = Per::element;
  bool or_none = false;  // an index may be missing; an array may be empty
};

}  // namespace codend
