// SPDX-License-Identifier: MIT
#include "runtime/pose_program/run_pose_program.h"

#include <algorithm>

#include "runtime/pose_program/pose_machine.h"
#include "runtime/pose_program/read_properties.h"

namespace sinew {

std::size_t pose_program_bytes(const PoseProgramAssets& assets, const PoseProgramRoom& room) noexcept {
  return PoseSlotLayout(assets, room).bytes;
}

void run_unchecked(const PoseProgramJob& job) noexcept {
  PoseProgramWork uncounted;
  const PoseSlotLayout layout(*job.assets, room_of(job.program));
  const PoseSlots slots(layout, job.memory.data(), {job.pose, job.weights, job.properties});
  PoseMachine machine(*job.assets, job.assets->rest, job.inputs, job.root, slots,
                      job.work != nullptr ? *job.work : uncounted, job.clock);
  const ReadProperties properties(job.program, !job.properties.empty());
  const std::span<const Clip* const> pages = job.inputs.pages;
  const std::size_t end = std::min(job.end, job.program.size());
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < end; ++i) {
    if (i < job.first)
      machine.skip(job.program[i]);
    else
      machine.run(job.program[i], {.page = pages.empty() ? nullptr : pages[i],
                                   .with_properties = properties.of(i),
                                   .holds_clip = job.holds_clip && i == 0,
                                   .kept = kept});
    if (kept_operands_of(job.program[i]) > 0) ++kept;
  }
}

}  // namespace sinew
