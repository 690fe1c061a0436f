// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <memory_resource>
#include <span>
#include <string>

#include "runtime/base/result.h"
#include "runtime/math/affine.h"
#include "runtime/plan/compile_plan.h"
#include "runtime/plan/frame_result.h"

namespace sinew {

struct FrameInput;
struct Refusal;

/// The input of a frame buffer's last run, but for the arrays, which are in its block. Internal to plan/.
struct LastInput {
  bool is_known = false;  ///< the block has the arrays, and the pose that they gave
  bool asleep = false;    ///< the pose in the block is of an earlier run
  bool is_late = false;   ///< a source had not loaded its frame yet, so the same input may show another one
  float interpolation_factor = 0.0f;
  std::size_t layer_count = 0, next_layer_count = 0, weight_count = 0;
  Affine root;
};

/// The memory of a frame: one block of Plan::frame_bytes() bytes, made once and reused every frame. It holds the result
/// and the input of its last run. Nothing else is ever allocated for a character. The buffer keeps its plan and the
/// scene alive, also when the plan's handle goes or is assigned anew.
class FrameBuffer {
 public:
  static constexpr std::size_t kAlignment = 64;  ///< of the block

  /// Takes the block from `memory`, which must outlive the buffer, or from operator new.
  explicit FrameBuffer(const Plan& plan) : FrameBuffer(plan, *std::pmr::new_delete_resource()) {}
  FrameBuffer(const Plan& plan, std::pmr::memory_resource& memory);

  /// Uses the caller's block: at least Plan::frame_bytes() bytes at a multiple of kAlignment, which must outlive the
  /// buffer.
  FrameBuffer(const Plan& plan, std::span<std::byte> block);

  FrameBuffer(FrameBuffer&&) noexcept = default;
  FrameBuffer& operator=(FrameBuffer&&) noexcept = default;

  const FrameResult& result() const noexcept { return result_; }

  /// Size of the block that the buffer took; 0 for the caller's own.
  std::size_t owned_bytes() const noexcept { return block_ != nullptr ? block_.get_deleter().byte_count : 0; }

  /// Loads the memory that the next run touches first into the caches, without waiting. In a crowd, call it for the
  /// next character while this one runs. It pays where all buffers together exceed the caches.
  void prefetch() const noexcept;

  /// Makes runs write vertices past the caches (SkinLinearJob::past_caches). Worth it for results that no code reads
  /// soon: a crowd larger than the caches, or memory that the GPU reads. The bits are the same.
  void write_past_caches(bool past_caches) noexcept { past_caches_ = past_caches; }

  /// The next run gives frame `last_frame` + 1. Frames of one character must count up.
  void count_from(std::uint64_t last_frame) noexcept { result_.frame = last_frame; }

  /// For a character with several buffers: the next run into this buffer follows the run into `before`. Parts that did
  /// not change are found by comparison with it. `before` must be of the same plan, and stay unchanged until that run
  /// has ended.
  void follow(const FrameBuffer& before) noexcept { before_ = &before; }

 private:
  friend ErrorCode run_plan(const Plan&, const FrameInput&, FrameBuffer&) noexcept;
  friend std::string why_refused(const Plan&, const FrameInput&, const FrameBuffer&);
  friend Refusal check_run(const Plan&, const FrameInput&, const FrameBuffer&, const FrameBuffer*) noexcept;
  friend bool holds_result_of(const FrameBuffer&, const FrameInput&) noexcept;

  struct GiveBack {
    std::pmr::memory_resource* memory = nullptr;  // null: the caller's block
    std::size_t byte_count = 0;
    void operator()(std::byte* block) const noexcept;
  };
  FrameBuffer(const Plan& plan, std::unique_ptr<std::byte, GiveBack> block);

  std::shared_ptr<const CompiledPlan> plan_;  // null: moved from
  std::unique_ptr<std::byte, GiveBack> block_;
  const FrameBuffer* before_ = nullptr;
  bool past_caches_ = false;
  LastInput last_;
  FrameResult result_;
};

}  // namespace sinew
