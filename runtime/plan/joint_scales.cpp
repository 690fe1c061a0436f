// SPDX-License-Identifier: MIT
#include "runtime/plan/joint_scales.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "runtime/clip/clip_layout.h"
#include "runtime/math/determinant_sign.h"

namespace sinew {
namespace {

int sign_of(double x) noexcept { return (x > 0.0) - (x < 0.0); }

/// The scales that one joint has in rest pose, constants and keys.
class SeenScales {
 public:
  void add(const std::array<float, 3>& scale) noexcept {
    const bool even = scale[0] == scale[1] && scale[0] == scale[2];
    seen_.kind = std::max(seen_.kind, !even ? ScaleKind::uneven : scale[0] == 1.0f ? ScaleKind::none : ScaleKind::even);
    const std::array<int, 3> signs = {sign_of(scale[0]), sign_of(scale[1]), sign_of(scale[2])};
    if (!any_) {
      first_ = scale;
      signs_ = signs;
      any_ = true;
      seen_.sign = signs[0] * signs[1] * signs[2];
    }
    varies_ |= scale != first_;
    seen_.may_change |= signs != signs_;
  }
  void add_anything() noexcept {
    seen_.kind = ScaleKind::uneven;
    seen_.may_change = true;
  }
  /// In a mirrored layer a joint gets the scales of its partner, along other axes.
  void add_mirrored(const SeenScales& partner, bool copies) noexcept {
    if (!partner.any_) return;
    const bool is_plain = copies && partner.seen_.kind != ScaleKind::uneven && seen_.kind != ScaleKind::uneven;
    if (!is_plain && !(partner.is_one() && is_one())) return add_anything();
    seen_.kind = std::max(seen_.kind, partner.seen_.kind);
    seen_.may_change |= partner.seen_.may_change || partner.signs_ != signs_;
    varies_ |= partner.varies_ || partner.first_ != first_;
  }
  JointScale result(bool additive) const noexcept {
    JointScale seen = seen_;
    seen.may_change |= additive && varies_;
    return seen;
  }

 private:
  bool is_one() const noexcept { return any_ && seen_.kind == ScaleKind::none; }

  JointScale seen_;
  std::array<float, 3> first_ = {};
  std::array<int, 3> signs_ = {};
  bool any_ = false, varies_ = false;
};

void add_keys(const TrackBlock& block, std::size_t key_count, std::vector<SeenScales>& scales) {
  const bool has_other_keys =
      key_count == 1;  // its other keys are in pages (paging/cut_clip.h): a whole clip folds tracks of one key
  const bool keeps_range = !has_other_keys && block.packed.empty() &&
                           (block.interpolation == Interpolation::step || block.interpolation == Interpolation::linear);
  for (std::size_t lane = 0; lane < block.lane_count; ++lane) {
    SeenScales& seen = scales[block.targets[lane]];
    if (!keeps_range) seen.add_anything();
    for (std::size_t key = 0; key < key_count && keeps_range; ++key)
      seen.add({block.plane(key, block.value_plane)[lane], block.plane(key, block.value_plane + 1)[lane],
                block.plane(key, block.value_plane + 2)[lane]});
  }
}

/// Adds the scales that no track moves: those of the clip, and with `with_shared` the rest values that clips share.
void add_constants(const BaseNumbers& base, bool with_shared, std::vector<SeenScales>& scales) {
  const std::size_t stride = BasePose::stride_for(scales.size());
  const std::size_t first = first_plane(Property::scale) * stride;
  for (std::size_t j = 0; j < scales.size() && with_shared; ++j) {
    const std::vector<float>& rest = *base.rest();
    scales[j].add({rest[first + j], rest[first + stride + j], rest[first + 2 * stride + j]});
  }
  for (const BaseNumbers::Override& value : base.overrides()) {
    if (value.at < first) continue;
    const std::size_t at = first + value.at % stride;
    scales[value.at % stride].add({base[at], base[at + stride], base[at + 2 * stride]});
  }
}

bool copies_scale(const MirroredJoint& joint) noexcept {
  return std::all_of(joint.scale.begin(), joint.scale.end(),
                     [](const MirrorRow<3>& row) { return copied_entry(row) != 0; });
}

void add_mirrored(const MirrorMap& map, std::vector<SeenScales>& scales) {
  const std::vector<SeenScales> by_clips = scales;
  for (std::size_t j = 0; j < scales.size(); ++j)
    scales[j].add_mirrored(by_clips[map.joints[j].source], copies_scale(map.joints[j]));
}

/// The scale of each joint by itself, without the joints above it.
std::vector<SeenScales> own_scales(const PlanAssets& assets) {
  std::vector<SeenScales> scales(assets.joint_count());
  for (std::size_t j = 0; j < scales.size(); ++j) {
    const glm::vec3 rest = assets.skeleton->rest[j].scale;
    scales[j].add({rest.x, rest.y, rest.z});
  }
  const RestNumbers* added = nullptr;  // rest values that were added; most clips share them
  for (const Clip& clip : assets.clips) {
    const ClipLayout& layout = clip.layout();
    add_constants(layout.base_pose, added == nullptr || *added != layout.base_pose.rest(), scales);
    added = &layout.base_pose.rest();
    for (const TimeGroup& group : layout.groups)
      for (const TrackBlock& block : group.blocks)
        if (block.property == Property::scale) add_keys(block, group.times.key_count(), scales);
  }
  if (assets.mirror != nullptr) add_mirrored(*assets.mirror, scales);
  return scales;
}

}  // namespace

std::vector<JointScale> joint_scales(const PlanAssets& assets, bool additive) {
  const Skeleton& skeleton = *assets.skeleton;
  const std::vector<SeenScales> own = own_scales(assets);
  std::vector<JointScale> all;
  for (std::size_t j = 0; j < own.size(); ++j) {
    JointScale scale = own[j].result(additive);
    if (const std::uint32_t fixed = skeleton.fixed_matrix_of[j]; fixed != kNone) {
      const Affine& matrix = skeleton.fixed_matrices[fixed];
      scale = {scale_kind(matrix), determinant_sign(matrix), false};
    }
    if (const std::uint32_t parent = skeleton.parents[j]; parent != kNone) {
      scale.kind = std::max(scale.kind, all[parent].kind);
      scale.sign *= all[parent].sign;
      scale.may_change |= all[parent].may_change;
    }
    all.push_back(scale);
  }
  return all;
}

ScaleKind scale_kind(const Affine& m) noexcept {
  constexpr double kTolerance = 1e-5;
  const Affined d = affine_cast<double>(m);
  const auto column = [&](int c) { return Vec3<double>(d.row[0][c], d.row[1][c], d.row[2][c]); };
  const double size = glm::dot(column(0), column(0));
  bool even = true;
  for (int c = 0; c < 3; ++c) {
    even = even && std::abs(glm::dot(column(c), column(c)) - size) <= kTolerance * size;
    even = even && std::abs(glm::dot(column(c), column((c + 1) % 3))) <= kTolerance * size;
  }
  if (!even) return ScaleKind::uneven;
  return std::abs(size - 1.0) <= kTolerance && determinant_sign(m) > 0 ? ScaleKind::none : ScaleKind::even;
}

}  // namespace sinew
