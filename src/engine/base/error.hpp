// What the engine says when a model, or what it is asked, makes no sense.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace codend {

class InputError : public std::invalid_argument {
 public:
  // field: what is wrong, such as "bars.rest"; message: a sentence that names it, says what it is and
  // what is allowed.
  InputError(std::string field, const std::string& message)
      : std::invalid_argument(message), field_(std::move(field)) {}
  const std::string& field() const { return field_; }

 private:
  std::string field_;
};

}  // namespace codend
