// SPDX-License-Identifier: MIT
#include "runtime/plan/frame_buffer.h"

#include <algorithm>
#include <cstring>
#include <memory>
#include <memory_resource>
#include <new>
#include <utility>

#include "runtime/base/contract.h"
#include "runtime/base/prefetch.h"
#include "runtime/clip/clip_layout.h"
#include "runtime/plan/evaluate/visibility.h"
#include "runtime/plan/frame_tables.h"

namespace sinew {
namespace {

std::byte* large_enough(std::span<std::byte> block, std::size_t byte_count) noexcept {
  CONTRACT(block.size() >= byte_count);
  return block.data();
}

/// Starts the lifetime of the tables in memory that is all zeros.
void construct_tables(const CompiledPlan& plan, FrameMemory memory) noexcept {
  const FrameTables tables(plan, memory);
  std::uninitialized_value_construct(tables.instances.begin(), tables.instances.end());
  for (std::size_t p = 0; p < plan.primitives.size(); ++p)
    std::construct_at(&tables.primitives[p], nothing_deformed(plan.primitives[p]));
  std::uninitialized_value_construct(tables.palettes.begin(), tables.palettes.end());
  std::uninitialized_value_construct(tables.input_layers.begin(), tables.input_layers.end());
  std::uninitialized_value_construct(tables.input_program.begin(), tables.input_program.end());
  std::uninitialized_value_construct(tables.shown.begin(), tables.shown.end());
  std::uninitialized_value_construct(tables.played.begin(), tables.played.end());
  std::uninitialized_value_construct(tables.input_geometry.begin(), tables.input_geometry.end());
  if (!plan.interpolate) return;
  std::uninitialized_value_construct(tables.input_next_layers.begin(), tables.input_next_layers.end());
  std::uninitialized_value_construct(tables.updates.begin(), tables.updates.end());
  for (const Block<ClipLayer>& block : plan.layout.tables.update_layers) {
    const std::span<ClipLayer> layers = memory.of(block);
    std::uninitialized_value_construct(layers.begin(), layers.end());
  }
}

/// Rotations are rounded as in clips, so that a joint that rests has the same bits with any clip and without.
void write_rest_pose(const CompiledPlan& plan, FrameMemory memory) noexcept {
  const Skeleton& skeleton = *plan.assets.skeleton;
  const PoseSpan rest = memory.of(plan.layout.rest_pose);
  for (std::size_t j = 0; j < rest.stride; ++j) {
    Transform local = j < rest.joint_count ? skeleton.rest[j] : Transform{};
    local.rotation = without_tiny(local.rotation);
    rest.set(j, local);
  }
}

}  // namespace

using SharedPlan = std::shared_ptr<const CompiledPlan>;

PlanShare::PlanShare(const Plan& plan) noexcept : plan_(plan.compiled().get()) {
  static_assert(sizeof(SharedPlan) <= sizeof shared_ && alignof(SharedPlan) <= alignof(void*));
  new (shared_) SharedPlan(plan.compiled());
}

PlanShare::PlanShare(PlanShare&& other) noexcept : plan_(std::exchange(other.plan_, nullptr)) {
  new (shared_) SharedPlan(std::move(*std::launder(reinterpret_cast<SharedPlan*>(other.shared_))));
}

PlanShare& PlanShare::operator=(PlanShare&& other) noexcept {
  plan_ = other.plan_;
  *std::launder(reinterpret_cast<SharedPlan*>(shared_)) =
      std::move(*std::launder(reinterpret_cast<SharedPlan*>(other.shared_)));
  if (&other != this) other.plan_ = nullptr;
  return *this;
}

PlanShare::~PlanShare() { std::destroy_at(std::launder(reinterpret_cast<SharedPlan*>(shared_))); }

FrameBlock& FrameBlock::operator=(FrameBlock&& other) noexcept {
  if (&other == this) return *this;
  if (deallocate_ != nullptr) deallocate_(context_, start_, byte_count_);
  start_ = std::exchange(other.start_, nullptr);
  byte_count_ = std::exchange(other.byte_count_, 0);
  context_ = other.context_;
  deallocate_ = std::exchange(other.deallocate_, nullptr);
  return *this;
}

FrameBuffer::FrameBuffer(const Plan& plan) : FrameBuffer(plan, *std::pmr::new_delete_resource()) {}

FrameBuffer::FrameBuffer(const Plan& plan, const Source& memory)
    : FrameBuffer(plan, FrameBlock(static_cast<std::byte*>(memory.allocate(memory.context, plan.frame_bytes())),
                                   plan.frame_bytes(), memory.context, memory.deallocate)) {}

FrameBuffer::FrameBuffer(const Plan& plan, std::span<std::byte> block)
    : FrameBuffer(plan, FrameBlock(large_enough(block, plan.frame_bytes()))) {}

FrameBuffer::FrameBuffer(const Plan& plan, FrameBlock block) : plan_(plan), block_(std::move(block)) {
  CONTRACT(reinterpret_cast<std::uintptr_t>(block_.get()) % kAlignment == 0);
  const FrameMemory memory{block_.get()};
  std::memset(memory.start, 0, plan_->layout.frame_bytes);
  construct_tables(*plan_, memory);
  write_rest_pose(*plan_, memory);
  if (plan_->hide) find_hidden(*plan_->scene, {}, memory.of(plan_->layout.hidden));
}

void FrameBuffer::prefetch() const noexcept {
  constexpr std::size_t kMostBytes = 24 * 1024;  // a part of the nearest cache: the running character needs the rest
  sinew::prefetch(block_.get(), std::min(plan_->layout.front_bytes, kMostBytes));
}

}  // namespace sinew
