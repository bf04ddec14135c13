// Reads structs by their fields (fields.hpp) from a source of named arrays. Each array is checked:
// its length, finite numbers, valid indices and known names. Errors throw InputError with the path
// of the field, such as "bars.rest".
//
// A Source is a named group of arrays:
//
//   static constexpr int first_place           value of the first index: 0 or 1
//   std::vector<std::string> names() const     all names in the group
//   std::vector<double> numbers(name) const
//   std::vector<int> whole_numbers(name) const
//   std::vector<std::string> words(name) const
//   Source group(name) const                   an inner group
//   std::vector<Source> items(name) const      an inner list of groups
//
// All except names() throw std::invalid_argument if the type differs. Its message is the
// requirement, such as "must be numbers".
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

#include "fields.hpp"
#include "geometry.hpp"
#include "names.hpp"

namespace codend {

template <class Source>
class FieldReader {
 public:
  using Counts = std::array<int, names_of(Among{}).size()>;

  // path: of the group; "" for the outermost group.
  FieldReader(const Source& from, const std::string& path, Counts& counts)
      : from_(from), path_(path), names_(from.names()), counts_(counts) {}

  void operator()(const char* name, std::vector<double>& to, Shape shape = {}) {
    to = take(name, shape, [&] { return from_.numbers(name); });
    for (std::size_t k = 0; k < to.size(); ++k) {
      if (!std::isfinite(to[k])) fail(name, element(k) + " must be a finite number");
    }
  }

  void operator()(const char* name, std::vector<int>& to, Shape shape = {}) {
    to = take(name, shape, [&] { return from_.whole_numbers(name); });
    if (shape.among == Among::numbers) return;
    const int count = counts_[static_cast<std::size_t>(shape.among)];
    for (std::size_t k = 0; k < to.size(); ++k) {
      const std::int64_t place = std::int64_t{to[k]} - Source::first_place;
      const bool none = shape.or_none && place == -1;
      if (!none && (place < 0 || place >= count)) {
        fail(name, element(k) + " is " + std::to_string(to[k]) + ", must be from " +
                       std::to_string(Source::first_place) + " to " +
                       std::to_string(std::int64_t{count} - 1 + Source::first_place) + " (" +
                       name_of(shape.among) + ")");
      }
      to[k] = static_cast<int>(place);
    }
  }

  // Flags: 1 or 0 each.
  void operator()(const char* name, std::vector<char>& to, Shape shape = {}) {
    const std::vector<int> values = take(name, shape, [&] { return from_.whole_numbers(name); });
    to.assign(values.size(), 0);
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (values[k] != 0 && values[k] != 1) fail(name, element(k) + " must be true or false");
      to[k] = static_cast<char>(values[k]);
    }
  }

  template <class Enumeration, std::enable_if_t<std::is_enum_v<Enumeration>, int> = 0>
  void operator()(const char* name, std::vector<Enumeration>& to, Shape shape = {}) {
    to.clear();
    for (const std::string& word : take(name, shape, [&] { return from_.words(name); })) {
      to.push_back(by_name<Enumeration>(word, path(name)));
    }
  }

  void operator()(const char* name, double& to) { to = one<double>(name, {}); }
  void operator()(const char* name, bool& to) { to = one<char>(name, {}) != 0; }
  void operator()(const char* name, int& to, Shape shape = {}) { to = one<int>(name, shape); }
  template <class Enumeration, std::enable_if_t<std::is_enum_v<Enumeration>, int> = 0>
  void operator()(const char* name, Enumeration& to, Shape = {}) {
    to = one<Enumeration>(name, {});
  }
  void operator()(const char* name, Vector& to) {
    const std::vector<double> values = some<double>(name, 3, {});
    to = {values[0], values[1], values[2]};
  }
  template <std::size_t n>
  void operator()(const char* name, std::array<int, n>& to, Shape shape) {
    const std::vector<int> values = some<int>(name, n, shape);
    std::copy(values.begin(), values.end(), to.begin());
  }
  template <std::size_t n>
  void operator()(const char* name, std::array<double, n>& to) {
    const std::vector<double> values = some<double>(name, n, {});
    std::copy(values.begin(), values.end(), to.begin());
  }
  template <std::size_t n>
  void operator()(const char* name, std::array<Vector, n>& to) {
    const std::vector<double> values = some<double>(name, 3 * n, {});
    for (std::size_t k = 0; k < n; ++k) to[k] = at(values.data(), static_cast<int>(k));
  }

  template <class Struct>
  void group(const char* name, Struct& to) {
    known(name);
    read(typed(name, [&] { return from_.group(name); }), path(name), to);
  }

  template <class Struct>
  void optional(const char* name, Struct& to, bool& given) {
    given = std::find(names_.begin(), names_.end(), name) != names_.end();
    if (given) {
      group(name, to);
    } else {
      to = {};
    }
  }
  template <class Struct>
  void optional(const char* name, Struct& to) {
    bool given;
    optional(name, to, given);
  }

  template <class Value>
  void list(const char* name, std::vector<Value>& to, Shape shape = {}) {
    const std::int64_t outer = count_;
    count_ = -1;
    (*this)(name, to, shape);
    count_ = outer;
  }

  void component(const char* name, std::vector<Vector>& to, int which) {
    std::vector<double> values;
    (*this)(name, values);
    to.resize(values.size(), Vector::Zero());
    for (std::size_t k = 0; k < values.size(); ++k) to[k][which] = values[k];
  }

  template <class Struct>
  void items(const char* name, std::vector<Struct>& to) {
    known(name);
    to.clear();
    for (const Source& from : typed(name, [&] { return from_.items(name); })) {
      const std::string here =
          path(name) + "[" + std::to_string(to.size() + Source::first_place) + "]";
      to.emplace_back();
      read(from, here, to.back());
    }
  }

  template <class Struct>
  void columns(const char* name, std::vector<Struct>& to) {
    known(name);
    const Source inner = typed(name, [&] { return from_.group(name); });
    FieldReader reader(inner, path(name), counts_);
    Columns held{reader};
    Struct one;
    one.fields(held);
    reader.finish();
    to.assign(static_cast<std::size_t>(std::max<std::int64_t>(reader.count_, 0)), one);
    held.loading = false;
    for (held.row = 0; held.row < to.size(); ++held.row) {
      held.next = 0;
      to[held.row].fields(held);
    }
  }

  void count(Among among, std::size_t n) {
    counts_[static_cast<std::size_t>(among)] = static_cast<int>(n);
  }

  // Throws InputError for a name in the source that is not a field.
  void finish() const {
    for (const std::string& name : names_) {
      if (std::find(asked_.begin(), asked_.end(), name) == asked_.end()) {
        throw InputError(path(name), path(name) + " is not a field of the model");
      }
    }
  }

 private:
  // Reads a list of structs that is stored as one array per field. The first pass loads the arrays,
  // later passes distribute them by row.
  struct Columns {
    FieldReader& reader;
    bool loading = true;
    std::size_t row = 0, next = 0;
    std::vector<std::vector<double>> columns = {};

    template <class Value>
    void operator()(const char* name, Value& to, Shape shape = {}) {
      if (loading) {
        using Held = std::conditional_t<std::is_same_v<Value, bool>, char, Value>;
        std::vector<Held> values;
        reader(name, values, shape);
        columns.emplace_back();
        for (const Held value : values) columns.back().push_back(static_cast<double>(value));
      } else {
        to = static_cast<Value>(columns[next++][row]);
      }
    }
  };

  template <class Struct>
  void read(const Source& from, const std::string& path, Struct& to) {
    FieldReader reader(from, path, counts_);
    to.fields(reader);
    reader.finish();
  }

  std::string path(const std::string& name) const {
    return path_.empty() ? name : path_ + "." + name;
  }
  static std::string element(std::size_t k) {
    return "[" + std::to_string(k + Source::first_place) + "]";
  }
  [[noreturn]] void fail(const char* name, const std::string& what) const {
    throw InputError(path(name), path(name) + what);
  }

  void known(const char* name) {
    asked_.emplace_back(name);
    if (std::find(names_.begin(), names_.end(), name) == names_.end()) fail(name, " is missing");
  }

  template <class Get>
  auto typed(const char* name, Get get) const {
    try {
      return get();
    } catch (const InputError&) {
      throw;
    } catch (const std::invalid_argument& wrong) {
      fail(name, std::string(" ") + wrong.what());
    }
  }

  // Reads an array and checks its length. The first array of a group sets the number of elements.
  template <class Get>
  auto take(const char* name, Shape shape, Get get) {
    known(name);
    auto values = typed(name, get);
    if (shape.or_none && shape.per != Per::element && values.empty()) return values;
    const std::int64_t size = static_cast<std::int64_t>(values.size());
    std::int64_t wanted = count_;
    if (shape.per != Per::element) {
      wanted =
          counts_[static_cast<std::size_t>(shape.per == Per::node ? Among::nodes : Among::points)];
    } else if (count_ < 0) {
      if (size % shape.width != 0) {
        fail(name, " has " + std::to_string(size) + " values, must have " +
                       std::to_string(shape.width) + " per element");
      }
      wanted = count_ = size / shape.width;
    }
    if (size != wanted * shape.width) {
      fail(name, " has " + std::to_string(size) + " values, must have " +
                     std::to_string(wanted * shape.width) + " (" + std::to_string(shape.width) +
                     " per " + name_of(shape.per) + ")");
    }
    return values;
  }

  template <class Value>
  std::vector<Value> some(const char* name, std::size_t n, Shape shape) {
    // The length of this array is independent of the number of elements in the group.
    const std::int64_t outer = count_;
    shape.width = static_cast<int>(n);
    count_ = 1;
    std::vector<Value> values;
    (*this)(name, values, shape);
    count_ = outer;
    return values;
  }
  template <class Value>
  Value one(const char* name, Shape shape) {
    return some<Value>(name, 1, shape)[0];
  }

  const Source& from_;
  const std::string path_;
  const std::vector<std::string> names_;
  std::vector<std::string> asked_;
  Counts& counts_;
  std::int64_t count_ = -1;  // number of elements; -1: not yet known
};

// Reads a struct from a source. Throws InputError.
template <class Struct, class Source>
Struct read_fields(const Source& from) {
  typename FieldReader<Source>::Counts counts{};
  FieldReader<Source> reader(from, "", counts);
  Struct out;
  out.fields(reader);
  reader.finish();
  return out;
}

}  // namespace codend
