#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>

namespace codend {

// Threads that BlockLU can make use of here: 2, or 1 on a machine or in a share of one with one core.
int usable_threads();

// A thread that waits to take over half of a job; it sleeps in between.
class SecondThread {
 public:
  SecondThread() : thread_([this] { work(); }) {}
  ~SecondThread();
  SecondThread(const SecondThread&) = delete;
  SecondThread& operator=(const SecondThread&) = delete;

  // Runs job(data, 0) here and job(data, 1) there; returns when both are done. Neither may throw.
  // Both treat denormal numbers as the calling thread does.
  void run(void (*job)(void* data, int half), void* data);

 private:
  void work();

  std::mutex mutex_;
  std::condition_variable changed_;
  void (*job_)(void* data, int half) = nullptr;  // null when there is nothing to do
  void* data_ = nullptr;
  std::uint64_t control_ = 0;  // of the caller's floating-point unit
  bool over_ = false;
  std::thread thread_;
};

}  // namespace codend
