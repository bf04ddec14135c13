// Table of all fields of a struct (fields.hpp), for programs that build models outside the engine.
#pragma once

#include <string>
#include <type_traits>
#include <vector>

#include "fields.hpp"
#include "geometry.hpp"
#include "names.hpp"

namespace codend {

struct FieldRow {
  std::string kind;  // path of the group with dots; "" outside any group
  std::string name;
  std::string type;   // "number", "whole" (integer), "mark" (true or false) or "name"
  int width;          // values per entry
  std::string per;    // unit that has one entry: see Per; "group": one entry per group
  std::string among;  // see Among
};

class FieldTable {
 public:
  std::vector<FieldRow> rows;

  template <class Value>
  void operator()(const char* name, std::vector<Value>&, Shape shape = {}) {
    add<Value>(name, shape, name_of(shape.per));
  }
  template <class Value>
  void operator()(const char* name, Value&, Shape shape = {}) {
    add<Value>(name, shape, "group");
  }
  void operator()(const char* name, Vector&) { add<double>(name, {3}, "group"); }
  template <class Value, std::size_t n>
  void operator()(const char* name, std::array<Value, n>&, Shape shape = {}) {
    using Number = std::conditional_t<std::is_same_v<Value, Vector>, double, Value>;
    shape.width = static_cast<int>(n) * (std::is_same_v<Value, Vector> ? 3 : 1);
    add<Number>(name, shape, "group");
  }
  template <class Struct>
  void group(const char* name, Struct& of) {
    const std::string outer = kind_;
    kind_ = outer.empty() ? name : outer + "." + name;
    of.fields(*this);
    kind_ = outer;
  }
  template <class Struct>
  void optional(const char* name, Struct& of) {
    group(name, of);
  }
  template <class Struct>
  void optional(const char* name, Struct& of, bool&) {
    group(name, of);
  }
  void component(const char* name, std::vector<Vector>&, int) {
    add<double>(name, {}, name_of(Per::element));
  }
  template <class Value>
  void list(const char* name, std::vector<Value>&, Shape shape = {}) {
    add<Value>(name, shape, "group");
  }
  template <class Struct>
  void items(const char* name, std::vector<Struct>&) {
    Struct one;
    group(name, one);
  }
  template <class Struct>
  void columns(const char* name, std::vector<Struct>&) {
    const std::size_t first = rows.size();
    Struct one;
    group(name, one);
    for (std::size_t k = first; k < rows.size(); ++k) rows[k].per = name_of(Per::element);
  }
  void count(Among, std::size_t) {}

 private:
  template <class Value>
  void add(const char* name, Shape shape, const std::string& per) {
    const char* type = std::is_enum_v<Value>           ? "name"
                       : std::is_same_v<Value, double> ? "number"
                       : std::is_same_v<Value, int>    ? "whole"
                                                       : "mark";
    rows.push_back({kind_, name, type, shape.width, per, name_of(shape.among)});
  }
  std::string kind_;
};

template <class Struct>
std::vector<FieldRow> field_table() {
  FieldTable table;
  Struct one;
  one.fields(table);
  return table.rows;
}

}  // namespace codend
