// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "runtime/base/index.h"
#include "runtime/base/same_bits.h"
#include "runtime/math/affine.h"
#include "runtime/plan/vertex_source.h"
#include "runtime/pose_program/pose_program.h"
#include "runtime/pose_program/program_inputs.h"

namespace sinew {

class Clip;

/// How a layer enters the pose.
enum class LayerKind : std::uint8_t {
  blend,        ///< these layers are averaged
  add_to_rest,  ///< the clip's difference from the rest pose is added to that mean (add_pose.h)
  add_to_start  ///< the clip's difference from its own first instant is added
};

/// One clip playing at one time, with a weight.
struct ClipLayer {
  std::uint32_t clip = 0;  ///< index into the clips that the plan was compiled for
  double time_s = 0.0;
  float weight = 1.0f;
  std::uint32_t mask = kNone;  ///< index into Needs::in.masks: joint weights that multiply `weight`. Morph weights and
                               ///< properties have no mask
  LayerKind kind = LayerKind::blend;
  bool mirrored = false;  ///< the clip plays with left and right exchanged, its morph weights too (Needs::in.mirror).
                          ///< Masks weigh joints of the mirrored pose; properties are not mirrored
  const Clip* page = nullptr;  ///< a part of `clip` with the keys of time_s (paging/paged_clip.h), which is sampled in
                               ///< its place. It stays unchanged while frames get this layer. Null: `clip` itself.
                               ///< With a Needs::out.skeleton_lod it is a page for that plan, of fewer joints
};

/// True if both lists of layers give the same pose, bit for bit. Numbers are compared by their bits: the two zeros
/// differ. Pages are not compared, since all pages that have the keys of a time give the same bits.
inline bool same_layers(std::span<const ClipLayer> a, std::span<const ClipLayer> b) noexcept {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const ClipLayer &x = a[i], &y = b[i];
    if (x.clip != y.clip || !same_bits(x.time_s, y.time_s) || !same_bits(x.weight, y.weight) || x.mask != y.mask ||
        x.kind != y.kind || x.mirrored != y.mirrored)
      return false;
  }
  return true;
}

/// A mesh instance whose vertices come from a source in place of its pose.
/// eq   x = (1 - weight) x_pose + weight x_source in world space; normals and tangents likewise, then normalised.
///      Where the mesh is unskinned and the source is in mesh space, both are blended there.
///      At weight 1 the mesh is neither morphed nor skinned: InstanceResult::world_from_mesh is FrameInput::root, or
///      the joint's world matrix for VertexSpace::mesh, and vertices are those of the source, bit for bit.
struct GeometryInput {
  VertexSource source;  ///< none = the instance does not play
  double time_s = 0.0;  ///< on the source's clock; a clock that loops is the caller's (playback_clock.h)
  float weight = 1.0f;  ///< [0, 1]; at 0 the source is not asked for anything

  bool plays() const noexcept { return source.is_there() && weight > 0.0f; }
};

/// True if both inputs give the same vertices, bit for bit, assuming that their sources are loaded.
inline bool same_geometry(const GeometryInput& a, const GeometryInput& b) noexcept {
  if (!a.plays() || !b.plays()) return a.plays() == b.plays();
  return a.source.content == b.source.content && a.source.space == b.source.space && same_bits(a.time_s, b.time_s) &&
         same_bits(a.weight, b.weight);
}

/// The state of a character in one frame. All numbers must be finite, weights and the root below 1e9. No layers = the
/// rest pose (also when the scene has no clips at all). Layers that blend are averaged by weight. Where their weights
/// sum to less than 1, the rest pose has the rest of the weight. A layer of weight 0 counts as absent. Layers that add
/// follow in their order.
struct FrameInput {
  std::span<const ClipLayer> layers;
  std::span<const float> weights;  ///< [W] replaces all morph weights; empty = from the clips, else rest.
                                   ///< Correctives add to either
  /// Placed above all root joints. Results are float: 16 km out they lie on a grid of 2 mm, and vertices are off by
  /// some steps of it. Keep it near, relative to the camera or a local origin, and place results in double.
  Affine root;
  std::span<const ClipLayer> next_layers = {};  ///< layers of a later time; ignored while `interpolation_factor` is 0
  /// [0, 1] part of the way from the pose of `layers` to the pose of `next_layers`. Each of the two is evaluated once
  /// as long as its layers stay the same. Other values than 0 need Needs::in.between_updates.
  float interpolation_factor = 0.0f;
  /// [instances] 1 = the mesh instance is out of view: it is neither morphed, skinned, bounded nor decoded. Joints and
  /// weights are evaluated all the same. Empty = all are in view.
  std::span<const std::uint8_t> out_of_view = {};
  /// [Needs::in.cached_instances] what plays in each of them; empty = nothing does
  std::span<const GeometryInput> geometry = {};
  /// Makes the pose in place of `layers`, which must be empty then; within Needs::in.program. Clips and masks are those
  /// of the plan; masks of `program_inputs` follow them. Empty = the layers make it.
  PoseProgramSpan program = {};
  /// Poses, joints and masks of the caller that the program names by index. With a SkeletonLod, poses and joints are
  /// those that it keeps (pose_joint).
  PoseProgramInputs program_inputs = {};
  bool asleep = false;  ///< no stage runs and the result is empty. Clocks, events and root motion lie outside of frames
                        ///< and go on
};

}  // namespace sinew
