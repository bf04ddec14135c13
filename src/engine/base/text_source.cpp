#include "text_source.hpp"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <utility>

#include "error.hpp"

namespace codend {
namespace {

constexpr std::array<const char*, 5> types = {"number", "whole", "mark", "name", "list"};

class Words {
 public:
  explicit Words(const std::string& text) : text_(text) {}

  // Returns false at the end of the text.
  bool next(std::string& word) {
    while (place_ < text_.size() && (blank(text_[place_]) || text_[place_] == '#')) {
      if (text_[place_] == '#') {
        while (place_ < text_.size() && text_[place_] != '\n') ++place_;
      } else {
        if (text_[place_] == '\n') ++line_;
        ++place_;
      }
    }
    const std::size_t first = place_;
    while (place_ < text_.size() && !blank(text_[place_])) ++place_;
    word = text_.substr(first, place_ - first);
    return !word.empty();
  }

  [[noreturn]] void fail(const std::string& name, const std::string& what) const {
    throw InputError(name, "line " + std::to_string(line_) + ": " + what);
  }

 private:
  static bool blank(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; }
  const std::string& text_;
  std::size_t place_ = 0;
  long line_ = 1;
};

// Returns false if the token is not an integer in the range of int.
bool as_whole(const std::string& word, int& value) {
  char* end = nullptr;
  errno = 0;
  const long long read = std::strtoll(word.c_str(), &end, 10);
  if (end != word.c_str() + word.size() || errno != 0 || read > std::numeric_limits<int>::max() ||
      read < std::numeric_limits<int>::min()) {
    return false;
  }
  value = static_cast<int>(read);
  return true;
}

// strtod() requires the "C" locale for numbers. Programs start in it, and R preserves it.
bool as_number(const std::string& word, double& value) {
  char* end = nullptr;
  value = std::strtod(word.c_str(), &end);
  return end == word.c_str() + word.size();
}

// Returns true for letters, digits, _ and single dots between them.
bool is_name(const std::string& word) {
  bool dot = true;
  for (const char c : word) {
    if (c == '.' && dot) return false;
    dot = c == '.';
    const bool known = dot || c == '_' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                       (c >= '0' && c <= '9');
    if (!known) return false;
  }
  return !dot;
}

}  // namespace

TextSource::Arrays TextSource::parse(const std::string& text) {
  Arrays arrays;
  Words words(text);
  std::string name, word;
  while (words.next(name)) {
    if (!is_name(name)) words.fail("", "\"" + name + "\" must be the name of an array");
    const auto added = arrays.try_emplace(name);
    if (!added.second) words.fail(name, name + " is given twice");
    Array& array = added.first->second;
    std::size_t type = 0;
    if (!words.next(word)) words.fail(name, name + " has no type");
    while (type < types.size() && word != types[type]) ++type;
    if (type == types.size()) {
      words.fail(name, name + " has the type \"" + word +
                           "\", must have number, whole, mark, name or list");
    }
    array.type = static_cast<Type>(type);
    int count = 0;
    if (!words.next(word) || !as_whole(word, count) || count < 0) {
      words.fail(name, name + " needs its number of values, 0 or more");
    }
    if (array.type == Type::list) {
      array.groups = count;
      continue;
    }
    // No memory is reserved in advance: the count may be wrong.
    for (int k = 0; k < count; ++k) {
      const std::string where = name + "[" + std::to_string(k + first_place) + "]";
      if (!words.next(word)) {
        words.fail(name, name + " has " + std::to_string(k) + " values, must have " +
                             std::to_string(count));
      }
      double number = 0.0;
      int whole = 0;
      switch (array.type) {
        case Type::number:
          if (!as_number(word, number)) {
            words.fail(name, where + " is \"" + word + "\", must be a number");
          }
          array.numbers.push_back(number);
          break;
        case Type::whole:
        case Type::mark:
          if (!as_whole(word, whole)) {
            words.fail(name, where + " is \"" + word + "\", must be a whole number");
          }
          array.whole_numbers.push_back(whole);
          break;
        default:
          array.words.push_back(word);
      }
    }
  }
  return arrays;
}

TextSource::TextSource(const std::string& text)
    : arrays_(std::make_shared<const Arrays>(parse(text))) {}

TextSource::TextSource(std::shared_ptr<const Arrays> arrays, std::string prefix)
    : arrays_(std::move(arrays)), prefix_(std::move(prefix)) {}

std::vector<std::string> TextSource::names() const {
  std::vector<std::string> out;
  for (auto place = arrays_->lower_bound(prefix_); place != arrays_->end(); ++place) {
    const std::string& path = place->first;
    if (path.compare(0, prefix_.size(), prefix_) != 0) break;
    const std::string name =
        path.substr(prefix_.size(), path.find('.', prefix_.size()) - prefix_.size());
    // An array and the groups of its list may be separated by other arrays.
    bool known = false;
    for (const std::string& one : out) known = known || one == name;
    if (!known) out.push_back(name);
  }
  return out;
}

const TextSource::Array& TextSource::get(const std::string& name, const char* needed) const {
  const auto found = arrays_->find(prefix_ + name);
  if (found == arrays_->end()) throw std::invalid_argument(needed);
  return found->second;
}

bool TextSource::has_group(const std::string& name) const {
  const std::string inner = prefix_ + name + ".";
  const auto found = arrays_->lower_bound(inner);
  return found != arrays_->end() && found->first.compare(0, inner.size(), inner) == 0;
}

std::vector<double> TextSource::numbers(const std::string& name) const {
  constexpr const char* needed = "must be numbers";
  const Array& array = get(name, needed);
  if (array.type == Type::number) return array.numbers;
  if (array.type != Type::whole) throw std::invalid_argument(needed);
  return std::vector<double>(array.whole_numbers.begin(), array.whole_numbers.end());
}

std::vector<int> TextSource::whole_numbers(const std::string& name) const {
  constexpr const char* needed = "must be whole numbers";
  const Array& array = get(name, needed);
  if (array.type != Type::whole && array.type != Type::mark) throw std::invalid_argument(needed);
  return array.whole_numbers;
}

std::vector<std::string> TextSource::words(const std::string& name) const {
  constexpr const char* needed = "must be names";
  const Array& array = get(name, needed);
  if (array.type != Type::name) throw std::invalid_argument(needed);
  return array.words;
}

TextSource TextSource::group(const std::string& name) const {
  if (!has_group(name)) throw std::invalid_argument("must be a group of arrays");
  return TextSource(arrays_, prefix_ + name + ".");
}

std::vector<TextSource> TextSource::items(const std::string& name) const {
  constexpr const char* needed = "must be a list of groups";
  const Array& array = get(name, needed);
  if (array.type != Type::list) throw std::invalid_argument(needed);
  std::vector<TextSource> out;
  for (int k = 0; k < array.groups; ++k) {
    const std::string item = name + "." + std::to_string(k + first_place);
    if (!has_group(item)) {
      throw std::invalid_argument("has " + std::to_string(k) + " groups, must have " +
                                  std::to_string(array.groups));
    }
    out.push_back(TextSource(arrays_, prefix_ + item + "."));
  }
  return out;
}

}  // namespace codend
