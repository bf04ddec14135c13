// Linear solver for Newton's method in time integration, where successive matrices are similar. A
// factorisation in single precision preconditions GMRES (Saad and Schultz 1986, SIAM J. Sci. Stat.
// Comput. 7; right preconditioning in its flexible form, Saad 1993, 14). It is reused for the
// following matrices while this is cheaper than a new factorisation.
//
// Each row of the residual is divided by its allowance, so that soft parts of a gear are solved as
// accurately as its stiffest rope.
#pragma once

#include <memory>
#include <vector>

#include "block_lu.hpp"

namespace codend {

class StoredFactorisation {
 public:
  // pattern: must outlive this object. coordinates: see BlockLU::analyse().
  StoredFactorisation(const BlockPattern& pattern, std::vector<double> coordinates);

  // Stopping rule of solve(): the norm of the scaled residual is at most `allowed`, or at most
  // `share` times the norm of the scaled right side.
  struct Tolerance {
    double share = 1e-2;
    double allowed = 0.1;
  };

  // Excludes nodes (1 per excluded node) from the next matrix on. Rows of an excluded node must
  // have entries only in the diagonal block, and a zero right side.
  void leave_out(const std::vector<char>& node);

  // Sets a new matrix: 9 per block of the pattern, kept by reference until the next call. `first`
  // marks the first matrix of a time step, which differs more from the previous one.
  void set_matrix(const std::vector<double>& values, bool first);
  // Solves matrix * x = right, 3 per node; x must not be right. scale: allowance per node. Returns
  // false for a singular matrix.
  bool solve(const std::vector<double>& right, const std::vector<double>& scale,
             const Tolerance& tolerance, std::vector<double>& x);

  // Discards all previous matrices and factors, so that results depend only on later calls.
  void forget();

  long long factorisations() const { return factorisations_; }
  // Stored entries of L and U in the last factorisation.
  long long entries() const { return lu_ ? lu_->figures().factor_entries : 0; }

 private:
  // Matrices for which old factors are skipped, for first and for later matrices of a step.
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
  bool factorised_ = false;
  bool fresh_ = false;  // factors belong to the present matrix
  bool first_ = true;
  int affordable_ = 1;  // iterations that are cheaper than a factorisation
  Patience patience_[2];
  std::vector<char> left_out_;
  long long factorisations_ = 0;
  std::vector<std::vector<double>> basis_, direction_;
  std::vector<double> weight_;
};

}  // namespace codend
