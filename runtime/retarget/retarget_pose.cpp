// SPDX-License-Identifier: MIT
#include "runtime/retarget/retarget_pose.h"

#include <algorithm>
#include <array>
#include <utility>

#include "runtime/math/quaternion.h"
#include "runtime/retarget/rest_transform.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/retarget/retarget_pose.cpp"
#include <hwy/foreach_target.h>

#include "runtime/pose/simd/dispatch.h"
#include "runtime/pose/simd/pose_lanes-inl.h"

namespace sinew {
namespace {

/// Composes the chains of joints between mapped ones into the scratch pose, relative to the mapped ancestor.
PoseSpan compose_chains(const RetargetPoseJob& job, const RetargetPass& pass) noexcept;

}  // namespace
}  // namespace sinew

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace {

/// Replaces `kCount` planes from `first` on by `map(source values, factors, stride of their planes)`.
template <std::size_t kCount, class Map>
HWY_INLINE void map_all(const RetargetedJoints& joints, const PoseSpan& pose, const PoseSpan& to, PoseSpan::Plane first,
                        const Map& map) {
  const Floats d;
  const std::size_t count = joints.targets.size();
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const IndexLanes from = load_indices(joints.sources, i), at = load_indices(joints.targets, i);
    Lanes numbers[kCount];
    for (std::size_t c = 0; c < kCount; ++c) numbers[c] = hn::GatherIndex(d, pose.plane(first) + c * pose.stride, from);
    map(numbers, joints.factors.data() + i, count);
    for (std::size_t c = 0; c < kCount; ++c) hn::ScatterIndex(numbers[c], d, to.plane(first) + c * to.stride, at);
  }
}

void map_joints(const RetargetPass& pass, const RetargetPoseJob& job) {
  const PoseSpan from = compose_chains(job, pass);
  const auto copy = [&](const std::vector<std::uint32_t>(&joints)[2], PoseSpan::Plane first, std::size_t count) {
    for (std::size_t c = 0; c < count; ++c)
      for (std::size_t i = 0; i < joints[0].size(); ++i)
        (job.retargeted.plane(first) + c * job.retargeted.stride)[joints[0][i]] =
            (from.plane(first) + c * from.stride)[joints[1][i]];
  };
  copy(pass.copied_rotations, PoseSpan::rx, 4);
  copy(pass.copied_translations, PoseSpan::tx, 3);
  map_all<4>(pass.rotations, from, job.retargeted, PoseSpan::rx,
             [](Lanes(&q)[4], const float* factors, std::size_t plane) HWY_ATTR {
               const Floats d;
               const auto factor = [&](std::size_t i) HWY_ATTR { return hn::LoadU(d, factors + i * plane); };
               const Rotations before{factor(0), factor(1), factor(2), factor(3)},
                   after{factor(4), factor(5), factor(6), factor(7)};
               const Rotations unit = normalised(product(product(before, {q[0], q[1], q[2], q[3]}), after));
               q[0] = unit.x;
               q[1] = unit.y;
               q[2] = unit.z;
               q[3] = unit.w;
             });
  map_all<3>(pass.translations, from, job.retargeted, PoseSpan::tx,
             [](Lanes(&t)[3], const float* factors, std::size_t plane) HWY_ATTR {
               const Floats d;
               const Lanes x = t[0], y = t[1], z = t[2];
               const auto factor = [&](std::size_t i) HWY_ATTR { return hn::LoadU(d, factors + i * plane); };
               for (std::size_t r = 0; r < 3; ++r)
                 t[r] = add_product(add_product(add_product(factor(9 + r), x, factor(3 * r)), y, factor(3 * r + 1)), z,
                                    factor(3 * r + 2));
             });
  map_all<3>(pass.scales, from, job.retargeted, PoseSpan::sx,
             [](Lanes(&s)[3], const float* factors, std::size_t plane) HWY_ATTR {
               for (std::size_t c = 0; c < 3; ++c) s[c] = hn::Mul(s[c], hn::LoadU(Floats(), factors + c * plane));
             });
}

void retarget(const RetargetPoseJob& job) {
  std::copy(job.tables->rest.begin(), job.tables->rest.end(), job.retargeted.planes);
  for (const RetargetPass& pass : job.tables->passes) map_joints(pass, job);
}

}  // namespace
}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew {
namespace {

PoseSpan compose_chains(const RetargetPoseJob& job, const RetargetPass& pass) noexcept {
  if (pass.composed.empty()) return job.pose;
  std::copy_n(job.pose.planes, PoseSpan::floats_for(job.pose.joint_count), job.scratch.planes);
  for (const std::vector<ChainJoint>& way : pass.composed) {
    Transform relative;
    for (const ChainJoint& step : way) {
      const Transform own = step.is_fixed ? step.local : job.pose.get(step.joint);
      const bool is_first = &step == way.data();
      relative.translation =
          is_first ? own.translation : own.translation + rotate_vector(own.rotation, own.scale * relative.translation);
      relative.rotation = is_first ? own.rotation : own.rotation * relative.rotation;
    }
    const ChainJoint& own = way.front();
    relative.scale = own.is_fixed ? own.local.scale : job.pose.get(own.joint).scale;
    job.scratch.set(way.front().joint, relative);
  }
  return job.scratch;
}

constexpr std::size_t kGroup = 16;

void pad_to_groups(RetargetedJoints& joints) {
  while (joints.targets.size() % kGroup != 0) {
    joints.targets.push_back(joints.targets.back());
    joints.sources.push_back(joints.sources.back());
  }
}

/// Writes the planes of factors; `factors_of(joint)` gives those of each joint.
template <class FactorsOf>
void write_factors(RetargetedJoints& joints, const std::vector<const MappedJoint*>& by_target,
                   const FactorsOf& factors_of) {
  pad_to_groups(joints);
  for (std::size_t i = 0; i < joints.targets.size(); ++i) {
    const auto factors = factors_of(*by_target[joints.targets[i]]);
    joints.factors.resize(factors.size() * joints.targets.size());
    for (std::size_t f = 0; f < factors.size(); ++f)
      joints.factors[f * joints.targets.size() + i] = static_cast<float>(factors[f]);
  }
}

/// Adds a joint to the copies, or to `mapped`.
void add(const MappedJoint& joint, bool is_copied, std::vector<std::uint32_t> (&copied)[2], RetargetedJoints& mapped) {
  (is_copied ? copied[0] : mapped.targets).push_back(joint.target);
  (is_copied ? copied[1] : mapped.sources).push_back(joint.source);
}

bool is_identity(const Quat<double>& q) noexcept {
  return q == quat_identity<double>() || q == -quat_identity<double>();
}

std::vector<ChainJoint> way_of(const MappedJoint& joint, const Skeleton& source) {
  std::vector<ChainJoint> way;
  for (std::uint32_t j = joint.source; j != joint.above_source; j = source.parents[j]) {
    const Transformd rest = rest_transform(source, j);
    way.push_back({j,
                   source.fixed_matrix_of[j] != kNone,
                   {glm::vec3(rest.translation), quat_cast<float>(rest.rotation), glm::vec3(rest.scale)}});
  }
  return way;
}

void write_rest(const SkeletonMap& map, const Skeleton& target, RetargetTables& tables) {
  const std::vector<Transform>& pose = map.target_pose.empty() ? target.rest : map.target_pose;

  tables.rest.resize(PoseSpan::floats_for(target.joint_count()));
  const PoseSpan rest{tables.rest.data(), target.joint_count(), PoseSpan::stride_for(target.joint_count())};
  for (std::uint32_t j = 0; j < rest.stride; ++j) rest.set(j, j < rest.joint_count ? pose[j] : Transform{});
}

Vec3<double> offset_of(const MappedJoint& joint, const SkeletonMap& map, const Skeleton& target) noexcept {
  return reference_transform(target, map.target_pose, joint.target).translation -
         joint.translation * joint.source_place;
}

void add_joint(const MappedJoint& joint, const SkeletonMap& map, const Skeleton& source, const Skeleton& target,
               RetargetPass& pass) {
  std::vector<ChainJoint> way = way_of(joint, source);
  const bool is_child = way.size() == 1;
  if (!is_child || way.front().is_fixed) pass.composed.push_back(std::move(way));
  add(joint, is_identity(joint.before) && is_identity(joint.after), pass.copied_rotations, pass.rotations);
  if (joint.moves) {
    const bool copies = joint.translation == Mat3<double>(1.0) && offset_of(joint, map, target) == Vec3<double>(0.0);
    add(joint, copies, pass.copied_translations, pass.translations);
  }
  if (!map.by_names || !is_child) return;
  pass.scales.targets.push_back(joint.target);
  pass.scales.sources.push_back(joint.source);
}

/// Distributes the joints over passes.
std::vector<std::vector<const MappedJoint*>> in_passes(const SkeletonMap& map, std::size_t source_count) {
  std::vector<std::vector<const MappedJoint*>> passes, users;  // users[pass][source joint]: a mapped joint that uses it
  for (const MappedJoint& joint : map.joints) {
    const auto is_taken = [&](const std::vector<const MappedJoint*>& by) {
      return by[joint.source] != nullptr && by[joint.source]->above_source != joint.above_source;
    };
    const auto p = static_cast<std::size_t>(std::find_if_not(users.begin(), users.end(), is_taken) - users.begin());
    if (p == users.size()) {
      users.emplace_back(source_count);
      passes.emplace_back();
    }
    users[p][joint.source] = &joint;
    passes[p].push_back(&joint);
  }
  return passes;
}

void write_all_factors(const std::vector<const MappedJoint*>& by_target, const SkeletonMap& map, const Skeleton& source,
                       const Skeleton& target, RetargetPass& pass) {
  write_factors(pass.rotations, by_target, [](const MappedJoint& joint) {
    const Quat<double>&a = joint.before, &b = joint.after;
    return std::array{a.x, a.y, a.z, a.w, b.x, b.y, b.z, b.w};
  });
  write_factors(pass.translations, by_target, [&](const MappedJoint& joint) {
    const Mat3<double>& m = joint.translation;
    const Vec3<double> offset = offset_of(joint, map, target);
    return std::array{m[0].x, m[1].x, m[2].x, m[0].y,   m[1].y,   m[2].y,
                      m[0].z, m[1].z, m[2].z, offset.x, offset.y, offset.z};
  });
  write_factors(pass.scales, by_target, [&](const MappedJoint& joint) {
    const Vec3<double> ratio = reference_transform(target, map.target_pose, joint.target).scale /
                               reference_transform(source, map.source_pose, joint.source).scale;
    return std::array{ratio.x, ratio.y, ratio.z};
  });
}

}  // namespace

RetargetTables make_retarget_tables(const SkeletonMap& map, const Skeleton& source, const Skeleton& target) {
  RetargetTables tables;
  tables.source_count = source.joint_count();
  tables.target_count = target.joint_count();
  write_rest(map, target, tables);
  std::vector<const MappedJoint*> by_target(target.joint_count());
  for (const MappedJoint& joint : map.joints) by_target[joint.target] = &joint;
  for (const std::vector<const MappedJoint*>& joints : in_passes(map, source.joint_count())) {
    RetargetPass& pass = tables.passes.emplace_back();
    for (const MappedJoint* joint : joints) add_joint(*joint, map, source, target, pass);
    write_all_factors(by_target, map, source, target, pass);
  }
  return tables;
}

ErrorCode check(const RetargetPoseJob& job) noexcept {
  if (job.tables == nullptr) return ErrorCode::size_mismatch;
  const bool has_scratch = !job.tables->composes() || is_pose_of(job.scratch, job.tables->source_count);
  const bool all_fit = is_pose_of(job.pose, job.tables->source_count) &&
                       is_pose_of(job.retargeted, job.tables->target_count) && has_scratch;
  return all_fit ? ErrorCode::ok : ErrorCode::size_mismatch;
}

SINEW_DISPATCH_RUN(RetargetPoseJob, retarget)

}  // namespace sinew
#endif  // HWY_ONCE
