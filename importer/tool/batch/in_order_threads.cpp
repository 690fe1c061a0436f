// SPDX-License-Identifier: MIT
#include <algorithm>
#include <condition_variable>
#include <exception>
#include <map>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "importer/tool/batch/in_order.h"

namespace sinew::tool {
namespace {

/// One call of run_in_order(). The mutex guards the numbers and the waiting outcomes.
class OrderedRun {
 public:
  OrderedRun(std::size_t count, std::size_t most_outcomes, std::size_t most_bytes,
             const std::function<JobOutcome(std::size_t)>& work,
             const std::function<void(std::size_t, JobOutcome&&)>& show)
      : count_(count), most_outcomes_(most_outcomes), most_bytes_(most_bytes), work_(work), show_(show) {}

  /// Works until no work is left. Every thread calls it.
  void help() noexcept {
    std::unique_lock lock(mutex_);
    while (begin_next(lock)) {
      const std::size_t index = next_++;
      lock.unlock();
      JobOutcome outcome;
      std::exception_ptr fault;
      try {
        outcome = work_(index);
      } catch (...) {
        fault = std::current_exception();
      }
      lock.lock();
      if (fault && !fault_) fault_ = fault;
      bytes_ += text_of(outcome);
      waiting_.emplace(index, std::move(outcome));
      if (!showing_) show_those_ready(lock);
    }
  }

  void rethrow() const {
    if (fault_) std::rethrow_exception(fault_);
  }

 private:
  static std::size_t text_of(const JobOutcome& outcome) { return outcome.results.size() + outcome.messages.size(); }

  /// Waits until outcomes have room; the thread that shows them makes room.   out   false: no work is left
  bool begin_next(std::unique_lock<std::mutex>& lock) {
    const auto ended = [&] { return next_ == count_ || fault_; };
    room_.wait(lock, [&] { return ended() || (next_ - shown_ < most_outcomes_ && bytes_ <= most_bytes_); });
    return !ended();
  }

  void show_those_ready(std::unique_lock<std::mutex>& lock) {
    showing_ = true;
    while (!fault_ && !waiting_.empty() && waiting_.begin()->first == shown_) {
      JobOutcome outcome = std::move(waiting_.extract(waiting_.begin()).mapped());
      const std::size_t bytes = text_of(outcome), index = shown_;
      lock.unlock();
      std::exception_ptr fault;
      try {
        show_(index, std::move(outcome));
      } catch (...) {
        fault = std::current_exception();
      }
      lock.lock();
      if (fault) fault_ = fault;
      bytes_ -= bytes;
      ++shown_;
      room_.notify_all();
    }
    showing_ = false;
    room_.notify_all();
  }

  const std::size_t count_, most_outcomes_, most_bytes_;
  const std::function<JobOutcome(std::size_t)>& work_;
  const std::function<void(std::size_t, JobOutcome&&)>& show_;
  std::mutex mutex_;
  std::condition_variable room_;
  std::map<std::size_t, JobOutcome> waiting_;
  std::size_t next_ = 0, shown_ = 0, bytes_ = 0;
  bool showing_ = false;
  std::exception_ptr fault_;
};

}  // namespace

std::size_t cores_to_use() { return std::max(std::thread::hardware_concurrency(), 1u); }

void run_in_order(std::size_t count, std::size_t jobs, const std::function<JobOutcome(std::size_t)>& work,
                  const std::function<void(std::size_t, JobOutcome&&)>& show, std::size_t most_waiting_bytes) {
  OrderedRun run(count, kWaitingPerJob * jobs, most_waiting_bytes, work, show);
  std::vector<std::jthread> others(std::min(jobs, std::max<std::size_t>(count, 1)) - 1);
  for (std::jthread& other : others) other = std::jthread([&] { run.help(); });
  run.help();
  for (std::jthread& other : others) other.join();
  run.rethrow();
}

}  // namespace sinew::tool
