// A gear from all of its numbers: discretisation, model, and measures at a shape.
#pragma once

#include <functional>

#include "../gear/gear_model.hpp"
#include "measures.hpp"

namespace codend {

// Complete input of a gear. `blocked` is the number of meshes of its bag behind the front of the
// catch; 0: no catch. `volume` is the volume of the catch, m3. The front is then computed, starting
// at `blocked`; 0: the front is given.
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
  Mesh mesh;
  Model model;  // prepared for use
  FilledBag bag;
};

// Creates discretisation and model. gear: the gear of `numbers`, or the same with another mesh.
// pause: called repeatedly if given; an exception from it ends the computation. Throws InputError
// for inconsistent input.
MeasuredGear measured_gear(const GearNumbers& numbers, const Gear& gear, const Fineness& fineness,
                           const FromShape& from, const std::function<void()>& pause = {});

// The same from an existing discretisation, with an unprepared model. blocked: meshes of the bag
// behind the front.
MeasuredGear unprepared_gear(const Gear& gear, const GearModel& numbers, Mesh&& mesh,
                             double blocked);

// Sets the pressure in a filled bag in a model.
void press(const FilledBag& bag, Model& model);

// Measures (SI) of `numbers.questions` at positions x (m, 3 per node) at rest. assembly: of the
// model.
std::vector<double> measures_at(const GearNumbers& numbers, const Gear& gear,
                                const MeasuredGear& of, Assembly& assembly,
                                const std::vector<double>& x);

}  // namespace codend
