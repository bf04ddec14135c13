// Damages the text of random models and reads them. Reading must throw an InputError, or return a
// model that can be evaluated, settled for some steps and moved.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "motion/schemes.hpp"
#include "random_model.hpp"
#include "text_writer.hpp"

namespace codend {

// The k-th random model as text, with elements of every kind, its position and its velocity.
struct ModelText {
  explicit ModelText(std::uint64_t k) {
    Random random(k);
    Ingredients wanted;
    wanted.bars = 8;
    wanted.bodies = wanted.knots = wanted.smooth_spheres = 2;
    wanted.lifts_up = wanted.lifts_sideways = wanted.pressed = wanted.screens = 2;
    wanted.cells = wanted.blended = wanted.openings = wanted.bends = wanted.contacts = 2;
    wanted.plates = wanted.volumes = wanted.twists = 1;
    hexagonal = k % 2 == 0;
    // the lengths of a random model are drawn after the sliding rope took its own
    wanted.sliding = hexagonal ? 1 : 0;
    wanted.axial_stiffness = 1000.0;
    wanted.layered = random.below(2) == 1;
    wanted.free_surface = random.below(2) == 1;
    wanted.waves = wanted.free_surface && random.below(2) == 1;
    wanted.wake = random.below(2) == 1;
    wanted.struts = random.below(2) == 1;
    Specimen specimen(random, wanted);
    x = specimen.x;
    v = specimen.v;
    Assembly assembly(specimen.model);
    force = evaluate(assembly, x.data(), v.data()).force;
    CellList cells;
    const NettingCells& plain = specimen.model.cells;
    cells.node = plain.node;
    cells.twine = plain.twine;
    cells.rest = plain.rest;
    cells.straight.assign(plain.rest.size(), 0.0);
    cells.inner.assign(plain.rest.size(), -1);
    cells.multiplicity = plain.multiplicity;
    cells.height = plain.height;
    cells.material = plain.material;
    if (hexagonal) {
      cells.straight[0] = 1.0;
      int point = 0;
      while (std::find(cells.node.begin(), cells.node.begin() + 4, point) !=
             cells.node.begin() + 4) {
        ++point;
      }
      cells.inner[0] = point;
    }
    Model copy = specimen.model;
    TextWriter writer(cells, {"ground", "waves"});
    copy.fields(writer);
    text = writer.text;
  }
  std::string text;
  std::vector<double> x, v;
  std::vector<double> force;  // at x and v; empty if cells were made hexagonal
  bool hexagonal = false;
};

inline const std::vector<std::string>& odd_words() {
  static const std::vector<std::string> words = {
      "0",           "1",     "-1",    "2",    "-0",      "1e308",      "-1e308",
      "1e-320",      "100",   "1e-12", "0.5",  "1000000", "2147483647", "-2147483648",
      "99999999999", "1e400", "nan",   "inf",  "-",       "0x10",       "1,5",
      "whole",       "list",  "#",     "ropes"};
  return words;
}
constexpr std::size_t odd_numbers = 12;  // of these strings, the first 12

// A text with one to three changes.
inline std::string damaged(std::string text, Random& random) {
  const auto below = [&](std::size_t n) {
    return static_cast<std::size_t>(random.below(static_cast<int>(n)));
  };
  for (int k = 1 + random.below(3); k > 0 && text.size() > 2; --k) {
    const std::size_t at = below(text.size());
    // the token and its line
    const std::size_t from = text.find_last_of(" \n", at) + 1;
    const std::size_t to = std::min(text.find_first_of(" \n", at), text.size());
    const std::size_t length = to > from ? to - from : 0;
    const std::size_t line = text.find_last_of('\n', at) + 1;
    const std::size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
    switch (random.below(14)) {
      case 0:
        text[at] = static_cast<char>(random.below(256));
        break;
      case 1:
        text.erase(from, length);
        break;
      case 2:
        text.insert(from, odd_words()[below(odd_words().size())] + " ");
        break;
      case 3:
        text.erase(line, end > line ? end - line : 0);
        break;
      case 4:
        text.insert(line, text.substr(line, end > line ? end - line : 0));
        break;
      case 5:
        if (random.below(8) == 0) text.resize(at);
        break;
      case 6:
        text.replace(from, length, odd_words()[below(odd_words().size())]);
        break;
      // most often a number becomes another number, so that it can be read
      default:
        text.replace(from, length, odd_words()[below(odd_numbers)]);
    }
  }
  return text;
}

// Reads a text and uses its model. Returns true if it was accepted; rethrows all but InputError.
inline bool try_text(const ModelText& of, const std::string& text) {
  try {
    Model model = read_fields<Model>(TextSource(text));
    model.prepare();
    // the original positions, repeated for additional nodes
    const std::size_t n = 3 * static_cast<std::size_t>(model.nodes);
    if (n == 0 || n > 300) return true;
    std::vector<double> x(n), v(n);
    for (std::size_t k = 0; k < n; ++k) {
      x[k] = of.x[k % of.x.size()] + 0.01 * static_cast<double>(k / of.x.size());
      v[k] = of.v[k % of.v.size()];
    }
    Assembly assembly(model);
    evaluate(assembly, x.data(), v.data());
    SettleControl control;
    control.iterations = 4;
    const std::vector<double> at_rest(n, 0.0);
    settle(assembly, control, at_rest.data(), x.data());
    return true;
  } catch (const InputError&) {
    return false;
  }
}

struct Tried {
  int taken = 0, refused = 0;
};

inline Tried try_damaged_models(std::uint64_t seed, int count) {
  Tried tried;
  for (int k = 0; k < count; ++k) {
    const std::uint64_t number = seed + static_cast<std::uint64_t>(k);
    const ModelText of(number);
    Random random(number);
    ++(try_text(of, damaged(of.text, random)) ? tried.taken : tried.refused);
  }
  return tried;
}

}  // namespace codend
