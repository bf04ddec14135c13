// The error that a lattice leaves in measures, from other lattices of the same gear.
//
// A measure y on a lattice with elements of length h is taken as Y + a h^p + e: the drift a h^p falls with
// a power p, and e, different on every lattice, is what depends on how rows of elements happen to lie; its
// standard deviation is a share of the drift's. Y, which is not known, is fitted to all lattices by
// generalised least squares (Aitken 1936), and the error told is the root mean square of y - Y given them.
// Orders p are weighed by their likelihood: three lattices that drift one way show theirs. The size of
// drift and scatter together is estimated from the measure's own differences and, as one lattice's
// difference may vanish by chance, from what is usual in measures of its class.
//
// The numbers (measure_errors.cpp) are for all gears and measures. They are from the shipped gears and 20
// drawn at random, on 11 lattices of 250 to 12,000 nodes each, and were checked on others.
#pragma once

#include <vector>

#include "measures.hpp"

namespace codend {

// Measures on a lattice of so many nodes, SI; not a number where it has none.
struct MeasuredLattice {
  double nodes = 0.0;
  std::vector<double> measures;
};

// Standard errors of measures of these kinds, SI; not a number where no other lattice says more. tolerance:
// the share of the largest force that the balance leaves; step_accuracy: m, that the steps of a march to
// there were held to, 0 where it is settled.
std::vector<double> measure_errors(const std::vector<MeasureKind>& kinds,
                                   const MeasuredLattice& here, std::vector<MeasuredLattice> others,
                                   double tolerance, double step_accuracy = 0.0);

// Nodes of the lattice that is to be settled to know the errors on one of so many, in the order in which
// they are to be tried; none where those of so many nodes that there are do.
std::vector<double> extra_nodes(double nodes, std::vector<double> levels, bool netting);

// Whether two lattices differ enough to say something of each other.
bool tell_apart(double nodes, double others);

}  // namespace codend
