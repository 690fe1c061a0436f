// SPDX-License-Identifier: MIT
#pragma once
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "runtime/base/api.h"
#include "runtime/base/result.h"
#include "runtime/math/affine.h"
#include "runtime/plan/frame_block.h"
#include "runtime/plan/frame_result.h"

namespace sinew {

struct CutPose;
struct FrameInput;
class Plan;
struct Refusal;

/// The two functions of std::pmr::memory_resource that a frame buffer calls. Including <memory_resource> would cost
/// every source file that runs frames 8,000 lines more.
template <class Memory>
concept BlockMemory = requires(Memory& memory, void* block) {
  { memory.allocate(std::size_t{}, std::size_t{}) } -> std::same_as<void*>;
  memory.deallocate(block, std::size_t{}, std::size_t{});
};

/// The input of a frame buffer's last run. Its arrays lie in the buffer's block; here are their sizes and all other
/// members. Internal to plan/.
struct LastInput {
  bool is_known = false;  ///< the block holds the arrays of that input, and the pose that it gave
  bool asleep = false;    ///< the character slept in the last run, so the pose in the block is older
  bool is_late = false;   ///< a vertex source had not loaded its frame, so the same input may give other vertices
  float interpolation_factor = 0.0f;
  std::size_t layer_count = 0, next_layer_count = 0, weight_count = 0, op_count = 0, version_count = 0;
  Affine root;
};

/// The memory of a frame: one block of Plan::frame_bytes() bytes, made once and reused every frame. It holds the result
/// and the input of its last run. Nothing else is ever allocated for a character. The buffer keeps its plan and the
/// scene alive, even if the Plan object is destroyed or gets another plan.
class SINEW_API FrameBuffer {
 public:
  static constexpr std::size_t kAlignment = 64;  ///< alignment of the block in bytes

  /// Takes the block from operator new, or from `memory`, which must outlive the buffer. `memory` is a
  /// std::pmr::memory_resource, or another type with the two functions of BlockMemory.
  explicit FrameBuffer(const Plan& plan);
  template <BlockMemory Memory>
  FrameBuffer(const Plan& plan, Memory& memory)
      : FrameBuffer(plan, {.context = &memory,
                           .allocate =
                               [](void* context, std::size_t byte_count) {
                                 return static_cast<Memory*>(context)->allocate(byte_count, kAlignment);
                               },
                           .deallocate =
                               [](void* context, void* block, std::size_t byte_count) {
                                 static_cast<Memory*>(context)->deallocate(block, byte_count, kAlignment);
                               }}) {}

  /// Uses the caller's block: at least Plan::frame_bytes() bytes at a multiple of kAlignment, which must outlive the
  /// buffer.
  FrameBuffer(const Plan& plan, std::span<std::byte> block);

  FrameBuffer(FrameBuffer&&) noexcept = default;
  FrameBuffer& operator=(FrameBuffer&&) noexcept = default;

  const FrameResult& result() const noexcept { return result_; }

  /// Size of the block that the buffer allocated; 0 if it uses the caller's block.
  std::size_t owned_bytes() const noexcept { return block_.owned_bytes(); }

  /// Loads the memory that the next run touches first into the caches, without waiting. In a crowd, call it for the
  /// next character while this one runs. It pays where all buffers together exceed the caches.
  void prefetch() const noexcept;

  /// Makes runs write vertices past the caches (SkinLinearJob::past_caches). Worth it for results that no code reads
  /// soon: a crowd larger than the caches, or memory that the GPU reads. The bits are the same.
  void write_past_caches(bool past_caches) noexcept { past_caches_ = past_caches; }

  /// Sets the frame number: the next run makes FrameResult::frame = `last_frame` + 1. Frame numbers of one character
  /// must rise.
  void count_from(std::uint64_t last_frame) noexcept { result_.frame = last_frame; }

  /// For a character with several buffers: the next run into this buffer follows the run into `before`. Parts that did
  /// not change are found by comparison with it. `before` must be of the same plan, and stay unchanged until that run
  /// has ended.
  void follow(const FrameBuffer& before) noexcept { before_ = &before; }

 private:
  friend ErrorCode run_plan(const Plan&, const FrameInput&, FrameBuffer&) noexcept;
  friend std::string why_refused(const Plan&, const FrameInput&, const FrameBuffer&);
  friend Refusal check_buffers(const Plan&, const FrameBuffer&, const FrameBuffer*) noexcept;
  friend ErrorCode run_to_cut(const Plan&, const FrameInput&, FrameBuffer&, CutPose&, std::size_t) noexcept;
  friend ErrorCode run_from_cut(const Plan&, const FrameInput&, FrameBuffer&) noexcept;
  friend bool holds_result_of(const FrameBuffer&, const FrameInput&) noexcept;

  struct SINEW_API Source {
    void* context;
    void* (*allocate)(void* context, std::size_t byte_count);
    FrameBlock::Deallocate deallocate;
  };
  FrameBuffer(const Plan& plan, const Source& memory);

  FrameBuffer(const Plan& plan, FrameBlock block);

  PlanShare plan_;
  FrameBlock block_;
  const FrameBuffer* before_ = nullptr;
  bool past_caches_ = false;
  LastInput last_;
  PoseSpan cut_pose_;  // of a frame whose second half has not run; has no memory if there is no such frame
  std::size_t cut_ops_ = 0;
  FrameResult result_;
};

}  // namespace sinew
