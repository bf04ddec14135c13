// Structs of the engine as R lists, by their fields (base/fields.hpp): places count from 1, 0 is none.
#pragma once

#include <cpp11.hpp>
#include <string>
#include <type_traits>
#include <vector>

#include "binding_numbers.h"
#include "engine/base/fields.hpp"
#include "engine/base/names.hpp"

namespace binding {

class ListWriter {
 public:
  void operator()(const char* name, std::vector<double>& values, codend::Shape = {}) {
    add(name, as_doubles(values));
  }
  void operator()(const char* name, std::vector<int>& values, codend::Shape shape = {}) {
    writable::integers out(static_cast<R_xlen_t>(values.size()));
    int* to = INTEGER(out);
    const int first = shape.among == codend::Among::numbers ? 0 : 1;
    for (std::size_t k = 0; k < values.size(); ++k) to[k] = values[k] + first;
    add(name, out);
  }
  void operator()(const char* name, std::vector<char>& values, codend::Shape = {}) {
    writable::logicals out(static_cast<R_xlen_t>(values.size()));
    int* to = LOGICAL(out);
    for (std::size_t k = 0; k < values.size(); ++k) to[k] = values[k];
    add(name, out);
  }
  template <class Enumeration, std::enable_if_t<std::is_enum_v<Enumeration>, int> = 0>
  void operator()(const char* name, std::vector<Enumeration>& values, codend::Shape = {}) {
    writable::strings out(static_cast<R_xlen_t>(values.size()));
    const auto names = names_of(Enumeration{});
    for (std::size_t k = 0; k < values.size(); ++k) {
      SET_STRING_ELT(out, static_cast<R_xlen_t>(k),
                     Rf_mkChar(names[static_cast<std::size_t>(values[k])]));
    }
    add(name, out);
  }
  void operator()(const char* name, double& value, codend::Shape = {}) {
    add(name, as_sexp(value));
  }
  void operator()(const char* name, bool& value, codend::Shape = {}) { add(name, as_sexp(value)); }
  void operator()(const char* name, int& value, codend::Shape shape = {}) {
    add(name, as_sexp(value + (shape.among == codend::Among::numbers ? 0 : 1)));
  }
  template <class Value, std::size_t n>
  void operator()(const char* name, std::array<Value, n>& values, codend::Shape shape = {}) {
    std::vector<Value> all(values.begin(), values.end());
    (*this)(name, all, shape);
  }
  template <class Value>
  void list(const char* name, std::vector<Value>& values, codend::Shape shape = {}) {
    (*this)(name, values, shape);
  }
  template <class Struct>
  void group(const char* name, Struct& of) {
    add(name, written(of));
  }
  template <class Struct>
  void items(const char* name, std::vector<Struct>& of) {
    writable::list out(static_cast<R_xlen_t>(of.size()));
    for (std::size_t k = 0; k < of.size(); ++k) {
      SET_VECTOR_ELT(out, static_cast<R_xlen_t>(k), written(of[k]));
    }
    add(name, out);
  }
  void count(codend::Among, std::size_t) {}

  // All that has been visited, by name.
  template <class Struct>
  static cpp11::list written(Struct& of) {
    ListWriter writer;
    of.fields(writer);
    writable::list out(static_cast<R_xlen_t>(writer.values_.size()));
    writable::strings names(static_cast<R_xlen_t>(writer.values_.size()));
    for (std::size_t k = 0; k < writer.values_.size(); ++k) {
      SET_VECTOR_ELT(out, static_cast<R_xlen_t>(k), writer.values_[k]);
      SET_STRING_ELT(names, static_cast<R_xlen_t>(k), Rf_mkChar(writer.names_[k].c_str()));
    }
    out.attr("names") = names;
    return out;
  }

 private:
  void add(const char* name, cpp11::sexp value) {
    names_.emplace_back(name);
    values_.push_back(value);
  }
  std::vector<std::string> names_;
  std::vector<cpp11::sexp> values_;
};

}  // namespace binding
