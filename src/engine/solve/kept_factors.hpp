// The linear equations of Newton's method in a motion, whose matrices change little from one to the
// next: a factorisation in single precision preconditions GMRES (Saad and Schultz 1986, SIAM J. Sci.
// Stat. Comput. 7; from the right, in its flexible form, Saad 1993, 14) for the matrices that follow it
// too, as long as that is cheaper than factors of their own.
//
// Residuals are judged row by row, each against what is allowed there: soft parts of a gear are solved
// as well as its stiffest rope.
#pragma once

#include <memory>
#include <vector>

#include "block_lu.hpp"

namespace codend {

class KeptFactors {
 public:
  // pattern: must outlive this. coordinates: as BlockLU::analyse().
  KeptFactors(const BlockPattern& pattern, std::vector<double> coordinates);

  // What may be left of the right side in solve(), by the root of the sum of squares over what is
  // allowed in each row: this share, or this much.
  struct Tolerance {
    double share = 1e-2;
    double allowed = 0.1;
  };

  // Whether rows of a node are to be eliminated: one that is left out must have no entries but on its
  // diagonal block, and a right side of zero. Takes effect with the next matrix.
  void leave_out(const std::vector<char>& node);

  // A new matrix: 9 numbers per block of the pattern, kept by reference until the next. `first`: of a
  // step, which is less like the one before.
  void set_matrix(const std::vector<double>& values, bool first);
  // matrix * x = right, 3 per node; x may not be right. scale: what is allowed per node. False where
  // the matrix is singular.
  bool solve(const std::vector<double>& right, const std::vector<double>& scale,
             const Tolerance& tolerance, std::vector<double>& x);

  // Leaves nothing of what was: what follows depends on what is given from now on alone.
  void forget();

  long long factorisations() const { return factorisations_; }
  // Count of numbers that the last factorisation stores for L and U.
  long long entries() const { return lu_ ? lu_->figures().factor_entries : 0; }

 private:
  // Tries of old factors for matrices of a kind (first of a step, or later): how many are not made.
  struct Patience {
    int skipped = 0, next = 1;
  };

  bool factorise();
  bool iterate(const std::vector<double>& right, const std::vector<double>& scale,
               const Tolerance& tolerance, int most, std::vector<double>& x);
  void multiply(const double* x, double* product) const;

  const BlockPattern& pattern_;
  const std::vector<double> coordinates_;
  std::unique_ptr<BlockLU> lu_;
  Precision precision_ = Precision::single_precision;
  const std::vector<double>* values_ = nullptr;
  bool factorised_ = false;  // there are factors
  bool fresh_ = false;       // and they are of this matrix
  bool first_ = true;
  int affordable_ = 1;  // iterations that cost less than a factorisation
  Patience patience_[2];
  std::vector<char> left_out_;
  long long factorisations_ = 0;
  std::vector<std::vector<double>> basis_, direction_;
  std::vector<double> weight_;
};

}  // namespace codend
