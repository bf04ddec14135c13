#include "blended_netting.hpp"

namespace codend {

void BlendedNetting::set_twine(std::size_t e, int place, NettingStrip& strip) const {
  const TwineMaterial& m = materials[static_cast<std::size_t>(material[e])];
  const CylinderLaw& law = m.law;
  const double metres = shape(e).bars * multiplicity[e] * rest[e];
  strip.law[place] = static_cast<double>(NettingScreenLaw::kristiansen_faltinsen);
  strip.twine_area[place] = 2.0 * metres * m.diameter;
  strip.diameter[place] = m.diameter;
  NettingStrip::Twines& t = *strip.twines;
  t.curved = slack == SlackDrag::curved;
  for (int f = 0; f < 2 && strip.with_slopes; ++f) {
    for (int k = 0; k < 4; ++k) t.along[f][k][place] = shape(e).along[f][k];
  }
  t.inverse_rest[place] = 1.0 / rest[e];
  t.drag_weight[place] = 0.5 * strip.density * m.diameter * metres;
  t.normal[place] = law.normal * law.normal_share;
  t.tangential[place] = law.tangential * law.tangential_share;
  t.skin[place] = law.skin * law.tangential_share;
  t.speed_law[place] = law.kind == CylinderLawKind::constant ? nullptr : &m;
  t.by_speed = t.by_speed || t.speed_law[place];
  t.own[place] = 1.0;
}

}  // namespace codend
