// Vectorised arithmetic of lines: vectors in; tensions, drag forces and derivatives out.
#pragma once

#include <cstdint>

#include "../base/block_sink.hpp"
#include "../base/drag_models.hpp"
#include "twine.hpp"

namespace codend {

// Arrays by line index. Each must be readable and writable for 7 entries beyond the last line.
// Notation: e the vector along the line, q its twist (line.hpp), L its length, L0 its rest length,
// U the relative velocity.
struct LineArrays {
  // Properties of the lines.
  double* inverse_rest;   // 1/L0, 1/m
  double* stiffness;      // EA, N; for load tables, at the present strain
  double* least_tension;  // 0; for struts, which also push, a large negative number, N
  double* multiplicity;
  double* drag_weight;  // 1/2 rho d L0 x multiplicity x one point's fraction, kg/m
  double *added_normal, *added_tangential;  // immersed added mass, one point's fraction, kg
  double *normal, *tangential, *skin;       // C_n, C_t, C_f
  // Null without netting cells:
  double* twist_weight;     // kappa at the present sag; L^2 = |e|^2 + kappa |q|^2
  double* twist_stiffness;  // additional stiffness against twist, N/m
  double* held_pull;        // the same for one bar, divided by kappa, N/m
  double* sag_derivative;   // dL/ds, s the sag parameter of the cell (sag.inl), m
  double* sag_stiffness;    // |q|^2 sum k b of sag.inl, at the cell's u line, N m
  double* damping;          // c, N s; null if no line has damping
  double* rest_rate;        // dL0/dt over L0, 1/s; only with damping
  // Material of each line whose coefficients depend on speed, null for others; null if none do.
  const TwineMaterial* const* speed_law;
  // Material of each line with a load table, as above; then T = EA s + offset (N).
  const TwineMaterial* const* load_law;
  double* offset;
  double viscosity;  // m2/s
  bool curved;       // SlackDrag::curved

  // Flow at the lines.
  double *u[3], *speed;  // U and |U|, m/s
  double* slope[3];      // dU/dz, 1/s; null if the flow is uniform
  double* own;           // -dU/dv of the mean velocity v of its points
  double* wet;           // immersed fraction; null without a free surface
  double* loose;         // drag of a slack line over U, one point's fraction, N s/m
  double* loose_slope;   // its derivative by |U|
  double* drag_scale;    // drag over U for a line normal to the flow, one point's fraction, N s/m

  double* e_rate[3];      // de/dt, m/s; only with damping or cells
  double* twist_rate[3];  // dq/dt, m/s; only with cells

  // Geometry and forces.
  double* e[3];  // m
  // q of a netting cell's lines, 0 for others, m; null without cells.
  double* twist[3];
  double* inverse_span;    // 1/|e|; 1/L0 where that is 0
  double* inverse_length;  // 1/L, or 1/L0 for a line without length
  double* strain;          // L/L0 - 1
  double* tension;         // of one line, by the constitutive law, N
  double* drag[3];         // one point's fraction, N
};

// Requests stiffness * (-dF/dx) + damping * (-dF/dv), as JacobianRequest. tension, modulus: of one
// line each, N, for `lines` lines; modulus null: by the constitutive law. Dampers act only on lines
// with a modulus other than 0.
struct LineRequest {
  double stiffness, damping;
  const double* tension;
  const double* modulus;
  std::int64_t lines;
};

// Shape functions of netting cells (netting_cell.hpp), readable for 7 entries beyond the last cell.
// The u lines of all cells start at line `first`, the v lines at first + count.
struct CellArrays {
  std::int64_t first, count;
  const double *along[2][4], *twist[4], *share[4], *amplitude;
  const double *twist_weight[2], *sag_weight[2];  // kappa and b
};

// Arrays per line: tension and modulus (N), difference of the tension from the constitutive law as
// a strain (or null), change of strain at fixed sag (or null).
struct SagRequest {
  const double *tension, *modulus, *mismatch, *change;
};

// Constant properties of some netting cells with screen or blended drag (netting_screen.hpp).
// Entries beyond the last cell repeat it.
struct NettingProperties {
  static constexpr int most = 32;
  double law[most];  // NettingScreenLaw
  double twine_area[most], overlap[most], diameter[most], multiplicity[most];
  double share[4][most];  // fraction of an evenly distributed load at each corner
};
// Of both families of twines in cells with blended drag; see LineArrays.
struct TwineProperties {
  static constexpr int most = NettingProperties::most;
  double along[2][4][most];
  double inverse_rest[most], drag_weight[most], normal[most], tangential[most], skin[most];
};

// Some netting cells in the flow. Entries beyond `count` up to a multiple of 8 repeat the last cell.
struct NettingStrip : NettingProperties {
  int count = 0;
  double density, viscosity;  // kg/m3, m2/s
  double drag_multiplier, lift_multiplier;
  LawRange range[3];          // per NettingScreenLaw
  double across[2][3][most];  // halves of the diagonals 0 to 2 and 1 to 3, m
  double u[3][most];          // mean relative velocity U, m/s
  // Only with derivatives by velocity: fraction of each corner's own velocity in U, derivative of U
  // by its height.
  double own[4][most], slope[4][3][most];
  double force[3][most];  // on whole cells, N

  struct Twines : TwineProperties {
    bool curved, by_speed = false;
    double e[2][3][most];
    const TwineMaterial* speed_law[most];
    double own[most];  // 1
    double speed[most], loose[most], loose_slope[most], drag_scale[most], inverse_span[2][most];
  };
  Twines* twines = nullptr;  // null: screens only
};

// Corners of the cells of a strip: positions (m) and velocities of the water past them (m/s).
struct NettingCorners {
  double position[4][3][NettingProperties::most], flow[4][3][NettingProperties::most];
};

// Inner loops, compiled once per instruction set.
struct LineKernels {
  // Computes all flow quantities of lines [begin, end) from U, except the gradient dU/dz.
  void (*flow)(const LineArrays& lines, std::int64_t begin, std::int64_t end);
  // Computes geometry, tension and drag of lines [begin, end) from e and the flow.
  void (*evaluate)(const LineArrays& lines, std::int64_t begin, std::int64_t end);
  // Computes changes of strain, to first order, when the vectors of lines [begin, end) change by
  // change[.] and their twists by twist[.] (null: no change). Returns the largest (change of vector
  // and twist / L0)^2. Entry 0 of `change`, `twist` and `strain` belongs to line `begin`.
  double (*change)(const LineArrays& lines, std::int64_t begin, std::int64_t end,
                   const double* const change[3], const double* const* twist, double* strain);
  // Adds the blocks of all bars, lines [0, bars).
  void (*add_bar_blocks)(const LineArrays& lines, const LineRequest& request, std::int64_t bars,
                         const BlockSink& sink);
  // Adds drag and pull of netting cells [begin, end) to the forces on points (N, 3 per point).
  // node: 4 points per cell; tension: of one line, N.
  void (*add_cell_forces)(const LineArrays& lines, const CellArrays& cells, const int* node,
                          std::int64_t begin, std::int64_t end, const double* tension,
                          double* force);
  // Adds the blocks of netting cells [begin, end).
  void (*add_cell_blocks)(const LineArrays& lines, const LineRequest& request,
                          const CellArrays& cells, std::int64_t begin, std::int64_t end,
                          const BlockSink& sink);
  // Writes three 3x3 derivatives per line [begin, end), 27 numbers, row-major: pull by e, drag by
  // e, and drag by the water's velocity.
  void (*slopes)(const LineArrays& lines, const LineRequest& request, std::int64_t begin,
                 std::int64_t end, double* out);

  // Sag of the twines in netting cells [begin, end), see sag.inl.
  //
  // Computes the sag from the constitutive law. Sets twist weights, twist stiffnesses and dL/ds of
  // the cells' lines. Requires the vectors and twists of the lines.
  void (*set_sag)(const LineArrays& lines, const CellArrays& cells, std::int64_t begin,
                  std::int64_t end);
  // Computes the sag from given tensions (N, one line each), starting from `sag` (s, one per cell),
  // which it updates. Also sets lengths and strains.
  void (*lead_sag)(const LineArrays& lines, const CellArrays& cells, std::int64_t begin,
                   std::int64_t end, const double* tension, double* sag);
  // Corrects changes of strain at fixed sag (per line) for the change of sag: s moves to its
  // equilibrium by the constitutive law after the change. This is not linearised, because the sag
  // of slack twines reverses with almost no change of length.
  void (*change_sag)(const LineArrays& lines, const CellArrays& cells, std::int64_t begin,
                     std::int64_t end, double* strain);
  // Adds l ds/L0 to `strain`, per line.
  void (*add_sag_strains)(const LineArrays& lines, const CellArrays& cells, std::int64_t begin,
                          std::int64_t end, const SagRequest& request, double* strain);

  // Sets the half diagonals, bar vectors and mean velocities of netting cells.
  void (*set_screen_flow)(NettingStrip& cells, const NettingCorners& corners);
  // Sets the forces of netting cells with screen or blended drag.
  void (*set_screen_forces)(NettingStrip& cells);
  // Adds their blocks (JacobianRequest), from element `first` on. by_velocity: false if U and its
  // effect on forces are constant.
  void (*add_screen_blocks)(NettingStrip& cells, double stiffness, double damping, bool by_velocity,
                            std::int64_t first, const BlockSink& sink);
};

// Writes tension minus modulus times strain, and the modulus, of a load table (N).
void load_coefficients(const TwineMaterial& material, double strain, double* out);

// For any processor.
const LineKernels& portable_line_kernels();

// For x86-64 with AVX2 and FMA; null if the compiler or the processor does not support them.
const LineKernels* avx2_line_kernels();

// Fastest kernels of the present processor. The choice never changes on one machine. Forces may
// differ in the last bits between machines.
const LineKernels& line_kernels();

}  // namespace codend
