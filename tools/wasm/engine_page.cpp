// The engine for a page (inst/share/worker.js): named arrays in, a settled shape, what acts on it and its
// measures out, by plain C calls. One gear at a time; a page has one engine in one worker.
//
// Arrays are those of `model`, of `frame` and `questions` (measure/measures.hpp) and, of a gear with a
// filled bag, of `bag` (measure/filled_bag.hpp).
#include <algorithm>
#include <cstring>
#include <exception>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "codend.hpp"

namespace {

enum class Type { numbers, wholes, words, groups };

struct Array {
  Type type = Type::numbers;
  std::vector<double> numbers;
  std::vector<int> wholes;
  std::vector<std::string> words;
  int groups = 0;
};

// By path, such as model.bars.rest; the k-th group of a list stands under its name and .k, from 1.
std::map<std::string, Array> arrays;

// The arrays as a source of fields (base/read_fields.hpp).
class PageSource {
 public:
  static constexpr int first_place = 1;
  explicit PageSource(std::string prefix) : prefix_(std::move(prefix)) {}

  std::vector<std::string> names() const {
    std::vector<std::string> out;
    for (auto at = arrays.lower_bound(prefix_); at != arrays.end(); ++at) {
      if (at->first.compare(0, prefix_.size(), prefix_) != 0) break;
      const std::string rest = at->first.substr(prefix_.size());
      const std::string name = rest.substr(0, rest.find('.'));
      if (out.empty() || out.back() != name) out.push_back(name);
    }
    return out;
  }
  std::vector<double> numbers(const std::string& name) const {
    const Array& array = get(name);
    if (array.type == Type::wholes) return {array.wholes.begin(), array.wholes.end()};
    return of_type(array, Type::numbers, "must be numbers").numbers;
  }
  std::vector<int> whole_numbers(const std::string& name) const {
    return of_type(get(name), Type::wholes, "must be whole numbers").wholes;
  }
  std::vector<std::string> words(const std::string& name) const {
    return of_type(get(name), Type::words, "must be names").words;
  }
  PageSource group(const std::string& name) const { return PageSource(prefix_ + name + "."); }
  std::vector<PageSource> items(const std::string& name) const {
    const Array& array = of_type(get(name), Type::groups, "must be a list");
    std::vector<PageSource> out;
    for (int k = 1; k <= array.groups; ++k) out.push_back(group(name + "." + std::to_string(k)));
    return out;
  }

 private:
  const Array& get(const std::string& name) const {
    const auto at = arrays.find(prefix_ + name);
    if (at == arrays.end()) throw std::invalid_argument("is missing");
    return at->second;
  }
  static const Array& of_type(const Array& array, Type type, const char* needed) {
    if (array.type != type) throw std::invalid_argument(needed);
    return array;
  }

  std::string prefix_;
};

std::optional<codend::Model> model;
std::unique_ptr<codend::Assembly> assembly;
codend::SettleReport report;
codend::Evaluation evaluation;
codend::MeasureFrame frame;
codend::Questions questions;
std::optional<codend::FilledBag> bag;
double front = 0.0;  // meshes that the bag is filled up to; 0: as it is given
std::vector<double> position, strain, plates;
// As found() names them.
std::vector<double> points, measures, drag, opening, angle, flow, weights;
std::string error;

template <class Work>
int guarded(Work work) {
  try {
    error.clear();
    return work();
  } catch (const std::exception& wrong) {
    error = wrong.what();
    return -1;
  }
}

Array& fresh(const char* name, Type type) {
  Array& array = arrays[name];
  array = Array{};
  array.type = type;
  return array;
}

// What a page may read, by its name; nullptr where there is no such thing.
const std::vector<double>* found(const std::string& name) {
  static std::vector<double> wake;
  if (name == "position") return &position;
  if (name == "strain") return &strain;
  if (name == "points") return &points;
  if (name == "measures") return &measures;
  if (name == "drag") return &drag;
  if (name == "opening") return &opening;
  if (name == "angle") return &angle;
  if (name == "flow") return &flow;
  if (name == "plates") return &plates;
  if (name == "wake") {
    wake = assembly && assembly->has_wake() ? assembly->wake() : std::vector<double>();
    return &wake;
  }
  if (name == "force") return &evaluation.force;
  if (name == "bar_tension") return &evaluation.bar_tension;
  if (name == "bar_length") return &evaluation.bar_length;
  if (name == "u_tension") return &evaluation.u_tension;
  if (name == "v_tension") return &evaluation.v_tension;
  if (name == "straight_tension") return &evaluation.straight_tension;
  const auto& reported = codend::reported_forces();
  for (std::size_t k = 0; k < reported.size() && k < evaluation.forces.size(); ++k) {
    if (name == reported[k].name) return &evaluation.forces[k];
  }
  return nullptr;
}

}  // namespace

extern "C" {

// What the last call that gave -1 threw.
const char* codend_error() { return error.c_str(); }

// Places to write an array of the model into. They move when the array is asked for again.
double* codend_numbers(const char* name, int count) {
  Array& array = fresh(name, Type::numbers);
  array.numbers.resize(static_cast<std::size_t>(count));
  return array.numbers.data();
}
int* codend_wholes(const char* name, int count) {
  Array& array = fresh(name, Type::wholes);
  array.wholes.resize(static_cast<std::size_t>(count));
  return array.wholes.data();
}
void codend_groups(const char* name, int count) { fresh(name, Type::groups).groups = count; }
// text: words parted by ends of lines; none where count is 0.
void codend_words(const char* name, const char* text, int count) {
  Array& array = fresh(name, Type::words);
  const std::string all = text;
  std::size_t from = 0;
  for (int k = 0; k < count; ++k) {
    const std::size_t to = all.find('\n', from);
    array.words.push_back(all.substr(from, to - from));
    from = to + 1;
  }
}

// Places to write the start (3 per node, m) and the strains of all lines into.
double* codend_position(int count) {
  position.resize(static_cast<std::size_t>(count));
  return position.data();
}
double* codend_strain(int count) {
  strain.resize(static_cast<std::size_t>(count));
  return strain.data();
}

// Reads the gear from its arrays anew. Returns its nodes, or -1 (codend_error()).
int codend_read() {
  return guarded([] {
    assembly.reset();
    bag.reset();
    if (arrays.count("bag.blocked") != 0) {
      bag.emplace(codend::read_fields<codend::FilledBag>(PageSource("bag.")));
      if (front > 0.0) bag->blocked = front;
      fresh("model.pressure.weight", Type::numbers).numbers = codend::pressure_weights(*bag);
    }
    frame = codend::read_fields<codend::MeasureFrame>(PageSource("frame."));
    questions = codend::read_fields<codend::Questions>(PageSource("questions."));
    model.emplace(codend::read_fields<codend::Model>(PageSource("model.")));
    model->prepare();
    assembly = std::make_unique<codend::Assembly>(*model);
    return model->nodes;
  });
}

// From a settled state; part: of every line, counted from 0. Returns whether it settled, or -1. Position and strain are left as they came where it did not.
int codend_settle(const int* part, double tolerance, int iterations) {
  return guarded([&] {
    const std::size_t lines = static_cast<std::size_t>(model->lines());
    codend::SettleControl control;
    control.start = codend::Start::settled;
    if (strain.size() == lines) control.strain = strain;
    control.part.assign(part, part + lines);
    control.tolerance = tolerance;
    control.iterations = iterations;
    const std::vector<double> still(position.size(), 0.0);
    std::vector<double> x = position;
    report = codend::settle_from(*assembly, control, still.data(), x.data());
    if (!report.converged) return 0;
    position = x;
    assembly->strain(strain);
    strain.resize(lines);
    return 1;
  });
}
// The bag's front, meshes; and the volume (m3) behind it where the gear is.
void codend_front(double meshes) { front = meshes; }
double codend_blocked() { return bag ? bag->blocked : 0.0; }
double codend_volume() {
  return bag ? codend::bag_volume(*bag, codend::all_points(*model, position)) : 0.0;
}
int codend_iterations() { return report.iterations; }
int codend_unstable() { return report.unstable ? 1 : 0; }
double codend_residual() { return report.residual; }

// Forces, tensions and measures at the shape. Plates: attack, heel, trim (rad), lift, drag (N) each;
// drag: of every part along the flow (N); opening (m), angle (rad): of meshes; flow: of the water past
// the gear's middle (m/s).
int codend_evaluate() {
  return guarded([] {
    const std::vector<double> still(position.size(), 0.0);
    evaluation = codend::evaluate(*assembly, position.data(), still.data());
    plates.clear();
    for (const codend::PlateAttitude& plate : evaluation.plates) {
      plates.insert(plates.end(), {plate.attack, plate.heel, plate.trim, plate.lift, plate.drag});
    }
    const codend::MeasuredShape<double> shape = codend::measured_shape(evaluation, position, still);
    measures = codend::measure(frame, *model, questions, bag ? &*bag : nullptr, shape);
    points = codend::all_points(*model, position);
    const codend::Three<double> way = codend::flow_axis(*model, questions);
    const std::vector<double> forces = codend::part_forces(frame, shape);
    drag.clear();
    for (int part = 0; part < frame.parts; ++part) {
      drag.push_back(codend::dot(codend::three(forces, part), way));
    }
    opening.clear();
    angle.clear();
    for (const auto& place : codend::mesh_places(frame.meshes, points)) {
      opening.push_back(place.opening);
      angle.push_back(place.angle);
    }
    double low = position[2], high = position[2];
    for (std::size_t k = 2; k < position.size(); k += 3) {
      low = std::min(low, position[k]);
      high = std::max(high, position[k]);
    }
    codend::Vector current, slope;
    model->water.velocity((low + high) / 2, current, slope);
    flow = {current.x(), current.y()};
    return 0;
  });
}

// Numbers that were found, and how many; -1 of a name that is not known.
const double* codend_found(const char* name) {
  const std::vector<double>* values = found(name);
  return values ? values->data() : nullptr;
}
int codend_count(const char* name) {
  const std::vector<double>* values = found(name);
  return values ? static_cast<int>(values->size()) : -1;
}

}  // extern "C"
