// SPDX-License-Identifier: MIT
#include "importer/tool/batch/in_order.h"

#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <memory>
#include <utility>

namespace sinew::tool {
namespace {

struct Item {
  std::size_t index = 0;
  JobOutcome outcome;
};
using ItemPointer = std::shared_ptr<Item>;  // a filter copies what it passes on

}  // namespace

void run_in_order(std::size_t count, std::size_t jobs, const std::function<JobOutcome(std::size_t)>& work,
                  const std::function<void(std::size_t, JobOutcome&&)>& show) {
  std::size_t next = 0;
  const auto begin =
      tbb::make_filter<void, ItemPointer>(tbb::filter_mode::serial_in_order, [&](tbb::flow_control& flow) {
        if (next < count) return std::make_shared<Item>(Item{next++, {}});
        flow.stop();
        return ItemPointer();
      });
  // Isolated: a thread that waits for others inside one file must not begin a second file meanwhile.
  const auto run = tbb::make_filter<ItemPointer, ItemPointer>(tbb::filter_mode::parallel, [&](ItemPointer item) {
    tbb::this_task_arena::isolate([&] { item->outcome = work(item->index); });
    return item;
  });
  const auto end = tbb::make_filter<ItemPointer, void>(
      tbb::filter_mode::serial_in_order, [&](const ItemPointer& item) { show(item->index, std::move(item->outcome)); });
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, std::max<std::size_t>(jobs, 1));
  tbb::task_arena arena(static_cast<int>(jobs));
  arena.execute([&] { tbb::parallel_pipeline(kWaitingPerJob * jobs, begin & run & end); });
}

}  // namespace sinew::tool
