// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>

#include "runtime/base/api.h"

namespace sinew {

struct CompiledPlan;
class Plan;

/// Shared ownership of a compiled plan: the bytes of a std::shared_ptr, which only frame_buffer.cpp constructs and
/// destroys. Including <memory> here would cost every source file that runs frames 15,000 lines more. Internal to
/// plan/.
class SINEW_API PlanShare {
 public:
  explicit PlanShare(const Plan& plan) noexcept;
  PlanShare(PlanShare&& other) noexcept;
  PlanShare& operator=(PlanShare&& other) noexcept;
  ~PlanShare();

  const CompiledPlan* get() const noexcept { return plan_; }  ///< null after a move from it
  const CompiledPlan& operator*() const noexcept { return *plan_; }
  const CompiledPlan* operator->() const noexcept { return plan_; }
  bool operator==(std::nullptr_t) const noexcept { return plan_ == nullptr; }

 private:
  const CompiledPlan* plan_;
  alignas(void*) std::byte shared_[2 * sizeof(void*)];
};

/// The memory of a frame buffer. The destructor returns it to the allocator that it came from. Internal to plan/.
class FrameBlock {
 public:
  using Deallocate = void (*)(void* context, void* block, std::size_t byte_count);

  explicit FrameBlock(std::byte* callers) noexcept : start_(callers) {}
  FrameBlock(std::byte* start, std::size_t byte_count, void* context, Deallocate deallocate) noexcept
      : start_(start), byte_count_(byte_count), context_(context), deallocate_(deallocate) {}
  FrameBlock(FrameBlock&& other) noexcept { *this = static_cast<FrameBlock&&>(other); }
  FrameBlock& operator=(FrameBlock&& other) noexcept;
  ~FrameBlock() {
    if (deallocate_ != nullptr) deallocate_(context_, start_, byte_count_);
  }

  std::byte* get() const noexcept { return start_; }
  std::size_t owned_bytes() const noexcept { return byte_count_; }

 private:
  std::byte* start_ = nullptr;
  std::size_t byte_count_ = 0;
  void* context_ = nullptr;
  Deallocate deallocate_ = nullptr;  // null: the caller's block
};

}  // namespace sinew
