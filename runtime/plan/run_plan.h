// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "runtime/base/result.h"
#include "runtime/plan/compile_plan.h"
#include "runtime/plan/frame_result.h"

namespace sinew {

/// One clip playing at one time, with a blend weight.
struct ClipLayer {
  std::uint32_t clip = 0;
  double time_s = 0.0;
  float weight = 1.0f;
};

/// What to evaluate. No layers = rest pose (also when the scene has no clips at all).
struct FrameInput {
  std::span<const ClipLayer> layers;
  std::span<const float> weights;      ///< [W] replaces all morph weights; empty = from the clips, else rest
  Affine root;                         ///< placed above all root joints
};

/// Memory that one frame runs into: the plan's block and the result tables. Allocated once, reused every frame.
class FrameBuffer {
 public:
  explicit FrameBuffer(const Plan& plan);
  FrameBuffer(FrameBuffer&&) noexcept = default;
  FrameBuffer& operator=(FrameBuffer&&) noexcept = default;

  const FrameResult& result() const noexcept { return result_; }

 private:
  friend ErrorCode run_plan(const Plan&, const FrameInput&, FrameBuffer&) noexcept;
  struct FreeAligned { void operator()(std::byte* p) const noexcept; };
  std::unique_ptr<std::byte, FreeAligned> memory_;
  std::vector<InstanceResult> instances_;
  std::vector<DeformedPrimitive> primitives_;
  FrameResult result_;
};

/// Runs every stage of the plan for one character; afterwards `frame.result()` holds the outcome.
/// err  index_out_of_range (clip), size_mismatch (weights, or a frame buffer of another plan), not_finite (layer time or weight)
/// cost the sum of the plan's stages, no allocation; the same input gives the same bits
ErrorCode run_plan(const Plan& plan, const FrameInput& input, FrameBuffer& frame) noexcept;

}  // namespace sinew
