// Limits the memory of this process, which R cannot do.

#include <cpp11.hpp>
#ifndef _WIN32
#include <sys/resource.h>
#endif

// Limits the address space of this process to `bytes`; larger allocations fail. Returns true if the
// system supports this.
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
