// C interface of the engine for a page (web/src/share/model.ts). Input: named arrays. Output: the
// equilibrium shape, forces and measures. A page has one worker with one engine and one gear at a
// time.
//
// Arrays hold the fields of `numbers` (GearNumbers), the fields of `from`, the initial shape
// (InitialShape, see measure/settled_gear.hpp), and `page/strength`: breaking loads of all parts (N;
// 0: unknown).
#include <algorithm>
#include <exception>
#include <map>
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

// Arrays by path, such as numbers.gear.panels.deep. The k-th group of a list has the suffix .k,
// from 1.
std::map<std::string, Array> arrays;

// Reads the arrays as a source of fields (base/read_fields.hpp).
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

std::optional<codend::InitialShape> from;
// Numbers and result of the last gear that converged.
std::optional<codend::GearNumbers> numbers;
std::optional<codend::SettledGear> settled;
// Results of codend_evaluate().
std::map<std::string, std::vector<double>> results;
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

// Orthonormal axes defined by three points, as columns.
codend::Matrix triad(const codend::Vector& a, const codend::Vector& b, const codend::Vector& c) {
  codend::Matrix out;
  out.col(0) = (b - a).normalized();
  out.col(1) = (c - a - (c - a).dot(out.col(0)) * out.col(0)).normalized();
  out.col(2) = out.col(0).cross(out.col(1));
  return out;
}

// Corners of rigid boards (m): leading edge lower and upper, trailing edge upper and lower.
std::vector<double> board_corners(const codend::LiftingPlates& plates, const double* x) {
  std::vector<double> out;
  for (const codend::LiftingPlate& plate : plates.plate) {
    const auto& [a, b, c] = plate.attachment;
    const codend::Vector first = codend::at(x, plate.node[0]);
    const codend::Matrix turn =
        triad(first, codend::at(x, plate.node[1]), codend::at(x, plate.node[2])) *
        triad(a, b, c).transpose();
    for (const auto& [along, up] : {std::pair(0.0, -0.5), {0.0, 0.5}, {1.0, 0.5}, {1.0, -0.5}}) {
      const codend::Vector corner(along * plate.chord, 0.0, up * plate.span);
      const codend::Vector place = first + turn * (corner - a);
      out.insert(out.end(), place.data(), place.data() + 3);
    }
  }
  return out;
}

}  // namespace

extern "C" {

// Returns the message of the exception in the last call that returned -1.
const char* codend_error() { return error.c_str(); }

// Return memory to write an input array. The address changes if the array is requested again.
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
// text: strings separated by line ends; empty if count is 0.
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

// Solves for the equilibrium of the gear in the arrays. The initial guess is the last converged
// state, in the first call the shape in the arrays. Returns 1 if it converged, 0 if not (the
// previous state remains), -1 after an error (see codend_error()).
int codend_settle(double tolerance, int iterations) {
  return guarded([&] {
    if (!from) from = codend::read_fields<codend::InitialShape>(PageSource("from."));
    auto read = codend::read_fields<codend::GearNumbers>(PageSource("numbers."));
    read.gear.check();
    const double before = numbers ? numbers->questions.speed : 0.0, now = read.questions.speed;
    from->drag_growth = before > 0 && now > 0 ? now * now / (before * before) : 1.0;
    codend::GearSettling how;
    how.nodes = from->nodes;
    how.from = &*from;
    how.through_levels = false;
    how.tolerance = tolerance;
    how.iterations = iterations;
    codend::SettledGear found;
    try {
      found = codend::settle_gear(read, how);
    } catch (const codend::InputError&) {
      // Numbers between two valid gears may be invalid.
      if (!settled) throw;
      return 0;
    }
    codend::LineMap lines = codend::line_map(read.gear, found.gear.mesh);
    // The drawing uses the lines of the first shape.
    if (!found.report.converged || !lines.alike(from->lines)) return 0;
    from->position = codend::all_points(found.gear.model, found.position);
    from->strain = found.strain;
    from->lines = std::move(lines);
    from->wake_sheets = found.gear.model.wake_sheets;
    from->wake = found.gear.model.wake;
    from->blocked = found.gear.bag.blocked;
    numbers = std::move(read);
    settled = std::move(found);
    return 1;
  });
}

// Computes the results of the gear in equilibrium. codend_found() returns them by name.
//
// `plates`: attack, heel, trim (rad), lift and drag (N) of each plate.
//
// `corners`: corners of boards (m).
//
// `drag`: drag of every part along the flow (N).
//
// `load`: largest tension of every part over its strength.
//
// `opening` (m) and `angle` (rad) of meshes.
//
// `flow`: velocity of the water at the gear's mean depth (m/s).
//
// `report`: iterations, and 1 if the equilibrium is unstable.
//
// `points` (m), `bar_tension`, `u_tension`, `v_tension` (N), `measures` (SI).
int codend_evaluate() {
  return guarded([] {
    const codend::Model& model = settled->gear.model;
    const codend::Mesh& mesh = settled->gear.mesh;
    const std::vector<double>& position = settled->position;
    const std::vector<double> still(position.size(), 0.0);
    codend::Assembly assembly(model);
    const codend::Evaluation found = codend::evaluate(assembly, position.data(), still.data());
    const codend::MeasureFrame frame = codend::measure_frame(numbers->gear, mesh);
    results.clear();
    results["bar_tension"] = found.bar_tension;
    results["u_tension"] = found.u_tension;
    results["v_tension"] = found.v_tension;
    results["measures"] = settled->measures;
    const std::vector<double>& points = results["points"] = codend::all_points(model, position);
    results["corners"] = board_corners(model.plates, points.data());
    std::vector<double>& plates = results["plates"];
    for (const codend::PlateAttitude& plate : found.plates) {
      plates.insert(plates.end(), {plate.attack, plate.heel, plate.trim, plate.lift, plate.drag});
    }
    const codend::Three<double> way = codend::flow_axis(model, numbers->questions);
    const std::vector<double> forces =
        codend::part_forces(frame, codend::measured_shape(found, position, still));
    for (int part = 0; part < frame.parts; ++part) {
      results["drag"].push_back(codend::dot(codend::three(forces, part), way));
    }
    const std::vector<double>& strength = arrays.at("page/strength").numbers;
    std::vector<double>& load = results["load"];
    load.resize(strength.size());
    for (std::size_t k = 0; k < mesh.bar_part.size(); ++k) {
      const auto part = static_cast<std::size_t>(mesh.bar_part[k]);
      if (strength[part] > 0) {
        load[part] = std::max(load[part], found.bar_tension[k] / strength[part]);
      }
    }
    std::vector<double>&opening = results["opening"], &angle = results["angle"];
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
    model.water.velocity((low + high) / 2, current, slope);
    results["flow"] = {current.x(), current.y()};
    results["report"] = {static_cast<double>(settled->report.iterations),
                         static_cast<double>(settled->report.unstable)};
    return 0;
  });
}

// Return the numbers of a result, and their count (-1 for an unknown name).
const double* codend_found(const char* name) { return results[name].data(); }
int codend_count(const char* name) {
  const auto at = results.find(name);
  return at == results.end() ? -1 : static_cast<int>(at->second.size());
}

}  // extern "C"
