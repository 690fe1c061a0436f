// SPDX-License-Identifier: MIT
#include "runtime/c/procedures/ik.h"

#include <cstddef>
#include <memory>
#include <new>
#include <vector>

#include "runtime/c/glue/call.h"
#include "runtime/c/glue/enums.h"
#include "runtime/c/glue/fields.h"
#include "runtime/c/glue/pose_span.h"
#include "runtime/c/glue/procedures.h"
#include "runtime/c/handles.h"
#include "runtime/pose/pose_memory.h"
#include "runtime/procedures/procedure.h"

using namespace sinew;

namespace sinew::c {

template <>
inline constexpr auto kEnum<PoleKind> =
    enum_values<PoleKind, sinew_pole_kind>({{PoleKind::none, SINEW_POLE_NONE},
                                            {PoleKind::direction, SINEW_POLE_DIRECTION},
                                            {PoleKind::point, SINEW_POLE_POINT},
                                            {PoleKind::tip_axis, SINEW_POLE_TIP_AXIS}});
template <>
inline constexpr auto kEnum<EndRotation> =
    enum_values<EndRotation, sinew_end_rotation>({{EndRotation::follow, SINEW_END_FOLLOWS},
                                                  {EndRotation::keep, SINEW_END_KEEPS},
                                                  {EndRotation::given, SINEW_END_GIVEN}});
template <>
inline constexpr auto kEnum<IkBlend> = enum_values<IkBlend, sinew_ik_blend>(
    {{IkBlend::pose, SINEW_BLEND_ROTATIONS}, {IkBlend::effector, SINEW_BLEND_EFFECTOR}});
template <>
inline constexpr auto kEnum<ChainSolver> =
    enum_values<ChainSolver, sinew_chain_solver>({{ChainSolver::ccd, SINEW_SOLVER_CCD},
                                                  {ChainSolver::fabrik, SINEW_SOLVER_FABRIK},
                                                  {ChainSolver::damped, SINEW_SOLVER_DAMPED}});

}  // namespace sinew::c

/// A goal of one kind, with copies of the lists that it refers to.
struct sinew_ik {
  enum class Kind { none, two_bone, aim, chain };

  const sinew_scene* scene;
  Kind kind = Kind::none;
  TwoBoneIk two_bone;
  AimIk aim;
  ChainIk chain;
  std::vector<AimJoint> aim_joints;
  std::vector<ChainIkJoint> chain_joints;
  std::vector<ChainEffector> effectors;
  std::vector<JointLimit> limits;
  struct alignas(64) Block {
    std::byte bytes[64];
  };
  std::vector<Block> memory;
};

namespace {

struct ReadAim {
  AimGoal goal;
  std::vector<AimJoint> joints;
  std::vector<JointLimit> limits;
};
struct ReadChain {
  ChainGoal goal;
  std::vector<ChainIkJoint> joints;
  std::vector<ChainEffector> effectors;
  std::vector<JointLimit> limits;
};

constexpr auto kTwoBone = c::fields(c::field<&sinew_two_bone_goal::root, &TwoBoneGoal::root>(),
                                    c::field<&sinew_two_bone_goal::middle, &TwoBoneGoal::middle>(),
                                    c::field<&sinew_two_bone_goal::tip, &TwoBoneGoal::tip>(),
                                    c::field<&sinew_two_bone_goal::pole_kind, &TwoBoneGoal::pole_kind>(),
                                    c::field<&sinew_two_bone_goal::target, &TwoBoneGoal::target>(),
                                    c::field<&sinew_two_bone_goal::pole, &TwoBoneGoal::pole>(),
                                    c::field<&sinew_two_bone_goal::blend, &TwoBoneGoal::blend>(),
                                    c::field<&sinew_two_bone_goal::end, &TwoBoneGoal::end>(),
                                    c::field<&sinew_two_bone_goal::end_rotation, &TwoBoneGoal::end_rotation>(),
                                    c::field<&sinew_two_bone_goal::middle_axis, &TwoBoneGoal::middle_axis>(),
                                    c::field<&sinew_two_bone_goal::twist_rad, &TwoBoneGoal::twist_rad>(),
                                    c::field<&sinew_two_bone_goal::weight, &TwoBoneGoal::weight>(),
                                    c::field<&sinew_two_bone_goal::soft_reach, &TwoBoneGoal::soft_reach>(),
                                    c::field<&sinew_two_bone_goal::most_stretch, &TwoBoneGoal::most_stretch>(),
                                    c::field<&sinew_two_bone_goal::least_bend_rad, &TwoBoneGoal::least_bend_rad>(),
                                    c::field<&sinew_two_bone_goal::most_bend_rad, &TwoBoneGoal::most_bend_rad>(),
                                    c::field<&sinew_two_bone_goal::pole_fade, &TwoBoneGoal::pole_fade>(),
                                    c::field<&sinew_two_bone_goal::tolerance, &TwoBoneGoal::tolerance>());

constexpr auto kLimit = c::fields(c::field<&sinew_joint_limit::center, &JointLimit::center>(),
                                  c::field<&sinew_joint_limit::axes, &JointLimit::axes>(),
                                  c::field<&sinew_joint_limit::swing_y_rad, &JointLimit::swing_y_rad>(),
                                  c::field<&sinew_joint_limit::swing_z_rad, &JointLimit::swing_z_rad>(),
                                  c::field<&sinew_joint_limit::least_twist_rad, &JointLimit::least_twist_rad>(),
                                  c::field<&sinew_joint_limit::most_twist_rad, &JointLimit::most_twist_rad>(),
                                  c::field<&sinew_joint_limit::limits_swing, &JointLimit::limits_swing>(),
                                  c::field<&sinew_joint_limit::limits_twist, &JointLimit::limits_twist>());

constexpr auto kAimJoint = c::fields(c::field<&sinew_aim_joint::joint, &AimJoint::joint>(),
                                     c::field<&sinew_aim_joint::share, &AimJoint::share>(),
                                     c::field<&sinew_aim_joint::limit, &AimJoint::limit>());
constexpr auto kAim =
    c::fields(c::copied_field<&sinew_aim_goal::joints, &sinew_aim_goal::joint_count, &ReadAim::joints>(kAimJoint),
              c::copied_field<&sinew_aim_goal::limits, &sinew_aim_goal::limit_count, &ReadAim::limits>(kLimit),
              c::field<&sinew_aim_goal::target, &ReadAim::goal, &AimGoal::target>(),
              c::field<&sinew_aim_goal::forward, &ReadAim::goal, &AimGoal::forward>(),
              c::field<&sinew_aim_goal::up, &ReadAim::goal, &AimGoal::up>(),
              c::field<&sinew_aim_goal::offset, &ReadAim::goal, &AimGoal::offset>(),
              c::field<&sinew_aim_goal::pole, &ReadAim::goal, &AimGoal::pole>(),
              c::field<&sinew_aim_goal::twist_rad, &ReadAim::goal, &AimGoal::twist_rad>(),
              c::field<&sinew_aim_goal::weight, &ReadAim::goal, &AimGoal::weight>(),
              c::field<&sinew_aim_goal::pole_fade, &ReadAim::goal, &AimGoal::pole_fade>(),
              c::field<&sinew_aim_goal::tolerance_rad, &ReadAim::goal, &AimGoal::tolerance_rad>());

constexpr auto kChainJoint = c::fields(c::field<&sinew_chain_joint::joint, &ChainIkJoint::joint>(),
                                       c::field<&sinew_chain_joint::limit, &ChainIkJoint::limit>(),
                                       c::field<&sinew_chain_joint::moves, &ChainIkJoint::moves>());
constexpr auto kEffector =
    c::fields(c::field<&sinew_chain_effector::joint, &ChainEffector::joint>(),
              c::field<&sinew_chain_effector::target, &ChainEffector::target>(),
              c::field<&sinew_chain_effector::rotation, &ChainEffector::rotation>(),
              c::field<&sinew_chain_effector::weight, &ChainEffector::weight>(),
              c::field<&sinew_chain_effector::rotation_weight, &ChainEffector::rotation_weight>());
constexpr auto kChainGoal = c::fields(
    c::copied_field<&sinew_chain_goal::joints, &sinew_chain_goal::joint_count, &ReadChain::joints>(kChainJoint),
    c::copied_field<&sinew_chain_goal::limits, &sinew_chain_goal::limit_count, &ReadChain::limits>(kLimit),
    c::copied_field<&sinew_chain_goal::effectors, &sinew_chain_goal::effector_count, &ReadChain::effectors>(kEffector),
    c::field<&sinew_chain_goal::solver, &ReadChain::goal, &ChainGoal::solver>(),
    c::field<&sinew_chain_goal::iterations, &ReadChain::goal, &ChainGoal::iterations>(),
    c::field<&sinew_chain_goal::most_turn_rad, &ReadChain::goal, &ChainGoal::most_turn_rad>(),
    c::field<&sinew_chain_goal::tolerance, &ReadChain::goal, &ChainGoal::tolerance>(),
    c::field<&sinew_chain_goal::tolerance_rad, &ReadChain::goal, &ChainGoal::tolerance_rad>(),
    c::field<&sinew_chain_goal::weight, &ReadChain::goal, &ChainGoal::weight>());

PoseProcedure procedure_of(sinew_ik& ik) noexcept {
  switch (ik.kind) {
    case sinew_ik::Kind::none: return {};
    case sinew_ik::Kind::two_bone: return as_procedure(ik.two_bone);
    case sinew_ik::Kind::aim: return as_procedure(ik.aim);
    case sinew_ik::Kind::chain: return as_procedure(ik.chain);
  }
  return {};
}

IkResult result_of(const sinew_ik& ik) noexcept {
  switch (ik.kind) {
    case sinew_ik::Kind::none: return {};
    case sinew_ik::Kind::two_bone: return ik.two_bone.result;
    case sinew_ik::Kind::aim: return ik.aim.result;
    case sinew_ik::Kind::chain: return ik.chain.result;
  }
  return {};
}

void run_on(sinew_ik& ik, const PoseSpan& local, float share) noexcept {
  const PoseProcedure procedure = procedure_of(ik);
  if (procedure.run != nullptr) procedure.run(procedure.context, {ik.scene->scene.skeleton, local, {}, {}, share});
}

/// Checks a goal before the handle takes it.
template <class Job, class Goal>
ErrorCode check_goal(const sinew_ik& ik, const Goal& goal, std::span<std::byte> memory = {}) {
  PoseMemory pose(ik.scene->scene.skeleton.joint_count());
  Job job;
  job.skeleton = &ik.scene->scene.skeleton;
  job.local = pose.span();
  job.goal = goal;
  if constexpr (requires { job.memory; }) job.memory = memory;
  return check(job);
}

}  // namespace

sinew_two_bone_goal sinew_default_two_bone_goal(void) {
  return c::written<sinew_two_bone_goal>(kTwoBone, TwoBoneGoal{});
}
sinew_aim_goal sinew_default_aim_goal(void) { return c::written<sinew_aim_goal>(kAim, ReadAim{}); }
sinew_chain_goal sinew_default_chain_goal(void) { return c::written<sinew_chain_goal>(kChainGoal, ReadChain{}); }

sinew_error sinew_ik_create(const sinew_scene* scene, sinew_ik** out) {
  return c::call(c::given(scene, out), [&] { *out = new sinew_ik{scene}; });
}
void sinew_ik_destroy(sinew_ik* ik) { delete ik; }

sinew_error sinew_ik_set_two_bone(sinew_ik* ik, const sinew_two_bone_goal* goal) {
  return c::call(c::given(ik, goal), [&] {
    TwoBoneGoal own;
    if (const sinew_error error = c::read_fields(goal, kTwoBone, own)) return error;
    if (const ErrorCode code = check_goal<TwoBoneIkJob>(*ik, own); code != ErrorCode::ok) return c::error_from(code);
    ik->two_bone = {own, {}};
    ik->kind = sinew_ik::Kind::two_bone;
    return SINEW_OK;
  });
}

sinew_error sinew_ik_set_aim(sinew_ik* ik, const sinew_aim_goal* goal) {
  return c::call(c::given(ik, goal), [&] {
    ReadAim own;
    if (const sinew_error error = c::read_fields(goal, kAim, own)) return error;
    own.goal.joints = own.joints;
    own.goal.limits = own.limits;
    if (const ErrorCode code = check_goal<AimJob>(*ik, own.goal); code != ErrorCode::ok) return c::error_from(code);
    ik->aim_joints = std::move(own.joints);
    ik->limits = std::move(own.limits);
    ik->aim = {own.goal, {}};
    ik->aim.goal.joints = ik->aim_joints;
    ik->aim.goal.limits = ik->limits;
    ik->kind = sinew_ik::Kind::aim;
    return SINEW_OK;
  });
}

sinew_error sinew_ik_set_chain(sinew_ik* ik, const sinew_chain_goal* goal) {
  return c::call(c::given(ik, goal), [&] {
    ReadChain own;
    if (const sinew_error error = c::read_fields(goal, kChainGoal, own)) return error;
    own.goal.joints = own.joints;
    own.goal.limits = own.limits;
    own.goal.effectors = own.effectors;
    std::vector<sinew_ik::Block> memory(chain_ik_bytes(ik->scene->scene.skeleton, own.goal) / sizeof(sinew_ik::Block));
    const std::span<std::byte> bytes{memory.data()->bytes, memory.size() * sizeof(sinew_ik::Block)};
    if (const ErrorCode code = check_goal<ChainIkJob>(*ik, own.goal, bytes); code != ErrorCode::ok)
      return c::error_from(code);
    ik->chain_joints = std::move(own.joints);
    ik->limits = std::move(own.limits);
    ik->effectors = std::move(own.effectors);
    ik->memory = std::move(memory);
    ik->chain = {own.goal, bytes, {}};
    ik->chain.goal.joints = ik->chain_joints;
    ik->chain.goal.limits = ik->limits;
    ik->chain.goal.effectors = ik->effectors;
    ik->kind = sinew_ik::Kind::chain;
    return SINEW_OK;
  });
}

sinew_error sinew_ik_procedure(sinew_ik* ik, sinew_pose_procedure* out) {
  return c::call(c::given(ik, out), [&] { *out = {&c::run_procedure<run_on>, ik, procedure_of(*ik).version}; });
}

sinew_error sinew_ik_solve(sinew_ik* ik, const sinew_pose* local) {
  return c::call(c::given(ik), [&] { return c::run_at_once<run_on>(*ik, ik->scene->scene.skeleton, local); });
}

sinew_error sinew_get_ik_result(const sinew_ik* ik, sinew_ik_result* out) {
  return c::call(c::given(ik), [&] {
    const IkResult own = result_of(*ik);
    return c::write_struct({.struct_size = 0,
                            .status = static_cast<std::uint32_t>(own.status),
                            .error = static_cast<std::int32_t>(c::error_from(own.error)),
                            .iterations = own.iterations,
                            .metres_left = own.metres_left,
                            .radians_left = own.radians_left},
                           out);
  });
}
