// What R cannot do with its own process: bound the memory that it may take.

#include <cpp11.hpp>
#ifndef _WIN32
#include <sys/resource.h>
#endif

// From here on this process gets at most so many bytes of address space; what asks for more fails.
// Returns whether the system does that.
[[cpp11::register]] bool limit_memory(double bytes) {
#ifdef _WIN32
  return false;
#else
  rlimit limit;
  if (getrlimit(RLIMIT_AS, &limit) != 0) return false;
  const rlim_t most = static_cast<rlim_t>(bytes);
  if (limit.rlim_max != RLIM_INFINITY && limit.rlim_max < most) return true;
  limit.rlim_cur = limit.rlim_max = most;
  return setrlimit(RLIMIT_AS, &limit) == 0;
#endif
}
