// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <span>

#include "runtime/plan/reuse/what_stands.h"
#include "runtime/pose_program/standing_operands.h"

namespace sinew {

/// Decides which results of earlier frames are still valid in this frame: such a part *stands*. The constructor
/// compares the inputs. Then evaluate/ reports each part that it computed, and asks which dependent parts stand. A new
/// part gets the number of this frame. A part that stands keeps the number of the frame that computed it. Internal to
/// plan/.
class Reuse {
 public:
  /// The last run that used some frame memory.
  struct Run {
    FrameMemory memory;
    const LastInput& input;
  };

  /// For a frame that runs as a whole: compares its input with the inputs of earlier frames.
  /// in   tables  of the frame's memory, which are kept by reference
  ///      last    run into the frame's memory;   before  the character's last run, perhaps the same
  ///      had_it  had_same_input of the last run
  ///      number  FrameResult::frame of this frame
  Reuse(const CompiledPlan& plan, const FrameInput& input, const FrameTables& tables, const Run& last,
        const Run& before, bool had_it, std::uint64_t number) noexcept;
  /// For the halves of a cut frame. The caller changes the pose between them, so comparing inputs shows nothing.
  Reuse(const CompiledPlan& plan, const FrameTables& tables, const Run& last, const Run& before,
        std::uint64_t number) noexcept;
  Reuse(const Reuse&) = delete;
  Reuse& operator=(const Reuse&) = delete;

  const WhatStands& stands() const noexcept { return stands_; }
  std::uint64_t number() const noexcept { return number_; }
  /// The tables in the frame's memory.
  const FrameTables& tables() const noexcept { return tables_; }

  /// The program of the last run, if the memory holds kept operands that fit this input; else empty.
  LastProgram last_program(const FrameInput& input) const noexcept;

  /// Copies the pose of these layers to place `update` of FrameLayout::updates, if this memory or that of the last
  /// frame holds it.
  /// out  false: neither memory holds it
  bool find_update(std::size_t update, std::span<const ClipLayer> layers) const noexcept;
  /// Records that place `update` holds the pose of these layers.
  void keep_update(std::size_t update, std::span<const ClipLayer> layers) const noexcept;

  /// Call it if place `update` holds a pose that no later frame may use.
  void forget_update(std::size_t update) const noexcept { tables_.updates[update].is_there = false; }

  /// True if the palette in the memory is valid for this frame.
  bool palette_stands(std::size_t skin) const noexcept;
  void keep_palette(std::size_t skin) const noexcept;
  /// The character's palette of the frame before; empty if there was none.
  std::span<const JointMatrix> palette_before(std::size_t skin) const noexcept;
  /// Records a palette that was just computed.
  /// in   as_before  the palette has the bits of palette_before
  /// out  true if the frame's memory held the same palette already: its split and combined matrices are still valid
  bool add_palette(std::size_t skin, std::span<const JointMatrix> palette, bool as_before) const noexcept;

  /// Reports the morph weights and the winding of an instance.
  void add_instance(std::size_t instance, std::span<const float> weights, bool mirrored) const noexcept;
  /// Reports the geometry that a cached instance (Needs::in.cached_instances) plays.
  void add_geometry(std::size_t slot, const PlayedGeometry& played) const noexcept;

  /// Call it for an instance out of view: nothing is known about its geometry afterwards.
  void forget_geometry(std::size_t slot) const noexcept { tables_.geometry_since[slot] = 0; }

  /// Number of the newest frame that changed an input of the primitive's vertices.
  std::uint64_t vertices_since(const PrimitivePlan& planned) const noexcept;
  /// True if the vertices in the memory are valid for this frame.
  /// in   since  vertices_since
  bool vertices_stand(std::size_t primitive, std::uint64_t since) const noexcept {
    return since != number_ && since == tables_.primitives[primitive].since_frame;
  }
  /// True if the box in the memory is valid for this frame.
  bool box_stands(std::size_t instance, const Affine& world_from_mesh) const noexcept;

  /// Keeps the morph weights of the frame, for comparison with those of the next frame.
  void add_weights(std::span<const float> weights) const noexcept;

  /// Call it if all parts stand: gives each part the number that it has in this frame.
  /// cost O(instances). Also compares palettes with those of the frame before, if that frame had another input
  void keep_all() const noexcept;
  /// The character falls asleep: no part will stand in its next frame.
  void forget_all() const noexcept;

 private:
  const CompiledPlan& plan_;
  FrameMemory memory_, memory_before_;
  const FrameTables& tables_;
  std::optional<FrameTables> other_tables_;  // tables of the character's last run, if that used other memory
  const FrameTables& before_;
  std::uint64_t number_;
  WhatStands stands_;
  const LastInput* last_input_ = nullptr;  // null: inputs were not compared
};

}  // namespace sinew
