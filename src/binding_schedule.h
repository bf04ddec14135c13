// Reads the engine's schedule from the R list of a tow.
#pragma once

#include "binding_numbers.h"
#include "engine/motion/schedule.hpp"

namespace binding {

codend::Schedule read_schedule(const list& from);

// Returns the state of a schedule that depends on the motion so far, as an R list.
writable::list schedule_done(const codend::Schedule& schedule);

}  // namespace binding
