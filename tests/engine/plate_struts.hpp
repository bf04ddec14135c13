// Struts between the three points of a plate that a test fills by hand.
#pragma once

#include <array>

#include "model/model.hpp"

namespace codend {

// Adds bars of 1e7 N that carry compression and have no drag, between nodes 0, 1 and 2. The
// distances between these positions are their lengths (m). They are the model's only bars
// and material.
inline void join_by_struts(Model& model, const std::array<Vector, 3>& at) {
  TwineMaterial strut;
  strut.axial_stiffness = 1e7;
  strut.strut = true;
  strut.law.normal = strut.law.tangential = strut.law.skin = 0.0;
  strut.added_mass_normal = 0.0;
  model.materials = {strut};
  model.bars.node = {0, 1, 1, 2, 2, 0};
  model.bars.rest = {(at[1] - at[0]).norm(), (at[2] - at[1]).norm(), (at[0] - at[2]).norm()};
  model.bars.multiplicity.assign(3, 1.0);
  model.bars.material.assign(3, 0);
}

}  // namespace codend
