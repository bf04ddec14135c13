// Arrays by name in a plain text, as a source of fields (read_fields.hpp). A text holds any number of
//
//   name type count value value ...
//
// parted by blanks or ends of lines; # begins a comment to the end of its line. Names are paths with
// dots, such as model.bars.rest. Types are
//   number   a decimal number
//   whole    a whole number; places count from 1
//   mark     0 or 1
//   name     a word without blanks
//   list     of groups: no values; the arrays of the k-th group stand under name.k, from 1
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

  // Throws InputError with the line where the text is not of this form, or a name stands twice.
  explicit TextSource(const std::string& text);

  // What read_fields() asks of a source.
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
  std::string prefix_;  // of the names in this group, with its last dot
};

}  // namespace codend
