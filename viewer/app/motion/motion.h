// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "runtime/model/scene.h"
#include "runtime/plan/frame_input.h"
#include "runtime/plan/needs.h"
#include "runtime/procedures/springs/springs_procedure.h"
#include "viewer/app/motion/graph_player.h"
#include "viewer/app/motion/motion_settings.h"

namespace sinew::viewer {

/// The tables that a motion needs in a plan. Plans must be compiled again when it changes.
struct MotionShape {
  bool writes_program = false;  ///< false: the chosen clip plays alone, as FrameInput::layers
  bool mirrors = false;
  std::vector<std::uint32_t> masks;  ///< joints of the layers' masks, each once
  std::size_t layer_count = 0;

  friend bool operator==(const MotionShape&, const MotionShape&) = default;
};

MotionShape shape_of(const MotionSettings& settings, const CharacterRig* rig);

/// Adds the needs of a motion of this shape.
void add_motion_needs(const MotionShape& shape, const Scene& scene, const CharacterRig* rig, Needs& needs);

/// A moment of the chosen clip.
struct MotionMoment {
  std::uint32_t clip = kNone;        ///< kNone = the rest pose
  double time_s = 0.0;               ///< in the clip; for a graph, since its start
  double turns = 0.0;                ///< rounds of the clip that were played before
  double dt_s = 0.0;                 ///< since the moment before, for springs; 0 holds them
  std::uint32_t faded_clip = kNone;  ///< the clip that fades out
  double faded_time_s = 0.0;
  float fade = 1.0f;  ///< [0, 1] how far `clip` has faded in
};

/// The moment at which a clip that repeats has played for this long. A time exactly at its end is not wrapped.
MotionMoment moment_at(const Scene& scene, std::uint32_t clip, double played_s);

/// Writes the pose program of a character: the chosen clip or the graph, layers on top, then springs, constraints and
/// expressions. Also places the character by its root motion.
class Motion {
 public:
  /// in   scene, rig  must outlive this; rig may be null
  Motion(const Scene& scene, std::shared_ptr<const CharacterRig> rig, MotionSettings settings);

  /// True if the settings are more than a clip that plays alone. Otherwise write() may not be called.
  bool writes_program() const noexcept { return shape_.writes_program; }
  const MotionShape& shape() const noexcept { return shape_; }
  const MotionSettings& settings() const noexcept { return settings_; }
  const std::shared_ptr<const CharacterRig>& rig() const noexcept { return rig_; }

  /// Changes weights and values, or everything: then the plan needs needs of the new shape.
  void set(const MotionSettings& settings);

  bool has_springs() const noexcept { return rig_ && rig_->has_procedures() && settings_.springs; }

  /// Puts springs at rest in the pose of the next moment.
  void reset_springs() noexcept { springs_.event = SpringEvent::reset; }

  /// Sets program, program inputs and root of a frame. They refer to this object, and stay valid until the next call.
  void write(const MotionMoment& moment, FrameInput& input);

  /// True if springs still swing, so that the next frame differs even if the moment does not.
  bool is_swinging() const noexcept;

  GraphPlayer* graph() noexcept { return graph_ ? &*graph_ : nullptr; }
  PoseProgramSpan program() const noexcept { return program_.ops(); }

 private:
  double layer_time_s(const MotionMoment& moment, std::uint32_t clip) const noexcept;
  std::uint8_t mask_of(const LayerSetting& layer) const noexcept;
  void write_base(const MotionMoment& moment);
  void write_layer(const MotionMoment& moment, const LayerSetting& layer);
  Affine root_at(const MotionMoment& moment);
  static void run_procedures(void* context, const ProcedurePose& pose);

  const Scene* scene_;
  std::shared_ptr<const CharacterRig> rig_;
  MotionSettings settings_;
  MotionShape shape_;
  std::optional<GraphPlayer> graph_;
  PoseProgram program_;
  SpringsContext springs_;
  std::vector<std::uint64_t> spring_state_, spring_scratch_;
  std::vector<float> expressions_, expression_weights_;
  PoseProcedure procedure_;
};

}  // namespace sinew::viewer
