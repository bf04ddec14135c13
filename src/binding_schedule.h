// The engine's schedule from that of a tow, which is an R list.
#pragma once

#include "binding_numbers.h"
#include "engine/march/schedule.hpp"

namespace binding {

codend::Schedule read_schedule(const list& from);

// What of a schedule has followed from the motion so far, as an R list.
writable::list schedule_done(const codend::Schedule& schedule);

}  // namespace binding
