// The engine's model from a lattice, which is an R list, and results in the lattice's order.
#pragma once

#include "binding_numbers.hpp"
#include "engine/model/evaluate.hpp"

namespace binding {

// Copies every array once. The caller connects the model where it comes to lie.
codend::Model read_model(const list& lattice);

// Values of plain triangles (`width` each) and those of hexagonal ones, in the order of the
// lattice.
inline doubles in_order(const doubles& straight, std::size_t width, const double* plain,
                        const double* hexagonal) {
  std::vector<double> out;
  out.reserve(width * static_cast<std::size_t>(straight.size()));
  for (const double bar : straight) {
    const double*& from = bar > 0.0 ? hexagonal : plain;
    out.insert(out.end(), from, from + width);
    from += width;
  }
  return as_doubles(out);
}

// Of every triangle the length of its straight bars, 0 of a plain one.
inline doubles straight_bars(const list& lattice) {
  const list triangles(lattice["triangles"]);
  return doubles(triangles["straight"]);
}

// One family of lines: of plain triangles, and the part of all three of hexagonal ones.
inline doubles family_in_order(const doubles& straight, const std::vector<double>& plain,
                               const std::vector<double>& hexagonal, std::size_t which) {
  return in_order(straight, 1, plain.data(), hexagonal.data() + which * (hexagonal.size() / 3));
}

// Of the straight bars of hexagonal triangles.
inline doubles straight_tension(const codend::Evaluation& e) {
  const auto first = e.hexagon_tension.begin();
  return as_doubles(std::vector<double>(
      first, first + static_cast<std::ptrdiff_t>(e.hexagon_tension.size() / 3)));
}

}  // namespace binding
