// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/index.h"
#include "runtime/pose_program/pose_slots.h"
#include "runtime/pose_program/run_pose_program.h"

namespace sinew {

/// Runs operations one by one on the poses of a memory. The caller has checked them. Internal to the runtime.
class PoseMachine {
 public:
  /// Settings for one operation beyond the fields of PoseOp.
  struct Step {
    std::uint32_t clip = kNone;   ///< if not kNone, replaces PoseOp::index, whose 16 bits are too few for layers
    const Clip* page = nullptr;   ///< the part of the clip with its keys, as in PoseProgramInputs::pages
    bool with_properties = true;  ///< a later operation reads the properties of the result
    bool holds_clip = false;      ///< as PoseProgramJob::holds_clip
    std::uint32_t kept = 0;       ///< kept operations: place of the numbers that they keep (PoseSlots::kept)
    bool kept_stands = false;     ///< the kept numbers are still valid, and the operands were skipped
  };

  /// Keeps references to the arguments.
  /// in   rest  replaces the rest pose of `assets`;   root  world transform above all root joints
  PoseMachine(const PoseProgramAssets& assets, const PoseSpan& rest, const PoseProgramInputs& inputs,
              const Affine& root, const PoseSlots& slots, PoseProgramWork& work, PosePhaseClock clock) noexcept
      : assets_(assets), inputs_(inputs), root_(root), rest_(rest), slots_(slots), work_(work), clock_(clock) {}

  void run(const PoseOp& op, const Step& step) noexcept;
  /// Counts an operation that an earlier machine has already run on this memory.
  void skip(const PoseOp& op) noexcept;

  /// The topmost pose; there must be one.
  PoseSlot top() const noexcept { return slots_.slot(depth_ - 1); }

 private:
  void ended(PosePhase phase) const noexcept {
    if (clock_.ended != nullptr) clock_.ended(clock_.context, phase);
  }
  /// The slot, without properties if the current operation does not need them.
  PoseSlot slot(std::size_t index) const noexcept {
    PoseSlot slot = slots_.slot(index);
    if (!step_.with_properties) slot.properties = {};
    return slot;
  }
  PoseMask mask(std::uint8_t index) const noexcept;

  void push_rest() noexcept;
  void push_external(std::size_t index) noexcept;
  void sample(const PoseOp& op, const PoseSlot& to, bool holds_clip) noexcept;
  void push_mirrored_sample(const PoseOp& op) noexcept;
  void push_mirrored_rest() noexcept;
  void mirror(const PoseSpan& from, std::span<const float> weights, const PoseSlot& to) noexcept;
  void mean(std::size_t operands, double threshold) noexcept;
  void blend_masked(std::span<const BlendLayer> layers, std::span<float> PoseSlot::*numbers,
                    std::span<const float> PoseMask::*masks, std::span<const float> rest) noexcept;
  void overlay(bool in_model_space) noexcept;
  void add_to_rest(DeltaFrame frame) noexcept;
  void add_to_reference(DeltaFrame frame) noexcept;
  void add(const PoseSlot& layer, const PoseShare& share, const PoseSpan& reference,
           std::span<const float> reference_weights, DeltaFrame frame) noexcept;
  void override_top(const PoseOp& op) noexcept;
  void run_procedure(const PoseOp& op) noexcept;
  void inertialize(const PoseOp& op) noexcept;
  void dead_blend(const PoseOp& op) noexcept;
  void cache_top() noexcept;

  const PoseProgramAssets& assets_;
  const PoseProgramInputs& inputs_;
  const Affine& root_;
  PoseSpan rest_;
  PoseSlots slots_;
  PoseProgramWork& work_;
  PosePhaseClock clock_;
  Step step_;              // settings of the current operation
  std::size_t depth_ = 0;  // poses on the stack
};

}  // namespace sinew
