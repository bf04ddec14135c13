// A lattice for R with what measures take of it.
#pragma once

#include "binding_list.h"
#include "engine/gear/lattice.hpp"
#include "engine/measure/frame.hpp"

namespace binding {

struct Framed {
  codend::Lattice lattice;
  codend::MeasureFrame frame;

  template <class Visit>
  void fields(Visit& visit) {
    lattice.fields(visit);
    visit.group("frame", frame);
  }
};

}  // namespace binding
