// R interface: a handle to an R object of this process. A copy that R saves and reloads is empty,
// in this or another process.
#include <cpp11.hpp>
#include <memory>

namespace {

// Releases the object of a handle, at most once.
void release(SEXP handle) {
  delete static_cast<cpp11::sexp*>(R_ExternalPtrAddr(handle));
  R_ClearExternalPtr(handle);
}

}  // namespace

// Returns an empty handle.
[[cpp11::register]] SEXP engine_handle() {
  return R_MakeExternalPtr(nullptr, R_NilValue, R_NilValue);
}

// Returns the object of a handle, or NULL.
[[cpp11::register]] SEXP engine_handle_value(SEXP handle) {
  const auto* held = static_cast<cpp11::sexp*>(R_ExternalPtrAddr(handle));
  return held ? static_cast<SEXP>(*held) : R_NilValue;
}

// Stores a value in an empty handle. A value that refers to the handle would never be released.
[[cpp11::register]] void engine_fill_handle(SEXP handle, SEXP value) {
  auto held = std::make_unique<cpp11::sexp>(value);
  R_RegisterCFinalizer(handle, release);
  R_SetExternalPtrAddr(handle, held.release());
}
