// Converts exceptions of the engine to R conditions.
#pragma once

#include <cpp11.hpp>
#include <new>
#include <stdexcept>
#include <string>

#include "engine/base/error.hpp"

namespace binding {

// Returns the result of body(). An exception becomes a condition of class codend_error_engine by
// the R function abort_engine(), with the name of the wrong field (NA if none). R's own jumps
// (errors of callbacks, interrupts) pass through.
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
    message = "there is not enough memory for a mesh of this size";
  } catch (const std::exception& error) {
    message = error.what();
  }
  cpp11::package("codend")["abort_engine"](message, field);
  throw std::logic_error(message);  // abort_engine() does not return
}

}  // namespace binding
