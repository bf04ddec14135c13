// A gear settled from its numbers alone, on a lattice of about so many nodes: coarse first, then as finely
// as is asked.
#pragma once

#include "../solve/settle.hpp"
#include "measured_gear.hpp"

namespace codend {

struct SettledGear {
  MeasuredGear gear;
  std::vector<double> position;  // m, 3 per node
  std::vector<double> measures;  // of the questions, SI
  SettleReport report;
};

// nodes: below 1,000; more take strains of the level before along, which this does not, nor settle what is let go along a rope. Throws InputError
// where the numbers make no sense.
SettledGear settle_gear(const GearNumbers& numbers, double nodes);

}  // namespace codend
