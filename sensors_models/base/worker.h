// A thread that does what it is given, in order.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <mutex>
#include <thread>

namespace drydock {

/// One thread of its own, for what must always happen on the same thread (OpenGL) or may happen
/// beside something else. Destruction waits for what was submitted.
class Worker {
 public:
  Worker();
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Queues `task`. The future becomes ready when it is done and rethrows what it threw.
  std::future<void> Submit(std::function<void()> task);
  /// Submits `task` and waits for it.
  void Run(std::function<void()> task) { Submit(std::move(task)).get(); }

 private:
  void Work();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::packaged_task<void()>> tasks_;
  bool closing_ = false;
  std::thread thread_;  ///< Last, so that it starts when everything else is there.
};

}  // namespace drydock
