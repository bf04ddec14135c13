#include "blended_netting.hpp"

#include <algorithm>

namespace codend {

void BlendedNetting::describe(std::size_t e, std::size_t place, double density,
                              const CellShape& shape, NettingProperties& to,
                              TwineProperties* twines) const {
  const TwineMaterial& m = materials[static_cast<std::size_t>(material[e])];
  const CylinderLaw& law = m.law;
  const double metres = shape.bars * multiplicity[e] * rest[e];
  to.law[place] = static_cast<double>(NettingScreenLaw::kristiansen_faltinsen);
  to.twine_area[place] = 2.0 * metres * m.diameter;
  to.diameter[place] = m.diameter;
  for (int f = 0; f < 2; ++f) {
    for (int k = 0; k < 4; ++k) twines->along[f][k][place] = shape.along[f][k];
  }
  twines->inverse_rest[place] = 1.0 / rest[e];
  twines->drag_weight[place] = 0.5 * density * m.diameter * metres;
  twines->normal[place] = law.normal * law.normal_share;
  twines->tangential[place] = law.tangential * law.tangential_share;
  twines->skin[place] = law.skin * law.tangential_share;
}

void BlendedNetting::set_laws(std::size_t first, NettingStrip::Twines& twines) const {
  twines.curved = slack == SlackDrag::curved;
  twines.by_speed = false;
  for (std::size_t place = 0; place < NettingProperties::most; ++place) {
    const std::size_t e = std::min(first + place, material.size() - 1);
    const TwineMaterial& m = materials[static_cast<std::size_t>(material[e])];
    twines.speed_law[place] = m.law.kind == CylinderLawKind::constant ? nullptr : &m;
    twines.by_speed = twines.by_speed || twines.speed_law[place];
  }
}

}  // namespace codend
