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
  blend,        ///< layers of this kind are averaged by weight
  add_to_rest,  ///< the clip's difference from the rest pose is added to the average (add_pose.h)
  add_to_start  ///< the clip's difference from its own pose at time 0 is added to the average
};

/// One clip playing at one time, with a weight.
struct ClipLayer {
  std::uint32_t clip = 0;  ///< index into the clips that the plan was compiled for
  double time_s = 0.0;
  float weight = 1.0f;         ///< >= 0; additive layers subtract below 0 (add_pose.h)
  std::uint32_t mask = kNone;  ///< a mask that multiplies `weight`: an index into Needs::in.masks, continued by the
                               ///< masks of FrameInput::program_inputs
  LayerKind kind = LayerKind::blend;
  bool mirrored = false;  ///< the clip plays with left and right exchanged, its morph weights too (Needs::in.mirror).
                          ///< Masks weigh joints of the mirrored pose; properties are not mirrored
  const Clip* page = nullptr;  ///< a part of `clip` that has the keys of time_s (paging/paged_clip.h), sampled instead
                               ///< of `clip`. It must stay unchanged while frames get this layer. Null: `clip` itself.
                               ///< With a Needs::out.skeleton_lod it is a page with only the joints of that LOD
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
  double time_s = 0.0;  ///< on the source's clock; the caller wraps the time of a loop (playback_clock.h)
  float weight = 1.0f;  ///< [0, 1]; at 0 the source is not called

  bool plays() const noexcept { return source.is_there() && weight > 0.0f; }
};

/// True if both inputs give the same vertices, bit for bit, assuming that their sources are loaded.
inline bool same_geometry(const GeometryInput& a, const GeometryInput& b) noexcept {
  if (!a.plays() || !b.plays()) return a.plays() == b.plays();
  return a.source.content == b.source.content && a.source.space == b.source.space && same_bits(a.time_s, b.time_s) &&
         same_bits(a.weight, b.weight);
}

/// The state of a character in one frame. All numbers must be finite, weights and the root below 1e9. Without layers
/// the character has its rest pose. Layers of LayerKind::blend are averaged by weight; if their weights sum to less
/// than 1, the rest pose takes the remaining weight. Additive layers are then added in their order. A layer of weight 0
/// counts as absent.
struct FrameInput {
  std::span<const ClipLayer> layers;
  std::span<const float> weights;  ///< [W] replaces all morph weights; empty = weights from the clips, or else the rest
                                   ///< weights. Correctives add to them in both cases
  /// World transform above all root joints. Results are float: 16 km from the origin they lie on a grid of 2 mm, and
  /// vertices are off by a few such steps. Keep the root near the origin, relative to the camera or a local origin, and
  /// add that origin to the results in double.
  Affine root;
  std::span<const ClipLayer> next_layers = {};  ///< layers of a later time; ignored while `interpolation_factor` is 0
  /// [0, 1] part of the way from the pose of `layers` to the pose of `next_layers`. Each of the two is evaluated once
  /// as long as its layers stay the same. Other values than 0 need Needs::in.between_updates. A program does the same
  /// by laying one `cached` pose over another.
  float interpolation_factor = 0.0f;
  /// [instances] 1 = the mesh instance is out of view: it is neither morphed, skinned, bounded nor decoded. Joints and
  /// weights are evaluated all the same. Empty = all are in view.
  std::span<const std::uint8_t> out_of_view = {};
  /// [Needs::in.cached_instances] the source that plays in each of these mesh instances; empty = no source plays
  std::span<const GeometryInput> geometry = {};
  /// A pose program that makes the pose instead of `layers`, which must be empty then. It must fit Needs::in.program.
  /// Its clip and mask indices refer to the plan; the masks of `program_inputs` are numbered after those of the plan.
  /// Empty = the layers make the pose.
  PoseProgramSpan program = {};
  /// Poses, joints and masks of the caller that the program names by index. With a SkeletonLod, poses and joints are
  /// those that it keeps (pose_joint). Layers may name the masks, too. With masks, both poses that
  /// `interpolation_factor` mixes are evaluated in every frame.
  PoseProgramInputs program_inputs = {};
  bool asleep = false;  ///< no stage runs and the result is empty. Clocks, events and root motion are not part of
                        ///< frames, so they go on
};

}  // namespace sinew
