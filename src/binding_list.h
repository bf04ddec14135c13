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
  ListWriter() : fields_(Rf_cons(R_NilValue, R_NilValue)), last_(fields_) {}

  void operator()(const char* name, std::vector<double>& values, codend::Shape = {}) {
    const SEXP out = allocated(REALSXP, values);
    std::copy(values.begin(), values.end(), REAL(out));
    add(name, out);
  }
  void operator()(const char* name, std::vector<int>& values, codend::Shape shape = {}) {
    const SEXP out = allocated(INTSXP, values);
    int* to = INTEGER(out);
    const int first = shape.among == codend::Among::numbers ? 0 : 1;
    for (std::size_t k = 0; k < values.size(); ++k) to[k] = values[k] + first;
    add(name, out);
  }
  void operator()(const char* name, std::vector<char>& values, codend::Shape = {}) {
    const SEXP out = allocated(LGLSXP, values);
    std::copy(values.begin(), values.end(), LOGICAL(out));
    add(name, out);
  }
  template <class Enumeration, std::enable_if_t<std::is_enum_v<Enumeration>, int> = 0>
  void operator()(const char* name, std::vector<Enumeration>& values, codend::Shape = {}) {
    const cpp11::sexp out(allocated(STRSXP, values));
    const auto names = names_of(Enumeration{});
    for (std::size_t k = 0; k < values.size(); ++k) {
      SET_STRING_ELT(out, static_cast<R_xlen_t>(k),
                     Rf_mkChar(names[static_cast<std::size_t>(values[k])]));
    }
    add(name, out);
  }
  void operator()(const char* name, double& value, codend::Shape = {}) {
    add(name, Rf_ScalarReal(value));
  }
  void operator()(const char* name, bool& value, codend::Shape = {}) {
    add(name, Rf_ScalarLogical(value));
  }
  void operator()(const char* name, int& value, codend::Shape shape = {}) {
    add(name, Rf_ScalarInteger(value + (shape.among == codend::Among::numbers ? 0 : 1)));
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
    const cpp11::sexp out(allocated(VECSXP, of));
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
    const R_xlen_t size = Rf_length(writer.fields_) - 1;
    const cpp11::sexp out(Rf_allocVector(VECSXP, size));
    const SEXP names = Rf_allocVector(STRSXP, size);
    SEXP field = CDR(writer.fields_);
    for (R_xlen_t k = 0; k < size; ++k, field = CDR(field)) {
      SET_VECTOR_ELT(out, k, CAR(field));
      SET_STRING_ELT(names, k, PRINTNAME(TAG(field)));
    }
    Rf_setAttrib(out, R_NamesSymbol, names);
    return cpp11::list(out);
  }

 private:
  template <class Value>
  static SEXP allocated(SEXPTYPE type, const std::vector<Value>& values) {
    return Rf_allocVector(type, static_cast<R_xlen_t>(values.size()));
  }
  // value: Rf_cons() protects it, then the fields do.
  void add(const char* name, SEXP value) {
    SETCDR(last_, Rf_cons(value, R_NilValue));
    last_ = CDR(last_);
    SET_TAG(last_, Rf_install(name));
  }
  // A pairlist behind a first cell: to protect each value by itself takes longer than to copy it.
  const cpp11::sexp fields_;
  SEXP last_;
};

}  // namespace binding
