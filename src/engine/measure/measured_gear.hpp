// A gear from all of its numbers: on a lattice, as a model, and measured at a shape.
#pragma once

#include <functional>

#include "../gear/gear_model.hpp"
#include "measures.hpp"

namespace codend {

// All numbers of a gear. blocked: meshes of its bag behind the front of what fills it; 0: it has none.
// volume: of what fills it, m3, where the front is sought, from `blocked` on; 0: it is given.
struct GearNumbers {
  Gear gear;
  GearModel model;
  Questions questions;
  double blocked = 0.0, volume = 0.0;

  template <class Visit>
  void fields(Visit& visit) {
    visit.group("gear", gear);
    visit.group("model", model);
    visit.group("questions", questions);
    visit("blocked", blocked);
    visit("volume", volume);
  }
};

struct MeasuredGear {
  Lattice lattice;
  Model model;  // ready for use
  FilledBag bag;
};

// gear: that of the numbers, or the same divided otherwise; pause: called now and then where there is one,
// what it throws ends it. Throws InputError for what does not fit.
MeasuredGear measured_gear(const GearNumbers& numbers, const Gear& gear, const Fineness& fineness,
                           const FromShape& from, const std::function<void()>& pause = {});

// A gear on its lattice, whose model is not ready for use. blocked: meshes of its bag behind the front.
MeasuredGear unprepared_gear(const Gear& gear, const GearModel& numbers, Lattice&& lattice,
                             double blocked);

// Puts the pressure within a filled bag into a model.
void press(const FilledBag& bag, Model& model);

// Measures of the questions, SI, at positions x (m, 3 per node) at rest. assembly: of its model.
std::vector<double> measures_at(const GearNumbers& numbers, const Gear& gear,
                                const MeasuredGear& of, Assembly& assembly,
                                const std::vector<double>& x);

}  // namespace codend
