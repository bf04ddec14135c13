#include "second_thread.hpp"

#include "flushed_denormals.hpp"

namespace codend {

int usable_threads() {
  static const int threads = std::thread::hardware_concurrency() > 1 ? 2 : 1;
  return threads;
}

SecondThread::~SecondThread() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    over_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void SecondThread::run(void (*job)(void* data, int half), void* data) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    job_ = job;
    data_ = data;
    control_ = floating_point_control();
  }
  changed_.notify_all();
  job(data, 0);
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait(lock, [this] { return job_ == nullptr; });
}

void SecondThread::work() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return job_ != nullptr || over_; });
    if (over_) return;
    lock.unlock();
    set_floating_point_control(control_);
    job_(data_, 1);
    lock.lock();
    job_ = nullptr;
    changed_.notify_all();
  }
}

}  // namespace codend
