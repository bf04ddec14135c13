// Converts numbers between R and the engine, which counts from 0.
#pragma once

#include <algorithm>
#include <cpp11.hpp>
#include <string>
#include <vector>

#include "engine/base/geometry.hpp"
#include "engine/motion/motion.hpp"

namespace binding {

using namespace cpp11;
namespace writable = cpp11::writable;

inline std::vector<double> numbers(const doubles& values) {
  const double* first = REAL(values);
  return std::vector<double>(first, first + values.size());
}

inline std::vector<double> numbers(const list& from, const char* name) {
  return numbers(doubles(from[name]));
}

inline std::vector<int> whole_numbers(const integers& values) {
  const int* first = INTEGER(values);
  return std::vector<int>(first, first + values.size());
}

inline std::vector<int> whole_numbers(const list& from, const char* name) {
  return whole_numbers(integers(from[name]));
}

// R counts from 1. NA becomes -1, which means none.
inline int place_of(int value) { return value == NA_INTEGER ? -1 : value - 1; }
inline std::vector<int> places(const integers& values) {
  std::vector<int> out = whole_numbers(values);
  for (int& place : out) place = place_of(place);
  return out;
}

inline std::vector<int> places(const list& from, const char* name) {
  return places(integers(from[name]));
}

inline std::vector<char> marks(const logicals& values) {
  std::vector<char> out(values.size());
  const int* from = LOGICAL(values);
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = from[k] == TRUE ? 1 : 0;
  return out;
}

inline doubles as_doubles(const std::vector<double>& values) {
  writable::doubles out(static_cast<R_xlen_t>(values.size()));
  std::copy(values.begin(), values.end(), REAL(out));
  return out;
}

inline double number(const list& from, const char* name) { return as_cpp<double>(from[name]); }
inline int place(const list& from, const char* name) { return place_of(as_cpp<int>(from[name])); }

inline codend::Vector vector_of(const list& from, const char* name) {
  const doubles values(from[name]);
  return {values[0], values[1], values[2]};
}

inline doubles as_doubles(const codend::Values& values) {
  return writable::doubles(values.data(), values.data() + values.size());
}

}  // namespace binding
