// SPDX-License-Identifier: MIT
#include "runtime/procedures/procedure.h"

#include <bit>
#include <concepts>
#include <cstdint>

#include "runtime/base/bit_hash.h"

namespace sinew {
namespace {

/// Hash of a goal. Fields are added one by one, because the padding of structs has arbitrary bytes.
class GoalHash {
 public:
  void add(double number) noexcept { hash_.add(std::span(&number, 1)); }
  void add(float number) noexcept { add(static_cast<double>(number)); }
  template <std::unsigned_integral Index>
  void add(Index index) noexcept {
    add(static_cast<double>(index));
  }
  template <class Enum>
  requires std::is_enum_v<Enum>
  void add(Enum value) noexcept { add(static_cast<double>(value)); }
  template <class T>
  void add(const Vec3<T>& v) noexcept {
    for (int i = 0; i < 3; ++i) add(v[i]);
  }
  void add(const glm::quat& q) noexcept {
    for (const float number : {q.x, q.y, q.z, q.w}) add(number);
  }
  void add(const JointLimit& limit) noexcept {
    add_all(limit.center, limit.axes, limit.swing_y_rad, limit.swing_z_rad, limit.least_twist_rad, limit.most_twist_rad,
            limit.limits_swing, limit.limits_twist);
  }
  void add(const AimJoint& joint) noexcept { add_all(joint.joint, joint.share, joint.limit); }
  void add(const ChainIkJoint& joint) noexcept { add_all(joint.joint, joint.limit, joint.moves); }
  void add(const ChainEffector& effector) noexcept {
    add_all(effector.joint, effector.target, effector.rotation, effector.weight, effector.rotation_weight);
  }
  template <class T>
  void add(std::span<const T> list) noexcept {
    add(list.size());
    for (const T& item : list) add(item);
  }
  template <class... Fields>
  void add_all(const Fields&... fields) noexcept {
    (add(fields), ...);
  }
  /// in   kind  number of the solver, so that goals of different solvers have different hashes
  ContentVersion version(std::uint64_t kind) const noexcept {
    const std::uint64_t value = hash_.value() ^ kind;
    return value != 0 ? value : 1;
  }

 private:
  BitHash hash_;
};

ContentVersion version_of(const TwoBoneGoal& goal) noexcept {
  GoalHash hash;
  hash.add_all(goal.root, goal.middle, goal.tip, goal.target, goal.pole, goal.pole_kind, goal.blend, goal.end,
               goal.end_rotation, goal.middle_axis, goal.twist_rad, goal.weight, goal.soft_reach, goal.most_stretch,
               goal.least_bend_rad, goal.most_bend_rad, goal.pole_fade, goal.tolerance);
  return hash.version(1);
}

ContentVersion version_of(const AimGoal& goal) noexcept {
  GoalHash hash;
  hash.add_all(goal.joints, goal.limits, goal.target, goal.forward, goal.up, goal.offset, goal.pole, goal.twist_rad,
               goal.weight, goal.pole_fade, goal.tolerance_rad);
  return hash.version(2);
}

ContentVersion version_of(const ChainGoal& goal) noexcept {
  GoalHash hash;
  hash.add_all(goal.joints, goal.limits, goal.effectors, goal.solver, goal.iterations, goal.most_turn_rad,
               goal.tolerance, goal.tolerance_rad, goal.weight);
  return hash.version(3);
}

/// Runs a job with the goal of a procedure. If the goal is refused, stores the error in the result.
template <class Job, class Ik>
void run_goal(Job job, Ik& ik, float share) noexcept {
  job.goal = ik.goal;
  job.goal.weight *= share;
  job.result = &ik.result;
  ik.result = {};
  ik.result.error = check(job);
  if (ik.result.error == ErrorCode::ok) run_unchecked(job);
}

void run_two_bones(void* context, const ProcedurePose& pose) {
  TwoBoneIkJob job;
  job.skeleton = &pose.skeleton;
  job.local = pose.local;
  run_goal(job, *static_cast<TwoBoneIk*>(context), pose.share);
}

void run_aim(void* context, const ProcedurePose& pose) {
  AimJob job;
  job.skeleton = &pose.skeleton;
  job.local = pose.local;
  run_goal(job, *static_cast<AimIk*>(context), pose.share);
}

void run_chain(void* context, const ProcedurePose& pose) {
  ChainIk& ik = *static_cast<ChainIk*>(context);
  ChainIkJob job;
  job.skeleton = &pose.skeleton;
  job.local = pose.local;
  job.memory = ik.memory;
  run_goal(job, ik, pose.share);
}

void run_list(void* context, const ProcedurePose& pose) {
  for (const PoseProcedure& procedure : static_cast<const ProcedureList*>(context)->procedures)
    if (procedure.run != nullptr) procedure.run(procedure.context, pose);
}

}  // namespace

PoseProcedure as_procedure(TwoBoneIk& ik) noexcept { return {&run_two_bones, &ik, version_of(ik.goal)}; }
PoseProcedure as_procedure(AimIk& ik) noexcept { return {&run_aim, &ik, version_of(ik.goal)}; }
PoseProcedure as_procedure(ChainIk& ik) noexcept { return {&run_chain, &ik, version_of(ik.goal)}; }

PoseProcedure as_procedure(ProcedureList& list) noexcept {
  BitHash hash;
  bool promises = true;
  for (const PoseProcedure& procedure : list.procedures) {
    hash.add(std::span(&procedure.version, 1));
    promises = promises && procedure.version != 0;
  }
  return {&run_list, &list, promises ? hash.value() | 1 : 0};
}

}  // namespace sinew
