// Named arrays in plain text as a source of fields (read_fields.hpp). A text contains any number of
//
//   name type count value value ...
//
// separated by blanks or line ends. A comment starts with # and ends with its line. Names are paths
// with dots, such as model.bars.rest. Types:
//
//   number   a decimal number
//   whole    an integer; indices count from 1
//   mark     0 or 1
//   name     a string without blanks
//   list     groups, without values; the arrays of the k-th group are named name.k, from 1
//
// Example:
//
//   model.nodes whole 1  2
//   model.bars.node whole 2  1 2
//   model.bars.rest number 1  0.75
//   model.plates list 0
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace codend {

class TextSource {
 public:
  static constexpr int first_place = 1;

  // Throws InputError with the line number if the text is malformed or a name occurs twice.
  explicit TextSource(const std::string& text);

  // Interface for read_fields().
  std::vector<std::string> names() const;
  std::vector<double> numbers(const std::string& name) const;
  std::vector<int> whole_numbers(const std::string& name) const;
  std::vector<std::string> words(const std::string& name) const;
  TextSource group(const std::string& name) const;
  std::vector<TextSource> items(const std::string& name) const;

 private:
  enum class Type { number, whole, mark, name, list };
  struct Array {
    Type type = Type::number;
    std::vector<double> numbers;
    std::vector<int> whole_numbers;
    std::vector<std::string> words;
    int groups = 0;
  };
  using Arrays = std::map<std::string, Array>;

  TextSource(std::shared_ptr<const Arrays> arrays, std::string prefix);
  static Arrays parse(const std::string& text);
  const Array& get(const std::string& name, const char* needed) const;
  bool has_group(const std::string& name) const;

  std::shared_ptr<const Arrays> arrays_;
  std::string prefix_;  // prefix of all names in this group, with its last dot
};

}  // namespace codend
