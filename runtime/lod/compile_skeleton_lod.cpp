// SPDX-License-Identifier: MIT
#include "runtime/lod/compile_skeleton_lod.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "runtime/animation/truth_pose.h"
#include "runtime/base/contract.h"
#include "runtime/base/same_bits.h"
#include "runtime/compress/clip_error.h"
#include "runtime/compress/virtual_vertices.h"
#include "runtime/plan/run_plan.h"
#include "runtime/pose/pose_memory.h"
#include "runtime/pose/sample_clip.h"

namespace sinew {
namespace {

struct Moment {
  std::uint32_t clip = kNone;
  double time_s = 0.0;
};

std::vector<Moment> moments_of(const Scene& scene, std::span<const std::uint32_t> clips) {
  std::vector<std::uint32_t> played(clips.begin(), clips.end());
  for (std::uint32_t c = 0; clips.empty() && c < scene.clips.size(); ++c) played.push_back(c);
  if (played.empty()) played.push_back(kNone);
  std::vector<Moment> moments;
  for (const std::uint32_t clip : played) {
    CONTRACT(clip == kNone || clip < scene.clips.size());
    if (clip == kNone)
      moments.push_back({});
    else
      for (const double time_s : times_to_check(scene.animations[clip], scene.skeleton.joint_count()))
        moments.push_back({clip, time_s});
  }
  const std::size_t step = moments.size() * scene.skeleton.joint_count() / kMaxLodPoses + 1;
  std::vector<Moment> some;
  for (std::size_t i = 0; i < moments.size(); i += step) some.push_back(moments[i]);
  return some;
}

/// Poses of the scene as frames compute them; in double from the local transforms on.
class Poses {
 public:
  explicit Poses(const Scene& scene)
      : local(scene.skeleton.joint_count()), model(local.size()), scene_(scene), memory_(local.size()) {}

  void evaluate(const Moment& moment) {
    const PoseSpan pose = memory_.span();
    if (moment.clip != kNone)
      run_unchecked(
          SampleClipJob{.clip = &scene_.clips[moment.clip], .time_s = moment.time_s, .pose = pose, .weights = {}});
    for (std::size_t j = 0; j < local.size(); ++j)
      local[j] = in_double(moment.clip == kNone ? scene_.skeleton.rest[j] : pose.get(j));
    model_from_local(scene_.skeleton, local, model);
  }

  std::vector<Transformd> local;  // [J]
  std::vector<Affined> model;     // [J]

 private:
  const Scene& scene_;
  PoseMemory memory_;
};

/// Mean local transform of each joint. A joint that never changes keeps its transform bit for bit.
std::vector<Transform> mean_locals(const Scene& scene, std::span<const Moment> moments, Poses& poses) {
  std::vector<Transformd> first, sum;
  std::vector<bool> changes(scene.skeleton.joint_count(), false);
  for (const Moment& moment : moments) {
    poses.evaluate(moment);
    if (first.empty()) {
      first = sum = poses.local;
      continue;
    }
    for (std::size_t j = 0; j < sum.size(); ++j) {
      const Transformd& now = poses.local[j];
      changes[j] = changes[j] || !same_bits(now, first[j]);
      sum[j].translation += now.translation;
      sum[j].scale += now.scale;
      sum[j].rotation = sum[j].rotation + aligned_with(first[j].rotation, now.rotation);
    }
  }
  std::vector<Transform> means;
  for (std::size_t j = 0; j < sum.size(); ++j) {
    const double share = 1.0 / static_cast<double>(moments.size());
    const Transformd mean =
        changes[j] ? Transformd{share * sum[j].translation, normalised(sum[j].rotation), share * sum[j].scale}
                   : first[j];
    means.push_back({glm::vec3(mean.translation), quat_cast<float>(mean.rotation), glm::vec3(mean.scale)});
  }
  return means;
}

/// A joint that may be left out together with its descendants.
struct Branch {
  std::vector<std::uint32_t> joints;  // parents first
  std::size_t moments = 0;            // number of moments at which it was within the tolerance
  double worst_m = 0.0;
  std::uint32_t worst_joint = kNone;
};

class Pruner {
 public:
  Pruner(const Scene& scene, std::span<const Moment> moments)
      : scene_(scene),
        moments_(moments),
        vertices_(virtual_vertices(scene)),
        poses_(scene),
        children_(scene.skeleton.joint_count()),
        needed_(children_.size(), false),
        held_(mean_locals(scene, moments, poses_)),
        held_affines_(affines_of(held_)),
        held_model_(children_.size()) {
    const auto need = [&](std::uint32_t joint) {
      if (joint != kNone) needed_[joint] = true;
    };
    for (const Camera& camera : scene.cameras) need(camera.joint);
    for (const Light& light : scene.lights) need(light.joint);
    for (const PoseCorrective& corrective : scene.correctives)
      for (const PoseDriver& driver : corrective.samples.drivers) need(driver.joint);
    for (std::uint32_t j = 0; j < children_.size(); ++j)
      if (const std::uint32_t parent = scene.skeleton.parents[j]; parent != kNone) children_[parent].push_back(j);
  }

  CompiledSkeletonLod prune(double tolerance_m) {
    tolerance_m_ = tolerance_m;
    accepted_.clear();
    CompiledSkeletonLod out;
    out.detail = {std::vector<bool>(children_.size(), true), held_};
    for (std::uint32_t j = 0; j < children_.size(); ++j)
      if (scene_.skeleton.parents[j] == kNone) open_below(j);
    for (std::size_t i = 0; !open_.empty(); i = (i + stride()) % moments_.size()) test_branches_at(moments_[i]);
    for (const Branch& branch : accepted_) {
      out.left_out += static_cast<std::uint32_t>(branch.joints.size());
      for (const std::uint32_t j : branch.joints) out.detail.kept[j] = false;
      if (branch.worst_m > out.measured_m) {
        out.measured_m = branch.worst_m;
        out.worst_joint = branch.worst_joint;
      }
    }
    if (out.left_out == 0) out.detail = {};
    return out;
  }

 private:
  std::vector<Affined> affines_of(const std::vector<Transform>& held) const {
    std::vector<Affined> affines;
    for (std::size_t j = 0; j < held.size(); ++j) {
      const std::uint32_t fixed = scene_.skeleton.fixed_matrix_of[j];
      affines.push_back(fixed == kNone ? affine_from_transform(in_double(held[j]))
                                       : affine_cast<double>(scene_.skeleton.fixed_matrices[fixed]));
    }
    return affines;
  }

  /// Moments are visited in large strides, so that a moving branch is noticed early.
  std::size_t stride() const {
    std::size_t stride = moments_.size() * 5 / 8;
    while (stride == 0 || std::gcd(stride, moments_.size()) != 1) ++stride;
    return stride;
  }

  /// The branches below a joint that stays become candidates themselves.
  void open_below(std::uint32_t joint) {
    for (const std::uint32_t child : children_[joint]) {
      Branch branch{{child}};
      for (std::size_t i = 0; i < branch.joints.size(); ++i) {
        const std::vector<std::uint32_t>& more = children_[branch.joints[i]];
        branch.joints.insert(branch.joints.end(), more.begin(), more.end());
      }
      const bool is_needed =
          std::any_of(branch.joints.begin(), branch.joints.end(), [&](std::uint32_t j) { return needed_[j]; });
      if (is_needed)
        open_below(child);
      else
        open_.push_back(std::move(branch));
    }
  }

  void test_branches_at(const Moment& moment) {
    poses_.evaluate(moment);
    std::vector<Branch> tested = std::move(open_);
    open_.clear();
    for (Branch& branch : tested) {
      measure(branch);
      if (branch.worst_m > tolerance_m_)
        open_below(branch.joints.front());  // they are tested at all moments, starting with the next
      else if (++branch.moments == moments_.size())
        accepted_.push_back(std::move(branch));
      else
        open_.push_back(std::move(branch));
    }
  }

  void measure(Branch& branch) {
    for (const std::uint32_t j : branch.joints) {
      const std::uint32_t parent = scene_.skeleton.parents[j];
      held_model_[j] = (j == branch.joints.front() ? poses_.model[parent] : held_model_[parent]) * held_affines_[j];
      if (!scene_.instances.empty() && !vertices_.moves_vertices[j]) continue;
      for (const Vec3<double>& corner : corners_of(vertices_.boxes[j])) {
        const double off_m =
            safe_length(transform_point(held_model_[j], corner) - transform_point(poses_.model[j], corner));
        if (!(off_m <= branch.worst_m)) {
          branch.worst_m = off_m;
          branch.worst_joint = j;
        }
      }
      if (branch.worst_m > tolerance_m_) return;
    }
  }

  const Scene& scene_;
  std::span<const Moment> moments_;
  double tolerance_m_ = 0.0;
  VirtualVertices vertices_;
  Poses poses_;
  std::vector<std::vector<std::uint32_t>> children_;  // [J]
  std::vector<bool> needed_;                          // [J] used by a camera, a light or a corrective
  std::vector<Transform> held_;                       // [J]
  std::vector<Affined> held_affines_, held_model_;    // [J]
  std::vector<Branch> open_, accepted_;
};

/// Fractions of the tolerance, tried in turn if linear blending does not predict the vertices of other kinds of
/// skinning.
constexpr double kShares[] = {1.0, 0.5, 0.25, 0.125, 0.0625, 0.03, 0.01, 0.0};
constexpr double kRelativeRounding = 3e-6;  // rounding of float, relative to the distance from the origin

bool uses_other_skinning(const Scene& scene, const Needs& needs) noexcept {
  for (std::size_t i = 0; i < scene.instances.size(); ++i)
    if (scene.instances[i].skin != kNone && needs.skin.kind_of(i) != Skinning::linear) return true;
  return false;
}

struct FramesApart {
  double worst_m = 0.0;     // largest distance of a vertex from its place with all joints
  double farthest_m = 0.0;  // largest distance of a vertex from the origin
};

/// Compares skinned vertices, in world space, of frames with and without the joints that a detail leaves out.
FramesApart compare_frames(const Scene& scene, Needs needs, const SkeletonLod& detail,
                           std::span<const Moment> moments) {
  needs.out.joints = needs.out.normals = needs.out.tangents = needs.out.bounds = needs.in.between_updates = false;
  needs.out.positions = true;
  needs.out.skeleton_lod = {};
  const Plan full = compile_plan(lend(scene), needs);
  needs.out.skeleton_lod = detail;
  const Plan lean = compile_plan(lend(scene), needs);
  FrameBuffer all(full), some(lean);
  std::size_t vertices = 0;
  for (const PrimitivePlan& planned : full.primitives())
    vertices += planned.skin.any() ? primitive_of(full, planned).vertex_count() : 0;
  FramesApart apart;
  for (std::size_t i = 0; i < moments.size(); i += moments.size() * vertices / kMaxLodVertices + 1) {
    const ClipLayer layer{moments[i].clip, moments[i].time_s};
    FrameInput input;
    if (moments[i].clip != kNone) input.layers = {&layer, 1};
    CONTRACT(run_plan(full, input, all) == ErrorCode::ok && run_plan(lean, input, some) == ErrorCode::ok);
    for (std::size_t p = 0; p < full.primitives().size(); ++p) {
      if (!full.primitives()[p].skin.any()) continue;
      const std::span<const glm::vec3> a = all.result().primitives[p].positions,
                                       b = some.result().primitives[p].positions;
      for (std::size_t v = 0; v < a.size(); ++v) {
        apart.worst_m = std::max(apart.worst_m, safe_length(Vec3<double>(a[v]) - Vec3<double>(b[v])));
        apart.farthest_m = std::max(apart.farthest_m, safe_length(Vec3<double>(a[v])));
      }
    }
  }
  return apart;
}

CompiledSkeletonLod find_lod(const Scene& scene, double tolerance_m, std::span<const std::uint32_t> clips,
                             const Needs& needs) {
  if (scene.skeleton.joint_count() == 0) return {};
  const std::vector<Moment> moments = moments_of(scene, clips);
  Pruner pruner(scene, moments);
  if (!uses_other_skinning(scene, needs)) return pruner.prune(tolerance_m);
  for (const double share : kShares) {
    CompiledSkeletonLod within = pruner.prune(share * tolerance_m);
    if (within.left_out == 0) return within;
    const FramesApart apart = compare_frames(scene, needs, within.detail, moments);
    within.measured_m = std::max(within.measured_m, apart.worst_m);
    if (apart.worst_m <= tolerance_m + kRelativeRounding * apart.farthest_m) return within;
  }
  return {};
}

}  // namespace

CompiledSkeletonLod compile_skeleton_lod(const Scene& scene, double tolerance_m, std::span<const std::uint32_t> clips,
                                         const Needs& needs) {
  CONTRACT(tolerance_m >= 0.0);
  CompiledSkeletonLod found = find_lod(scene, tolerance_m, clips, needs);
  found.tolerance_m = tolerance_m;
  return found;
}

}  // namespace sinew
