// SPDX-License-Identifier: MIT
#include "importer/tool/batch/in_order.h"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <utility>

namespace sinew::tool {
namespace {

struct Item {
  std::size_t index = 0;
  JobOutcome outcome;
};
using ItemPointer = std::shared_ptr<Item>;  // shared, since a filter copies what it passes on

/// The size of the texts of waiting outcomes. A thread that would begin new work waits while it is too large, as long
/// as other threads work. One of these threads makes the outcome that all others wait for.
class WaitingText {
 public:
  explicit WaitingText(std::size_t most_bytes) : most_bytes_(most_bytes) {}

  void wait_for_room() {
    constexpr std::chrono::milliseconds kLongWait{
        100};  // no other thread shows outcomes: this one does it after its work
    std::unique_lock lock(mutex_);
    while (bytes_ > most_bytes_)
      if (room_.wait_for(lock, kLongWait) == std::cv_status::timeout && working_ == 0) break;
    ++working_;
  }
  void finish(const JobOutcome& outcome) {
    const std::lock_guard lock(mutex_);
    bytes_ += outcome.results.size() + outcome.messages.size();
    --working_;
    room_.notify_one();
  }
  void show(const JobOutcome& outcome) {
    const std::lock_guard lock(mutex_);
    bytes_ -= outcome.results.size() + outcome.messages.size();
    room_.notify_one();
  }

 private:
  const std::size_t most_bytes_;
  std::mutex mutex_;
  std::condition_variable room_;
  std::size_t bytes_ = 0, working_ = 0;
};

}  // namespace

std::size_t cores_to_use() { return static_cast<std::size_t>(tbb::info::default_concurrency()); }

void run_in_order(std::size_t count, std::size_t jobs, const std::function<JobOutcome(std::size_t)>& work,
                  const std::function<void(std::size_t, JobOutcome&&)>& show, std::size_t most_waiting_bytes) {
  std::size_t next = 0;
  WaitingText waiting(most_waiting_bytes);
  const auto begin =
      tbb::make_filter<void, ItemPointer>(tbb::filter_mode::serial_in_order, [&](tbb::flow_control& flow) {
        if (next == count) {
          flow.stop();
          return ItemPointer();
        }
        waiting.wait_for_room();
        return std::make_shared<Item>(Item{next++, {}});
      });
  // Isolated: a thread that waits for others inside one file must not begin a second file meanwhile.
  const auto run = tbb::make_filter<ItemPointer, ItemPointer>(tbb::filter_mode::parallel, [&](ItemPointer item) {
    tbb::this_task_arena::isolate([&] { item->outcome = work(item->index); });
    waiting.finish(item->outcome);
    return item;
  });
  const auto end = tbb::make_filter<ItemPointer, void>(tbb::filter_mode::serial_in_order, [&](const ItemPointer& item) {
    waiting.show(item->outcome);
    show(item->index, std::move(item->outcome));
  });
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, std::max<std::size_t>(jobs, 1));
  tbb::task_arena arena(static_cast<int>(jobs));
  arena.execute([&] { tbb::parallel_pipeline(kWaitingPerJob * jobs, begin & run & end); });
}

}  // namespace sinew::tool
