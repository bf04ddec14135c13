// Writes a model as the text that TextSource reads: the inverse of read_fields().
#pragma once

#include <array>
#include <cstdio>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "codend.hpp"
#include "model/cell_list.hpp"

namespace codend {

class TextWriter {
 public:
  std::string text;

  // cells: entries in the list of cells, which a model splits when it is read. given: names of the
  // optional groups to write.
  TextWriter(CellList cells, std::set<std::string> given)
      : cells_(std::move(cells)), given_(std::move(given)) {}

  template <class Value>
  void operator()(const char* name, const std::vector<Value>& of, Shape shape = {}) {
    text += path(name) + " " + type<Value>() + " " + std::to_string(of.size());
    for (const Value& value : of) text += " " + word(value, shape);
    text += "\n";
  }
  template <class Value>
  void operator()(const char* name, const Value& of, Shape shape = {}) {
    (*this)(name, std::vector<Value>{of}, shape);
  }
  void operator()(const char* name, bool of) { (*this)(name, static_cast<char>(of)); }
  void operator()(const char* name, const Vector& of) {
    (*this)(name, std::vector<double>(of.data(), of.data() + 3));
  }
  template <std::size_t n>
  void operator()(const char* name, const std::array<int, n>& of, Shape shape) {
    (*this)(name, std::vector<int>(of.begin(), of.end()), shape);
  }
  template <std::size_t n>
  void operator()(const char* name, const std::array<Vector, n>& of) {
    std::vector<double> numbers;
    for (const Vector& one : of) numbers.insert(numbers.end(), one.data(), one.data() + 3);
    (*this)(name, numbers);
  }
  template <class Struct>
  void group(const char* name, Struct& of) {
    const std::string outer = prefix_;
    prefix_ = path(name) + ".";
    if constexpr (std::is_same_v<Struct, DividedCells>) {
      CellList cells = cells_;
      cells.fields(*this);
    } else {
      of.fields(*this);
    }
    prefix_ = outer;
  }
  template <class Struct>
  void optional(const char* name, Struct& of, bool& given) {
    given = given_.count(name) > 0;
    if (given) group(name, of);
  }
  template <class Struct>
  void optional(const char* name, Struct& of) {
    bool given;
    optional(name, of, given);
  }
  void component(const char* name, const std::vector<Vector>& of, int k) {
    std::vector<double> numbers;
    for (const Vector& one : of) numbers.push_back(one[k]);
    (*this)(name, numbers);
  }
  template <class Struct>
  void columns(const char* name, std::vector<Struct>& of) {
    Columns columns;
    Struct none;
    none.fields(columns);
    columns.counting = true;
    for (Struct& row : of) {
      columns.next = 0;
      row.fields(columns);
    }
    for (const Column& column : columns.column) {
      text += path(name) + "." + column.name + " " + column.type + " " + std::to_string(of.size()) +
              column.words + "\n";
    }
  }
  template <class Struct>
  void items(const char* name, std::vector<Struct>& of) {
    text += path(name) + " list " + std::to_string(of.size()) + "\n";
    for (std::size_t k = 0; k < of.size(); ++k) {
      group((std::string(name) + "." + std::to_string(k + 1)).c_str(), of[k]);
    }
  }
  void count(Among, std::size_t) {}

 private:
  struct Column {
    std::string name, type, words;
  };
  // Row by row, one column per field.
  struct Columns {
    std::vector<Column> column = {};
    bool counting = false;
    std::size_t next = 0;

    template <class Value>
    void operator()(const char* name, const Value& of, Shape shape = {}) {
      using Held = std::conditional_t<std::is_same_v<Value, bool>, char, Value>;
      if (counting) {
        column[next++].words += " " + word(static_cast<Held>(of), shape);
      } else {
        column.push_back({name, type<Held>(), ""});
      }
    }
  };

  template <class Value>
  static const char* type() {
    if (std::is_enum_v<Value>) return "name";
    return std::is_same_v<Value, double> ? "number" : std::is_same_v<Value, int> ? "whole" : "mark";
  }
  template <class Value>
  static std::string word(const Value& value, Shape shape) {
    if constexpr (std::is_enum_v<Value>) {
      return name_of(value);
    } else if constexpr (std::is_same_v<Value, double>) {
      char digits[32];
      std::snprintf(digits, sizeof digits, "%.17g", value);
      return digits;
    } else {
      return std::to_string(static_cast<int>(value) + (shape.among != Among::numbers ? 1 : 0));
    }
  }
  std::string path(const std::string& name) const { return prefix_ + name; }

  const CellList cells_;
  const std::set<std::string> given_;
  std::string prefix_;  // of the group, with its last dot
};

}  // namespace codend
