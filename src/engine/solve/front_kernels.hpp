#pragma once

#include "assembly_tree.hpp"

namespace codend {

// Rows that a block of `boundary` rows takes in store: whole registers, whichever kernels run.
constexpr int padded(int boundary) { return (boundary + 3) / 4 * 4; }

// A dense front [A11 A12; A21 A22], of which A11 is fully summed and eliminated here. Sizes are in
// scalars and multiples of 3. Blocks are column-major, a column of `boundary` rows being followed
// by zeros up to padded(boundary).
struct Front {
  int pivots;          // rows of A11
  int boundary;        // rows of A22
  double* lower;       // [A11; A21], a column takes pivots + padded(boundary)
  double* upper;       // A12 transposed, so that all long loops run down columns
  double* update;      // A22
  double* reciprocal;  // pivots: reciprocals of U's diagonal
  int* exchange;       // pivots: row that each row of A11 was swapped with in turn
};

// The inner loops, compiled once per set of processor instructions.
struct FrontKernels {
  // Replaces A11 by its LU factors with partial pivoting among its own rows, A21 and A12 by the
  // remaining columns of L and rows of U, and A22 by its Schur complement. Returns false at a pivot
  // whose reciprocal is not finite.
  bool (*factorise)(const Front& front);
  // Adds a child's update matrix of `boundary` rows into its parent's front.
  void (*extend_add)(const double* child, int boundary, const Run* run, const Run* run_end,
                     const Front& parent);
  // Forward substitution with the factors that factorise() left. `x` holds the front's pivots, then
  // its boundary; that part is reduced.
  void (*forward)(int pivots, int boundary, const double* lower, const int* exchange, double* x);
  // Back substitution. `x` holds the pivots, to be solved for, then the boundary, already solved.
  void (*backward)(int pivots, int boundary, const double* lower, const double* upper,
                   const double* reciprocal, double* x);
};

// For any processor.
const FrontKernels& portable_front_kernels();

// For x86-64 with AVX2 and FMA; null where the compiler or the running processor lacks them.
const FrontKernels* avx2_front_kernels();

// The fastest that the running processor can execute. The choice is fixed for a machine; two
// machines may differ in the last bits of a solution.
const FrontKernels& front_kernels();

}  // namespace codend
