#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>

namespace codend {

// Number of threads for BlockLU: 2, or 1 with a single core.
int usable_threads();

// A thread that runs one half of a job and sleeps between jobs.
class SecondThread {
 public:
  SecondThread() : thread_([this] { work(); }) {}
  ~SecondThread();
  SecondThread(const SecondThread&) = delete;
  SecondThread& operator=(const SecondThread&) = delete;

  // Runs job(data, 0) here and job(data, 1) on the second thread, and returns after both. They must
  // not throw. Both use the caller's treatment of denormal numbers.
  void run(void (*job)(void* data, int half), void* data);

 private:
  void work();

  std::mutex mutex_;
  std::condition_variable changed_;
  void (*job_)(void* data, int half) = nullptr;  // null without a job
  void* data_ = nullptr;
  std::uint64_t control_ = 0;  // control word of the caller's floating-point unit
  bool over_ = false;
  std::thread thread_;
};

}  // namespace codend
