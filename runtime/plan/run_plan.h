// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "runtime/base/result.h"
#include "runtime/jobs/blend_poses.h"
#include "runtime/plan/compile_plan.h"
#include "runtime/plan/frame_result.h"

namespace sinew {

/// How a layer enters the pose: averaged with its like, or added on top of their mean (add_pose.h), as far as the clip differs
/// from the rest pose or from its own first instant.
enum class LayerKind : std::uint8_t { blend, add_to_rest, add_to_start };

/// One clip playing at one time, with a weight.
struct ClipLayer {
  std::uint32_t clip = 0;
  double time_s = 0.0;
  float weight = 1.0f;
  std::uint32_t mask = kNone;          ///< index into Needs::masks: joint weights that multiply `weight`. Morph weights have none
  LayerKind kind = LayerKind::blend;
};

/// What to evaluate. No layers = rest pose (also when the scene has no clips at all). Layers are averaged by weight,
/// where the weights sum to less than 1 the rest pose fills up; a layer of weight 0 is as good as absent. Layers that add
/// follow in their order.
struct FrameInput {
  std::span<const ClipLayer> layers;
  std::span<const float> weights;      ///< [W] replaces all morph weights; empty = from the clips, else rest.
                                       ///< Correctives add to either
  Affine root;                         ///< placed above all root joints
};

/// Memory that one frame runs into: the plan's block and the result tables. Allocated once, reused every frame.
class FrameBuffer {
 public:
  explicit FrameBuffer(const Plan& plan);
  FrameBuffer(FrameBuffer&&) noexcept = default;
  FrameBuffer& operator=(FrameBuffer&&) noexcept = default;

  const FrameResult& result() const noexcept { return result_; }

  /// The next run gives frame `last_frame` + 1, for a character that takes turns with several buffers.
  void count_from(std::uint64_t last_frame) noexcept { result_.frame = last_frame; }

 private:
  friend ErrorCode run_plan(const Plan&, const FrameInput&, FrameBuffer&) noexcept;
  struct FreeAligned { void operator()(std::byte* p) const noexcept; };
  const Scene* scene_ = nullptr;         // the rest pose in the memory is this scene's
  std::size_t byte_count_ = 0;
  std::unique_ptr<std::byte, FreeAligned> memory_;
  std::vector<InstanceResult> instances_;
  std::vector<DeformedPrimitive> primitives_;
  std::vector<BlendLayer> layers_;
  FrameResult result_;
};

/// Runs every stage of the plan for one character; afterwards `frame.result()` holds the outcome.
/// err  index_out_of_range (clip, mask); size_mismatch (weights, more layers than Needs::max_layers, or a frame buffer of
///      another plan); not_finite (layer time or weight, morph weight); unsupported (a layer of negative weight, of weight
///      below 1 in a plan without blending, or one that adds without Needs::additive). After an error the frame buffer still holds its last good frame.
/// cost the sum of the plan's stages, no allocation; the same input gives the same bits
ErrorCode run_plan(const Plan& plan, const FrameInput& input, FrameBuffer& frame) noexcept;

}  // namespace sinew
