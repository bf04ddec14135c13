// Returns the number of calls of operator new in this program so far.
#pragma once

namespace codend {

long allocation_count();

}  // namespace codend
