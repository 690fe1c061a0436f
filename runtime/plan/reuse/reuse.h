// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <span>

#include "runtime/plan/reuse/what_stands.h"
#include "runtime/pose_program/standing_operands.h"

namespace sinew {

/// Knows which parts of earlier frames stand in this one. The constructor compares the inputs. Then evaluate/ reports
/// each part that it made, and asks which of the parts that follow from it stand. A new part gets the number of this
/// frame, a part that stands keeps the number of the frame that made it. Internal to plan/.
class Reuse {
 public:
  /// The last run into some memory.
  struct Run {
    FrameMemory memory;
    const LastInput& input;
  };

  /// in   tables  of the frame's memory, which are kept by reference
  ///      last    run into the frame's memory;   before  the character's last run, perhaps the same
  ///      had_it  had_same_input of the last run
  ///      number  FrameResult::frame of this frame
  Reuse(const CompiledPlan& plan, const FrameInput& input, const FrameTables& tables, const Run& last,
        const Run& before, bool had_it, std::uint64_t number) noexcept;
  /// Of a frame whose input does not say what its pose is: nothing stands by comparing inputs.
  Reuse(const CompiledPlan& plan, const FrameTables& tables, const Run& last, const Run& before,
        std::uint64_t number) noexcept;
  Reuse(const Reuse&) = delete;
  Reuse& operator=(const Reuse&) = delete;

  const WhatStands& stands() const noexcept { return stands_; }
  std::uint64_t number() const noexcept { return number_; }
  /// Of the frame's memory.
  const FrameTables& tables() const noexcept { return tables_; }

  /// The program of the last run, whose kept operands the memory has; empty where they do not fit this input.
  LastProgram last_program(const FrameInput& input) const noexcept;

  /// Copies the pose of these layers into place `update` of FrameLayout::updates, from wherever earlier frames have it.
  /// out  false: no frame has it
  bool find_update(std::size_t update, std::span<const ClipLayer> layers) const noexcept;
  /// The place `update` has the pose of these layers.
  void keep_update(std::size_t update, std::span<const ClipLayer> layers) const noexcept;

  /// The palette in the memory is that of this frame.
  bool palette_stands(std::size_t skin) const noexcept;
  void keep_palette(std::size_t skin) const noexcept;
  /// The character's palette in the frame before; empty where it had none.
  std::span<const JointMatrix> palette_before(std::size_t skin) const noexcept;
  /// Records a palette that was just computed.
  /// in   as_before  it has the bits of palette_before
  /// out  true if the frame's memory held the same palette already: its split and combined matrices are still valid
  bool add_palette(std::size_t skin, std::span<const JointMatrix> palette, bool as_before) const noexcept;

  /// Reports the morph weights and the winding of an instance.
  void add_instance(std::size_t instance, std::span<const float> weights, bool mirrored) const noexcept;
  /// Reports what an instance of Needs::in.cached_instances plays.
  void add_geometry(std::size_t slot, const PlayedGeometry& played) const noexcept;

  /// Nobody sees what the instance plays.
  void forget_geometry(std::size_t slot) const noexcept { tables_.geometry_since[slot] = 0; }

  /// The frame since which all that the vertices of a primitive follow is as it is now.
  std::uint64_t vertices_since(const PrimitivePlan& planned) const noexcept;
  /// The vertices in the memory are those of this frame.
  /// in   since  vertices_since
  bool vertices_stand(std::size_t primitive, std::uint64_t since) const noexcept {
    return since != number_ && since == tables_.primitives[primitive].since_frame;
  }
  /// The box in the memory is that of this frame.
  bool box_stands(std::size_t instance, const Affine& world_from_mesh) const noexcept;

  /// Keeps the morph weights of the frame, which the next one is compared with.
  void add_weights(std::span<const float> weights) const noexcept;

  /// Where all stands: gives all parts the numbers that they have in this frame.
  /// cost compares palettes with those of the frame before, where that had another input
  void keep_all() const noexcept;
  /// The character falls asleep: nothing will stand for its next frame.
  void forget_all() const noexcept;

 private:
  const CompiledPlan& plan_;
  FrameMemory memory_, memory_before_;
  const FrameTables& tables_;
  std::optional<FrameTables> other_tables_;  // of the run before, where that was into other memory
  const FrameTables& before_;
  std::uint64_t number_;
  WhatStands stands_;
  const LastInput* last_input_ = nullptr;  // null: nothing stands by comparing inputs
};

}  // namespace sinew
