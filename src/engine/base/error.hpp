// Error for invalid input to the engine.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace codend {

class InputError : public std::invalid_argument {
 public:
  // field: path of the invalid field, such as "bars.rest". message: a sentence with the field, its
  // value and the allowed values.
  InputError(std::string field, const std::string& message)
      : std::invalid_argument(message), field_(std::move(field)) {}
  const std::string& field() const { return field_; }

 private:
  std::string field_;
};

}  // namespace codend
