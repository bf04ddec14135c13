// How often operator new has been called in this program so far.
#pragma once

namespace codend {

long allocation_count();

}  // namespace codend
