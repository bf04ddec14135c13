// The arithmetic of lines, many at a time: vectors in, tensions, drags and derivatives out.
#pragma once

#include <cstdint>

#include "../base/block_sink.hpp"
#include "twine.hpp"

namespace codend {

// Arrays by line number, each of which may be read and written up to 7 places beyond the lines.
// With e the vector along a line, q its twist (line.hpp), L its length, L0 its rest length, U the relative velocity.
struct LineArrays {
  // What the lines are.
  double* inverse_rest;   // 1/L0, 1/m
  double* stiffness;      // EA, N; of loads by strain, at the present strain
  double* least_tension;  // 0; of struts, which also push, far below it, N
  double* multiplicity;
  double* drag_weight;  // 1/2 rho d L0 times the multiplicity and a point's share, kg/m
  double *added_normal, *added_tangential;  // added mass in the water, a point's share, kg
  double *normal, *tangential, *skin;       // C_n, C_t, C_f
  // Null where there are no cells:
  double* twist_weight;     // kappa with the present bow, by which L^2 = |e|^2 + kappa |q|^2
  double* twist_stiffness;  // by which a twist is held besides, N/m
  double* held_pull;        // the same of one bar over kappa, N/m
  double* bow_slope;        // dL/ds, s the bow of a cell's twines (bows.hpp), m
  double* bow_stiffness;    // |q|^2 sum k b of bows.hpp, at a cell's u line, N m
  double* damping;          // c, N s; null where no line has any
  double* rest_rate;        // dL0/dt over L0, 1/s; with damping
  // Materials of lines whose coefficients depend on speed, null for others; null if there are none.
  const TwineMaterial* const* speed_law;
  // Materials of lines whose loads are given by strain, as above; T is then EA s + offset (N).
  const TwineMaterial* const* load_law;
  double* offset;
  double viscosity;  // m2/s
  bool curved;       // SlackDrag::curved

  // The flow past them.
  double *u[3], *speed;  // U and |U|, m/s
  double* slope[3];      // dU/dz, 1/s; null where it is the same everywhere
  double* own;           // -dU/dv of the mean velocity v of its points
  double* wet;           // share that is in the water; null without a free surface
  double* loose;         // drag of a curled-up line over U, a point's share, N s/m
  double* loose_slope;   // its derivative by |U|
  double* drag_scale;    // drag over U, a point's share, at right angles, N s/m

  double* e_rate[3];      // de/dt, m/s; with damping or cells
  double* twist_rate[3];  // dq/dt, m/s; with cells

  // Where they are.
  double* e[3];      // m
  double* twist[3];  // q of a netting cell's lines, 0 of others, m; null where there are no cells
  double* inverse_span;    // 1/|e|; 1/L0 where that is 0
  double* inverse_length;  // 1/L, the same of lines without a twist; 1/L0 for a line without length
  double* strain;          // L/L0 - 1
  double* tension;         // of one line, by the law, N
  double* drag[3];         // a point's share, N
};

// stiffness * (-dF/dx) + damping * (-dF/dv), as JacobianRequest; tension (N) and modulus (N) of one
// line each, `lines` in all; without modulus, that of the law. A line's damper counts where its modulus is
// not 0.
struct LineRequest {
  double stiffness, damping;
  const double* tension;
  const double* modulus;
  std::int64_t lines;
};

// Of netting cells (netting_cell.hpp), readable up to 7 places beyond them.
struct CellArrays {
  const double *along[2][4], *twist[4], *share[4], *amplitude;
};

// The inner loops, compiled once per set of processor instructions.
struct LineKernels {
  // From U all else of the flow but its slope, for lines [begin, end).
  void (*flow)(const LineArrays& lines, std::int64_t begin, std::int64_t end);
  // From e and the flow all that follows from them, for lines [begin, end).
  void (*evaluate)(const LineArrays& lines, std::int64_t begin, std::int64_t end);
  // Changes of strain, to first order, when the vectors of lines [begin, end) change by change[.] and
  // their twists by twist[.] (null: not at all); returns the largest (change of them / L0)^2. `change`,
  // `twist` and `strain` begin at line `begin`.
  double (*change)(const LineArrays& lines, std::int64_t begin, std::int64_t end,
                   const double* const change[3], const double* const* twist, double* strain);
  // Adds the blocks of all bars, lines [0, bars).
  void (*add_bar_blocks)(const LineArrays& lines, const LineRequest& request, std::int64_t bars,
                         const BlockSink& sink);
  // Adds the blocks of netting cells [begin, end); the u lines of all begin at `first`, v lines at
  // first + cells.
  void (*add_cell_blocks)(const LineArrays& lines, const LineRequest& request, std::int64_t first,
                          std::int64_t cells, std::int64_t begin, std::int64_t end,
                          const CellArrays& shape, const BlockSink& sink);
  // Slopes of lines [begin, end), 27 each, row-major: of the pull and of the drag by e, and of the
  // drag by the water's velocity (zero where not asked for).
  void (*slopes)(const LineArrays& lines, const LineRequest& request, std::int64_t begin,
                 std::int64_t end, double* out);
};

// Coefficients of cylinder_law.hpp for a law that depends on speed: a, a_n, b, b_n, b_t.
void speed_coefficients(const TwineMaterial& material, double q_n, double q_t, double viscosity,
                        double* out);

// Tension less modulus times strain, and modulus, of a table of loads.
void load_coefficients(const TwineMaterial& material, double strain, double* out);

// For any processor.
const LineKernels& portable_line_kernels();

// For x86-64 with AVX2 and FMA; null where the compiler or the running processor lacks them.
const LineKernels* avx2_line_kernels();

// The fastest that the running processor can execute. The choice is fixed for a machine; two
// machines may differ in the last bits of a force.
const LineKernels& line_kernels();

}  // namespace codend
