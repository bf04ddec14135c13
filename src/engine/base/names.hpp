// Enumerations by name. An enumeration with values from 0 defines next to it
//
//   constexpr std::array<const char*, n> names_of(Enumeration)
//
// with the names in the order of the values.
#pragma once

#include <array>
#include <string>

#include "error.hpp"

namespace codend {

// Returns the value with this name. Throws InputError with the allowed names for an unknown name.
// field: the field in the message.
template <class Enumeration>
Enumeration by_name(const std::string& word, const std::string& field) {
  const auto names = names_of(Enumeration{});
  std::string allowed;
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (word == names[k]) return static_cast<Enumeration>(k);
    if (k > 0) allowed += k + 1 < names.size() ? ", " : " or ";
    allowed += names[k];
  }
  throw InputError(field, field + " is \"" + word + "\", must be " + allowed);
}

template <class Enumeration>
std::string name_of(Enumeration value) {
  return names_of(value)[static_cast<std::size_t>(value)];
}

}  // namespace codend
