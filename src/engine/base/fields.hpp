// The arrays of a model by name. Each struct names its own, once, in the order in which they are read:
//
//   template <class Visit>
//   void fields(Visit& visit) {
//     visit("node", node, {2, Among::points});
//     visit("rest", rest);
//   }
//
// From this come the reader of models with its checks (read_fields.hpp) and the table by which others
// fill a model (field_table.hpp). Visit offers, with `shape` left out for one number per element:
//   visit(name, array or number, shape)   numbers, places, marks (char), enumerations, Vectors
//   visit.group(name, struct)             the fields of a struct under its name
//   visit.optional(name, struct, given)   the same where it is given: given (bool) says so, and may be
//                                         left out
//   visit.component(name, vectors, k)     component k of an array of Vectors
//   visit.columns(name, vector<struct>)   one array per field
//   visit.items(name, vector<struct>)     one group per element
//   visit.list(name, array, shape)        an array of a length of its own
//   visit.count(among, n)                 how many there are of what later places refer to
#pragma once

#include <array>

namespace codend {

// What the whole numbers of an array are: numbers, or places among others.
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

// What there is one entry per.
enum class Per { element, node, point };
constexpr std::array<const char*, 3> names_of(Per) { return {"element", "node", "point"}; }

struct Shape {
  int width = 1;  // numbers per entry
  Among among = Among::numbers;
  Per per = Per::element;
  bool or_none = false;  // a place may be missing; an array may be empty
};

}  // namespace codend
