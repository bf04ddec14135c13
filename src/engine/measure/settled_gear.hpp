// A gear settled from its numbers alone, on a lattice of about so many nodes: coarse first, then as finely
// as is asked.
#pragma once

#include "../gear/gear_model.hpp"
#include "../solve/settle.hpp"
#include "measures.hpp"

namespace codend {

// All numbers of a gear. blocked: meshes of its bag behind the front of what fills it; 0: it has none.
struct GearNumbers {
  Gear gear;
  GearModel model;
  Questions questions;
  double blocked = 0.0;

  template <class Visit>
  void fields(Visit& visit) {
    visit.group("gear", gear);
    visit.group("model", model);
    visit.group("questions", questions);
    visit("blocked", blocked);
  }
};

struct SettledGear {
  Lattice lattice;
  Model model;
  FilledBag bag;
  std::vector<double> position;  // m, 3 per node
  std::vector<double> measures;  // of the questions, SI
  SettleReport report;
};

// nodes: below 1,000; more take strains of the level before along, which this does not, nor settle what is let go along a rope. Throws InputError
// where the numbers make no sense.
SettledGear settle_gear(const GearNumbers& numbers, double nodes);

}  // namespace codend
