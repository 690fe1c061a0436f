// SPDX-License-Identifier: MIT
#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

#include "runtime/threads/default_executor.h"

namespace sinew {
namespace {

/// One call of run_in_parallel. The pool's mutex guards the numbers.
struct Loop {
  const std::function<void(std::size_t)>& body;
  std::size_t count = 0, next = 0, running = 0;
};

/// One thread less than the machine has cores. They end with the process, and nobody joins them. On Windows a shared
/// library that joins threads while it is unloaded waits for ever.
class ThreadPool {
 public:
  ThreadPool() {
    const unsigned cores = std::max(std::thread::hardware_concurrency(), 2u);
    for (unsigned i = 1; i < cores; ++i) std::thread([this] { help(); }).detach();
  }

  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  void run(std::size_t count, const std::function<void(std::size_t)>& body) {
    Loop loop{body, count, 0, 0};
    std::unique_lock lock(mutex_);
    open_.push_back(&loop);
    work_came_.notify_all();
    while (loop.next < count) run_one(loop, lock);
    item_ended_.wait(lock, [&] { return loop.running == 0; });
  }

 private:
  /// Runs one item without the lock. The last item taken closes the loop for others.
  void run_one(Loop& loop, std::unique_lock<std::mutex>& lock) {
    const std::size_t item = loop.next++;
    if (loop.next == loop.count) std::erase(open_, &loop);
    ++loop.running;
    lock.unlock();
    loop.body(item);
    lock.lock();
    if (--loop.running == 0 && loop.next == loop.count) item_ended_.notify_all();
  }

  void help() {
    std::unique_lock lock(mutex_);
    for (;;) {
      work_came_.wait(lock, [&] { return !open_.empty(); });
      run_one(*open_.front(), lock);
    }
  }

  std::mutex mutex_;
  std::condition_variable work_came_, item_ended_;
  std::vector<Loop*> open_;  // loops with items that no thread has taken yet
};

}  // namespace

void run_in_parallel(std::size_t count, const std::function<void(std::size_t)>& body) {
  if (count == 0) return;
  static ThreadPool& pool = *new ThreadPool;  // never destroyed; ThreadPool says why
  pool.run(count, body);
}

}  // namespace sinew
