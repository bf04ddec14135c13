#include "sag.hpp"

#include <algorithm>
#include <cmath>

namespace codend {
namespace {

constexpr int most_iterations = 60;
constexpr double smallest_change = 1e-15;

// The two families of one cell. Index f = 0: u, 1: v.
struct Cell {
  double straight[2];  // |e|^2 + (kappa - b) |q|^2
  double sag[2];       // b |q|^2
  double rest, held;   // held: additional stiffness against twist, N/m
  double length[2], tension[2], modulus[2];

  static double side(int f, double s) { return f == 0 ? 1.0 - s : 1.0 + s; }
  void set_lengths(double s) {
    for (int f = 0; f < 2; ++f) {
      length[f] = std::sqrt(straight[f] + sag[f] * side(f, s) * side(f, s));
    }
  }
  double pull(int f) const { return length[f] > 0.0 ? tension[f] / length[f] : 0.0; }
  // Change of s that balances the given tensions, in [-1, 1].
  double balance() const {
    const double u = (pull(0) + held) * sag[0], v = (pull(1) + held) * sag[1];
    return u + v > 0.0 ? (u - v) / (u + v) : 0.0;
  }
};

// Sets lengths, tensions and moduli at sag parameter s from the constitutive law.
void follow_law(const LineArrays& lines, const int* line, double s, Cell& cell) {
  cell.set_lengths(s);
  for (int f = 0; f < 2; ++f) {
    const double strain = cell.length[f] / cell.rest - 1.0;
    const TwineMaterial* table = lines.load_law ? lines.load_law[line[f]] : nullptr;
    double found[2] = {0.0, lines.stiffness[line[f]]};
    if (table) load_coefficients(*table, strain, found);
    cell.tension[f] = std::max(found[0] + found[1] * strain, 0.0);
    cell.modulus[f] = cell.tension[f] > 0.0 ? found[1] : 0.0;
  }
}

// Returns the s at which the tensions by the constitutive law are in equilibrium. Newton's method
// within bounds finds the root of an increasing function.
double balance_by_law(const LineArrays& lines, const int* line, Cell& cell) {
  double low = -1.0, high = 1.0, s = 0.0;
  for (int k = 0; k < most_iterations; ++k) {
    follow_law(lines, line, s, cell);
    double out = 0.0, slope = 0.0;
    for (int f = 0; f < 2; ++f) {
      const double side = Cell::side(f, s), pull = cell.pull(f);
      out += (f == 0 ? -1.0 : 1.0) * (pull + cell.held) * cell.sag[f] * side;
      slope += (pull + cell.held) * cell.sag[f];
      if (cell.tension[f] > 0.0) {
        const double by_s = cell.sag[f] * side / cell.length[f];
        slope += (cell.modulus[f] / cell.rest - pull) * by_s * by_s;
      }
    }
    if (!(slope > 0.0)) return s;
    (out > 0.0 ? high : low) = s;
    double next = s - out / slope;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    const double change = std::abs(next - s);
    s = next;
    if (change <= smallest_change) break;
  }
  follow_law(lines, line, s, cell);
  return s;
}

// Cells whose sides lie along the twines have no sag.
bool can_sag(const NettingCells& cells, std::size_t cell) {
  return cells.sag_weight[0][cell] > 0.0 || cells.sag_weight[1][cell] > 0.0;
}

Cell cell_of(const NettingCells& cells, const LineArrays& a, std::size_t e, const int* line) {
  double square = 0.0;
  for (int k = 0; k < 3; ++k) square += a.twist[k][line[0]] * a.twist[k][line[0]];
  Cell cell;
  cell.rest = 1.0 / a.inverse_rest[line[0]];
  cell.held = a.held_pull[line[0]];
  for (int f = 0; f < 2; ++f) {
    double span = 0.0;
    for (int k = 0; k < 3; ++k) span += a.e[k][line[f]] * a.e[k][line[f]];
    cell.sag[f] = cells.sag_weight[f][e] * square;
    cell.straight[f] = span + (cells.twist_weight[f][e] - cells.sag_weight[f][e]) * square;
  }
  return cell;
}

double inverse_length(const Cell& cell, int f) {
  return cell.length[f] > 1e-12 * cell.rest ? 1.0 / cell.length[f] : 1.0 / cell.rest;
}

void put(const NettingCells& cells, const LineArrays& a, std::size_t e, const int* line,
         const Cell& cell, double s) {
  for (int f = 0; f < 2; ++f) {
    const int i = line[f];
    const double side = Cell::side(f, s);
    a.twist_weight[i] = cells.twist_weight[f][e] + cells.sag_weight[f][e] * (side * side - 1.0);
    a.twist_stiffness[i] = a.held_pull[i] * a.multiplicity[i] * a.twist_weight[i];
    a.sag_derivative[i] = (f == 0 ? -1.0 : 1.0) * cell.sag[f] * side * inverse_length(cell, f);
  }
  a.sag_stiffness[line[0]] =
      (cell.pull(0) + cell.held) * cell.sag[0] + (cell.pull(1) + cell.held) * cell.sag[1];
}

}  // namespace

void set_sag(const NettingCells& cells, const LineArrays& a, int begin, int end) {
  for (int c = begin; c < end; ++c) {
    const std::size_t e = static_cast<std::size_t>(c);
    if (!can_sag(cells, e)) continue;
    const int line[2] = {cells.first_line + c, cells.first_line + cells.count() + c};
    Cell cell = cell_of(cells, a, e, line);
    const double s = balance_by_law(a, line, cell);
    put(cells, a, e, line, cell, s);
  }
}

void lead_sag(const NettingCells& cells, const LineArrays& a, int begin, int end,
              const double* tension, double* sag) {
  for (int c = begin; c < end; ++c) {
    const std::size_t e = static_cast<std::size_t>(c);
    if (!can_sag(cells, e)) continue;
    const int line[2] = {cells.first_line + c, cells.first_line + cells.count() + c};
    Cell cell = cell_of(cells, a, e, line);
    for (int f = 0; f < 2; ++f) cell.tension[f] = std::max(tension[line[f]], 0.0);
    // Fixed-point iteration: lengths depend only weakly on s.
    double s = sag[e];
    for (int k = 0; k < most_iterations; ++k) {
      const double before = s;
      cell.set_lengths(s);
      s = cell.balance();
      if (std::abs(s - before) <= smallest_change) break;
    }
    sag[e] = s;
    cell.set_lengths(s);
    put(cells, a, e, line, cell, s);
    for (int f = 0; f < 2; ++f) {
      a.inverse_length[line[f]] = inverse_length(cell, f);
      a.strain[line[f]] = cell.length[f] * a.inverse_rest[line[f]] - 1.0;
    }
  }
}

void change_sag(const NettingCells& cells, const LineArrays& a, int begin, int end,
                double* strain) {
  for (int c = begin; c < end; ++c) {
    const std::size_t e = static_cast<std::size_t>(c);
    if (!can_sag(cells, e)) continue;
    const int line[2] = {cells.first_line + c, cells.first_line + cells.count() + c};
    Cell cell = cell_of(cells, a, e, line);
    double unbowed[2];  // lengths after the change, at the previous s
    for (int f = 0; f < 2; ++f) {
      const double now = cell.rest * (1.0 + a.strain[line[f]]);
      unbowed[f] = std::max(now + cell.rest * strain[line[f]], 0.0);
      cell.straight[f] = std::max(cell.straight[f] + unbowed[f] * unbowed[f] - now * now, 0.0);
    }
    balance_by_law(a, line, cell);
    for (int f = 0; f < 2; ++f) strain[line[f]] += (cell.length[f] - unbowed[f]) / cell.rest;
  }
}

void add_sag_strains(const NettingCells& cells, const LineArrays& a, int begin, int end,
                     const BowRequest& request, double* strain) {
  for (int e = begin; e < end; ++e) {
    const int line[2] = {cells.first_line + e, cells.first_line + cells.count() + e};
    double driven = 0.0, stiffness = a.sag_stiffness[line[0]];
    for (const int i : line) {
      const double own = request.modulus[i] * a.inverse_rest[i] -
                         std::max(request.tension[i], 0.0) * a.inverse_length[i];
      stiffness += own * a.sag_derivative[i] * a.sag_derivative[i];
      if (request.mismatch)
        driven += a.sag_derivative[i] * request.modulus[i] * request.mismatch[i];
      if (request.change)
        driven += a.sag_derivative[i] * own * request.change[i] / a.inverse_rest[i];
    }
    if (!(stiffness > 0.0)) continue;
    for (const int i : line)
      strain[i] -= a.sag_derivative[i] * a.inverse_rest[i] * driven / stiffness;
  }
}

}  // namespace codend
