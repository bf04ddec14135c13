// Writes structs of the engine as R lists by their fields (base/fields.hpp). Indices count from 1;
// 0 means none.
#pragma once

#include <cpp11.hpp>
#include <string>
#include <type_traits>
#include <vector>

#include "binding_numbers.h"
#include "engine/base/fields.hpp"
#include "engine/base/geometry.hpp"
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
  template <class Enumeration, std::enable_if_t<std::is_enum_v<Enumeration>, int> = 0>
  void operator()(const char* name, Enumeration& value, codend::Shape = {}) {
    std::vector<Enumeration> one{value};
    (*this)(name, one);
  }
  void operator()(const char* name, codend::Vector& value, codend::Shape = {}) {
    std::vector<double> three(value.data(), value.data() + 3);
    (*this)(name, three);
  }
  template <std::size_t n>
  void operator()(const char* name, std::array<codend::Vector, n>& values, codend::Shape = {}) {
    std::vector<double> all;
    for (const codend::Vector& one : values) all.insert(all.end(), one.data(), one.data() + 3);
    (*this)(name, all);
  }
  void component(const char* name, std::vector<codend::Vector>& vectors, int which) {
    std::vector<double> values;
    for (const codend::Vector& one : vectors) values.push_back(one[which]);
    (*this)(name, values);
  }
  template <class Struct>
  void columns(const char* name, std::vector<Struct>& of) {
    ListWriter inner;
    Columns<Struct> columns{inner, of};
    Struct none;
    none.fields(columns);
    add(name, inner.all());
  }
  template <class Struct>
  void group(const char* name, Struct& of) {
    add(name, written(of));
  }
  template <class Struct>
  void optional(const char* name, Struct& of, bool given) {
    if (given) group(name, of);
  }
  template <class Struct>
  void optional(const char* name, Struct& of) {
    optional(name, of, of.present());
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

  // Returns all visited values by name.
  cpp11::list all() const {
    writable::list out(static_cast<R_xlen_t>(values_.size()));
    writable::strings names(static_cast<R_xlen_t>(values_.size()));
    for (std::size_t k = 0; k < values_.size(); ++k) {
      SET_VECTOR_ELT(out, static_cast<R_xlen_t>(k), values_[k]);
      SET_STRING_ELT(names, static_cast<R_xlen_t>(k), Rf_mkChar(names_[k].c_str()));
    }
    out.attr("names") = names;
    return out;
  }
  template <class Struct>
  static cpp11::list written(Struct& of) {
    ListWriter writer;
    of.fields(writer);
    return writer.all();
  }

 private:
  // Writes one array per field of a struct: visits the fields of one struct, and collects each
  // field from all.
  template <class Struct>
  struct Columns {
    ListWriter& to;
    std::vector<Struct>& of;
    std::size_t fields = 0;

    template <class Value>
    struct Pick {
      std::size_t wanted, seen = 0;
      Value found = {};
      template <class Other>
      void operator()(const char*, Other& value, codend::Shape = {}) {
        if constexpr (std::is_same_v<Value, Other>) {
          if (seen == wanted) found = value;
        }
        ++seen;
      }
    };
    template <class Value>
    void operator()(const char* name, Value&, codend::Shape shape = {}) {
      std::vector<std::conditional_t<std::is_same_v<Value, bool>, char, Value>> values;
      for (Struct& one : of) {
        Pick<Value> pick{fields};
        one.fields(pick);
        values.push_back(pick.found);
      }
      to(name, values, shape);
      ++fields;
    }
  };

  void add(const char* name, cpp11::sexp value) {
    names_.emplace_back(name);
    values_.push_back(value);
  }
  std::vector<std::string> names_;
  std::vector<cpp11::sexp> values_;
};

}  // namespace binding
