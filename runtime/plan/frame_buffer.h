// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <memory_resource>
#include <span>

#include "runtime/base/result.h"
#include "runtime/plan/compile_plan.h"
#include "runtime/plan/frame_input.h"
#include "runtime/plan/frame_result.h"

namespace sinew {

struct FrameTables;
enum class StandingJoints : std::uint8_t;

/// Memory that one frame runs into: one block of Plan::frame_bytes bytes, made once and reused every frame. Nothing
/// else is ever allocated for a character.
class FrameBuffer {
 public:
  static constexpr std::size_t kAlignment = 64;  ///< of the block

  /// Takes the block from `memory`, which must outlive the buffer, or from operator new.
  explicit FrameBuffer(const Plan& plan) : FrameBuffer(plan, *std::pmr::new_delete_resource()) {}
  FrameBuffer(const Plan& plan, std::pmr::memory_resource& memory);

  /// Uses the caller's block: at least Plan::frame_bytes bytes at a multiple of kAlignment, which must outlive the
  /// buffer.
  FrameBuffer(const Plan& plan, std::span<std::byte> block);

  FrameBuffer(FrameBuffer&&) noexcept = default;
  FrameBuffer& operator=(FrameBuffer&&) noexcept = default;

  const FrameResult& result() const noexcept { return result_; }

  /// The result is that of this input: running it again would do nothing (P19).
  bool holds_result_of(const Plan& plan, const FrameInput& input) const noexcept;

  /// Asks for what the next run touches first, without waiting for it: for a crowd, while the character before it runs.
  /// Where all together exceed the caches, poses take up to a third less time, and those of a small crowd as long as
  /// without.
  void prefetch(const Plan& plan) const noexcept;

  /// The next run gives frame `last_frame` + 1. Frames of one character must count up.
  void count_from(std::uint64_t last_frame) noexcept { result_.frame = last_frame; }

  /// For a character that takes turns with several buffers: the next run into this one follows the one into `before`,
  /// so that what has not changed is told by comparison with it. `before` must be there, unchanged, during that run.
  void follow(const FrameBuffer& before) noexcept { before_ = &before; }

 private:
  friend ErrorCode run_plan(const Plan&, const FrameInput&, FrameBuffer&) noexcept;
  struct GiveBack {
    std::pmr::memory_resource* memory = nullptr;  // null: the caller's block
    std::size_t byte_count = 0;
    void operator()(std::byte* block) const noexcept;
  };
  FrameBuffer(const Plan& plan, std::unique_ptr<std::byte, GiveBack> block);
  // `tables`: of this buffer's own memory.
  bool holds_result_of(const FrameTables& tables, const FrameInput& input) const noexcept;
  StandingJoints standing(const Plan& plan, const FrameTables& tables, const FrameInput& input) const noexcept;
  bool holds_clip(const FrameTables& tables, const FrameInput& input) const noexcept;
  void keep(const FrameTables& tables, const FrameInput& input) noexcept;

  const Scene* scene_ = nullptr;   // the rest pose in the memory is this scene's
  std::uint64_t fingerprint_ = 0;  // of the plan
  std::unique_ptr<std::byte, GiveBack> block_;
  const FrameBuffer* before_ = nullptr;
  bool keeps_input_ = false;  // the block has the input of its last run as well, and whatever that gave
  std::size_t layer_count_ = 0, weight_count_ = 0, ahead_count_ = 0;
  float interpolation_factor_ = 0.0f;
  bool asleep_ = false;  // in the last run: the joints in the block are of another one
  Affine root_;
  FrameResult result_;
};

}  // namespace sinew
