// Exceptions of the engine as conditions of R.
#pragma once

#include <cpp11.hpp>
#include <new>
#include <stdexcept>
#include <string>

#include "engine/base/error.hpp"

namespace binding {

// What body() returns. An exception that it throws becomes a condition of class codend_error_engine
// with the field that is wrong (NA where there is none), by the R function abort_engine(). R's own jumps
// (errors of callbacks, interrupts) pass.
template <class Body>
auto guarded(Body body) -> decltype(body()) {
  std::string message, field;
  try {
    return body();
  } catch (const cpp11::unwind_exception&) {
    throw;
  } catch (const codend::InputError& error) {
    message = error.what();
    field = error.field();
  } catch (const std::bad_alloc&) {
    message = "there is not enough memory for a lattice of this size";
  } catch (const std::exception& error) {
    message = error.what();
  }
  cpp11::package("codend")["abort_engine"](message, field);
  throw std::logic_error(message);  // abort_engine() does not return
}

}  // namespace binding
