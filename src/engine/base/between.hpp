// Interpolation between two structs by their fields (fields.hpp).
#pragma once

#include <cstdint>
#include <optional>
#include <type_traits>
#include <vector>

#include "fields.hpp"
#include "geometry.hpp"

namespace codend {

// Collects pointers to all numbers of a struct, and a copy of all its other values.
struct NumberPlaces {
  std::vector<double*> number;
  std::vector<std::int64_t> rest;

  void operator()(const char*, double& one, Shape = {}) { number.push_back(&one); }
  void operator()(const char*, Vector& one, Shape = {}) {
    for (int k = 0; k < 3; ++k) number.push_back(&one[k]);
  }
  // Indices, flags and enumerations.
  template <class Whole,
            std::enable_if_t<std::is_integral_v<Whole> || std::is_enum_v<Whole>, int> = 0>
  void operator()(const char*, Whole& one, Shape = {}) {
    rest.push_back(static_cast<std::int64_t>(one));
  }
  template <class Value, std::size_t n>
  void operator()(const char* name, std::array<Value, n>& all, Shape = {}) {
    for (Value& one : all) (*this)(name, one);
  }
  template <class Value>
  void operator()(const char* name, std::vector<Value>& all, Shape = {}) {
    count(all);
    for (Value& one : all) (*this)(name, one);
  }
  template <class Value>
  void list(const char* name, std::vector<Value>& all, Shape = {}) {
    (*this)(name, all);
  }
  void component(const char*, std::vector<Vector>& all, int k) {
    count(all);
    for (Vector& one : all) number.push_back(&one[k]);
  }
  template <class Struct>
  void group(const char*, Struct& of) {
    of.fields(*this);
  }
  template <class Struct>
  void optional(const char*, Struct& of) {
    of.fields(*this);
  }
  template <class Struct>
  void optional(const char*, Struct& of, bool& given) {
    rest.push_back(given);
    if (given) of.fields(*this);
  }
  template <class Struct>
  void items(const char*, std::vector<Struct>& all) {
    count(all);
    for (Struct& one : all) one.fields(*this);
  }
  template <class Struct>
  void columns(const char* name, std::vector<Struct>& all) {
    items(name, all);
  }
  void count(Among, std::size_t) {}

 private:
  template <class Value>
  void count(const std::vector<Value>& all) {
    rest.push_back(static_cast<std::int64_t>(all.size()));
  }
};

// Returns first + share * (second - first) for every number of the struct. Returns nullopt if the
// structs differ in anything else.
template <class Struct>
std::optional<Struct> between(Struct first, const Struct& second, double share) {
  std::optional<Struct> out(second);
  NumberPlaces from, to;
  first.fields(from);
  out->fields(to);
  if (from.rest != to.rest || from.number.size() != to.number.size()) return std::nullopt;
  for (std::size_t k = 0; k < to.number.size(); ++k) {
    const double a = *from.number[k];
    double& b = *to.number[k];
    if (a != b) b = a + share * (b - a);
  }
  return out;
}

}  // namespace codend
