// Reads fields of the engine (base/read_fields.hpp) from an R list of arrays and lists; handles to
// models.
#pragma once

#include <cpp11.hpp>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include "binding_errors.h"
#include "binding_numbers.h"
#include "engine/base/read_fields.hpp"
#include "engine/measure/frame.hpp"
#include "engine/measure/measured_gear.hpp"

namespace binding {

class ListSource {
 public:
  static constexpr int first_place = 1;

  // The caller must protect the list.
  explicit ListSource(SEXP list) : list_(list) {
    if (TYPEOF(list) != VECSXP) throw std::invalid_argument("must be a list");
  }

  // NULL elements count as missing.
  std::vector<std::string> names() const {
    std::vector<std::string> out;
    const SEXP names = Rf_getAttrib(list_, R_NamesSymbol);
    for (R_xlen_t k = 0; k < Rf_xlength(names); ++k) {
      if (!Rf_isNull(VECTOR_ELT(list_, k))) out.emplace_back(CHAR(STRING_ELT(names, k)));
    }
    return out;
  }

  std::vector<double> numbers(const char* name) const {
    const SEXP x = get(name);
    const R_xlen_t n = Rf_xlength(x);
    if (TYPEOF(x) == REALSXP) return std::vector<double>(REAL(x), REAL(x) + n);
    std::vector<double> out(static_cast<std::size_t>(n));
    if (TYPEOF(x) != INTSXP) throw std::invalid_argument("must be numbers");
    for (R_xlen_t k = 0; k < n; ++k) {
      out[static_cast<std::size_t>(k)] = INTEGER(x)[k] == NA_INTEGER ? NA_REAL : INTEGER(x)[k];
    }
    return out;
  }

  std::vector<int> whole_numbers(const char* name) const {
    const SEXP x = get(name);
    const R_xlen_t n = Rf_xlength(x);
    if (TYPEOF(x) == INTSXP) return std::vector<int>(INTEGER(x), INTEGER(x) + n);
    if (TYPEOF(x) == LGLSXP) return std::vector<int>(LOGICAL(x), LOGICAL(x) + n);
    throw std::invalid_argument("must be whole numbers");
  }

  std::vector<std::string> words(const char* name) const {
    const SEXP x = get(name);
    if (TYPEOF(x) != STRSXP) throw std::invalid_argument("must be names");
    std::vector<std::string> out;
    for (R_xlen_t k = 0; k < Rf_xlength(x); ++k) out.emplace_back(CHAR(STRING_ELT(x, k)));
    return out;
  }

  ListSource group(const char* name) const { return ListSource(get(name)); }

  std::vector<ListSource> items(const char* name) const {
    const SEXP x = get(name);
    if (TYPEOF(x) != VECSXP) throw std::invalid_argument("must be a list of lists");
    std::vector<ListSource> out;
    for (R_xlen_t k = 0; k < Rf_xlength(x); ++k) out.emplace_back(VECTOR_ELT(x, k));
    return out;
  }

 private:
  SEXP get(const char* name) const {
    const SEXP names = Rf_getAttrib(list_, R_NamesSymbol);
    for (R_xlen_t k = 0; k < Rf_xlength(names); ++k) {
      if (std::strcmp(CHAR(STRING_ELT(names, k)), name) == 0) return VECTOR_ELT(list_, k);
    }
    return R_NilValue;
  }

  SEXP list_;
};

// Data of a gear that the engine stores for R: the unprepared model of its mesh, data for measures,
// and the bag around its catch.
struct HeldModel {
  codend::Model model;
  codend::MeasureFrame frame;
  codend::FilledBag bag;

  const codend::FilledBag* catch_bag() const { return bag.points > 0 ? &bag : nullptr; }
};
cpp11::sexp model_handle(HeldModel&& model);

// Returns the fields of a discretisation and `model`, a handle to its unprepared model, as an R
// list.
cpp11::list mesh_list(codend::MeasuredGear&& gear, codend::MeasureFrame&& frame);

// Returns the data of a handle. Throws InputError if it is empty, as in another process.
HeldModel& held_model(SEXP handle);

// Returns a copy of the model of a handle, prepared for use.
codend::Model read_model(SEXP handle);

// Converts values of all nodes (3 each); throws InputError for a wrong number. name: for the
// message.
inline std::vector<double> of_nodes(const cpp11::doubles& values, const codend::Model& model,
                                    const char* name) {
  const std::size_t wanted = 3 * static_cast<std::size_t>(model.nodes);
  if (static_cast<std::size_t>(values.size()) != wanted) {
    throw codend::InputError(name, std::string(name) + " has " + std::to_string(values.size()) +
                                       " values, must have " + std::to_string(wanted) +
                                       " (3 per node)");
  }
  return std::vector<double>(REAL(values), REAL(values) + values.size());
}

}  // namespace binding
