// Discretisation error of measures, from other meshes of the same gear.
//
// A measure y on a mesh with element length h is modelled as Y + a h^p + e. The drift a h^p
// decreases with a power p. The scatter e differs between meshes, because it depends on the
// positions of element rows. Its standard deviation is a fraction of the drift. The unknown Y is
// fitted to all meshes by generalised least squares (Aitken 1936). The reported error is the root
// mean square of y - Y given the measures.
//
// Orders p are weighted by their likelihood; three meshes with a monotonic drift show the order.
// The size of drift and scatter is estimated from the measure's own differences. A single
// difference may vanish by chance, so that the usual size in the measure's class is included.
//
// The constants (measure_errors.cpp) are the same for all gears and measures. They were fitted to
// the shipped gears and 20 random gears, on 11 meshes of 250 to 12,000 nodes each, and validated on
// others.
#pragma once

#include <vector>

#include "measures.hpp"

namespace codend {

// Measures (SI) on a mesh with `nodes` nodes; NaN if not available.
struct MeasuredMesh {
  double nodes = 0.0;
  std::vector<double> measures;
};

// Returns standard errors (SI) of measures; NaN if no other mesh provides information. tolerance:
// residual of the equilibrium over the largest force. The accuracy of positions in the preceding
// time integration is `step_accuracy`, m; 0 for an equilibrium.
std::vector<double> measure_errors(const std::vector<MeasureKind>& kinds, const MeasuredMesh& here,
                                   std::vector<MeasuredMesh> others, double tolerance,
                                   double step_accuracy = 0.0);

// Returns node numbers of the additional mesh needed to estimate errors on a mesh with `nodes`
// nodes, in the order of trial. Empty if the meshes in `levels` suffice.
std::vector<double> extra_nodes(double nodes, std::vector<double> levels, bool netting);

// True if two meshes differ enough to estimate errors.
bool differ_enough(double nodes, double others);

}  // namespace codend
