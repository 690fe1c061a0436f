// SPDX-License-Identifier: MIT
#include "runtime/c/procedures/springs.h"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "runtime/c/glue/call.h"
#include "runtime/c/glue/fields.h"
#include "runtime/c/glue/procedures.h"
#include "runtime/c/handles.h"
#include "runtime/procedures/springs/springs_procedure.h"

using namespace sinew;

namespace sinew::c {

template <>
inline constexpr auto kEnum<SpringCollider::Kind> =
    enum_values<SpringCollider::Kind, sinew_collider_kind>({{SpringCollider::Kind::sphere, SINEW_COLLIDER_SPHERE},
                                                            {SpringCollider::Kind::capsule, SINEW_COLLIDER_CAPSULE},
                                                            {SpringCollider::Kind::plane, SINEW_COLLIDER_PLANE}});
template <>
inline constexpr auto kEnum<SpringGoal> = enum_values<SpringGoal, sinew_spring_goal>(
    {{SpringGoal::rest, SINEW_SPRING_TO_REST}, {SpringGoal::pose, SINEW_SPRING_TO_POSE}});
template <>
inline constexpr auto kEnum<SpringEvent> =
    enum_values<SpringEvent, sinew_spring_event>({{SpringEvent::none, SINEW_SPRINGS_GO_ON},
                                                  {SpringEvent::reset, SINEW_SPRINGS_RESET},
                                                  {SpringEvent::teleport, SINEW_SPRINGS_TELEPORT}});

}  // namespace sinew::c

struct sinew_springs {
  const sinew_scene* scene;
  Springs springs;
};

/// The springs of one character, with their memory.
struct sinew_spring_motion {
  explicit sinew_spring_motion(const sinew_springs& of)
      : definition(&of), state(of.springs.state_bytes() / 8, 0), scratch(of.springs.scratch_bytes() / 8, 0) {
    springs.springs = &of.springs;
    springs.state = std::as_writable_bytes(std::span(state));
    springs.scratch = std::as_writable_bytes(std::span(scratch));
  }

  const sinew_springs* definition;
  std::vector<std::uint64_t> state, scratch;
  SpringsContext springs;
};

namespace {

struct ReadSprings : SpringSetup {
  SpringSettings settings;
};

constexpr auto kCollider = c::fields(c::field<&sinew_spring_collider::kind, &SpringCollider::kind>(),
                                     c::field<&sinew_spring_collider::joint, &SpringCollider::joint>(),
                                     c::field<&sinew_spring_collider::offset, &SpringCollider::offset>(),
                                     c::field<&sinew_spring_collider::tail, &SpringCollider::tail>(),
                                     c::field<&sinew_spring_collider::normal, &SpringCollider::normal>(),
                                     c::field<&sinew_spring_collider::radius_m, &SpringCollider::radius_m>(),
                                     c::field<&sinew_spring_collider::inside, &SpringCollider::inside>());
constexpr auto kGroup = c::fields(
    c::field<&sinew_spring_group::center, &SpringGroup::center>(),
    c::field<&sinew_spring_group::goal, &SpringGroup::goal>(),
    c::span_field<&sinew_spring_group::colliders, &sinew_spring_group::collider_count, &SpringGroup::colliders>());
constexpr auto kJoint = c::fields(c::field<&sinew_spring_joint::joint, &SpringJoint::joint>(),
                                  c::field<&sinew_spring_joint::group, &SpringJoint::group>(),
                                  c::field<&sinew_spring_joint::tail_m, &SpringJoint::tail_m>(),
                                  c::field<&sinew_spring_joint::stiffness, &SpringJoint::stiffness>(),
                                  c::field<&sinew_spring_joint::drag, &SpringJoint::drag>(),
                                  c::field<&sinew_spring_joint::gravity_m_s, &SpringJoint::gravity_m_s>(),
                                  c::field<&sinew_spring_joint::hit_radius_m, &SpringJoint::hit_radius_m>(),
                                  c::field<&sinew_spring_joint::lagging_length, &SpringJoint::lagging_length>());
constexpr auto kSpringsSetup = c::fields(
    c::copied_field<&sinew_springs_setup::groups, &sinew_springs_setup::group_count, &ReadSprings::groups>(kGroup),
    c::copied_field<&sinew_springs_setup::joints, &sinew_springs_setup::joint_count, &ReadSprings::joints>(kJoint),
    c::copied_field<&sinew_springs_setup::colliders, &sinew_springs_setup::collider_count, &ReadSprings::colliders>(
        kCollider),
    c::field<&sinew_springs_setup::tick_s, &ReadSprings::settings, &SpringSettings::tick_s>(),
    c::field<&sinew_springs_setup::max_ticks, &ReadSprings::settings, &SpringSettings::max_ticks>(),
    c::field<&sinew_springs_setup::sleep_ticks, &ReadSprings::settings, &SpringSettings::sleep_ticks>(),
    c::field<&sinew_springs_setup::sleep_rad_per_s, &ReadSprings::settings, &SpringSettings::sleep_rad_per_s>());
constexpr auto kSpringFrame =
    c::fields(c::field<&sinew_spring_frame::root, &SpringsContext::root>(),
              c::field<&sinew_spring_frame::dt_s, &SpringsContext::dt_s>(),
              c::field<&sinew_spring_frame::event, &SpringsContext::event>(),
              c::span_field<&sinew_spring_frame::tails, &sinew_spring_frame::tail_count, &SpringsContext::tails>());

const Skeleton& skeleton_of(const sinew_spring_motion& motion) noexcept {
  return motion.definition->scene->scene.skeleton;
}

void run_springs_on(sinew_spring_motion& motion, const PoseSpan& local, float share) noexcept {
  const PoseProcedure procedure = springs_procedure(motion.springs);
  procedure.run(procedure.context, {skeleton_of(motion), local, {}, {}, share});
}

}  // namespace

sinew_springs_setup sinew_default_springs_setup(void) {
  return c::written<sinew_springs_setup>(kSpringsSetup, ReadSprings{});
}

sinew_spring_joint sinew_default_spring_joint(std::uint32_t joint) {
  return c::written<sinew_spring_joint>(kJoint, SpringJoint{.joint = joint});
}

sinew_error sinew_springs_create(const sinew_scene* scene, const sinew_springs_setup* setup, sinew_springs** out,
                                 sinew_messages** why) {
  return c::call(c::given(scene, setup, out), [&] {
    if (why != nullptr) *why = nullptr;
    ReadSprings own;
    if (const sinew_error error = c::read_fields(setup, kSpringsSetup, own)) return error;
    auto springs = compile_springs(scene->scene.skeleton, own, own.settings);
    if (!springs) {
      if (why != nullptr) *why = new sinew_messages{{springs.error().text}};
      return c::error_from(springs.error().code);
    }
    *out = new sinew_springs{scene, *std::move(springs)};
    return SINEW_OK;
  });
}
void sinew_springs_destroy(sinew_springs* springs) { delete springs; }

sinew_error sinew_spring_motion_create(const sinew_springs* springs, sinew_spring_motion** out) {
  return c::call(c::given(springs, out), [&] { *out = new sinew_spring_motion(*springs); });
}
void sinew_spring_motion_destroy(sinew_spring_motion* motion) { delete motion; }

sinew_spring_frame sinew_default_spring_frame(void) {
  return c::written<sinew_spring_frame>(kSpringFrame, SpringsContext{});
}

sinew_error sinew_spring_motion_begin_frame(sinew_spring_motion* motion, const sinew_spring_frame* frame) {
  return c::call(c::given(motion, frame), [&] {
    SpringsContext next = motion->springs;
    if (const sinew_error error = c::read_fields(frame, kSpringFrame, next)) return error;
    if (const sinew_error error = c::check_step(next.root, next.dt_s)) return error;
    if (!next.tails.empty() && next.tails.size() < next.springs->joint_count()) return SINEW_SIZE_MISMATCH;
    motion->springs = next;
    return SINEW_OK;
  });
}

sinew_error sinew_spring_motion_procedure(sinew_spring_motion* motion, sinew_pose_procedure* out) {
  return c::call(c::given(motion, out), [&] {
    *out = {&c::run_procedure<run_springs_on>, motion, springs_procedure(motion->springs).version};
  });
}

sinew_error sinew_spring_motion_run(sinew_spring_motion* motion, const sinew_pose* local) {
  return c::call(c::given(motion),
                 [&] { return c::run_at_once<run_springs_on>(*motion, skeleton_of(*motion), local); });
}

sinew_error sinew_get_spring_result(const sinew_spring_motion* motion, sinew_spring_result* out) {
  return c::call(c::given(motion), [&] {
    const SpringCounts& own = motion->springs.counts;
    return c::write_struct({.struct_size = 0,
                            .error = static_cast<std::int32_t>(c::error_from(motion->springs.code)),
                            .ticks = own.ticks,
                            .joints = own.joints,
                            .dropped_ticks = own.dropped_ticks,
                            .is_asleep = own.asleep ? 1u : 0u},
                           out);
  });
}

std::size_t sinew_spring_motion_state_bytes(const sinew_spring_motion* motion) {
  return motion != nullptr ? motion->state.size() * 8 : 0;
}

sinew_error sinew_spring_motion_get_state(const sinew_spring_motion* motion, void* state, std::size_t size) {
  return c::call(c::given(motion), [&] { return c::copy_state(std::as_bytes(std::span(motion->state)), state, size); });
}

sinew_error sinew_spring_motion_set_state(sinew_spring_motion* motion, const void* state, std::size_t size) {
  return c::call(c::given(motion, state), [&] {
    if (size != motion->state.size() * 8) return SINEW_SIZE_MISMATCH;
    std::memcpy(motion->state.data(), state, size);
    return SINEW_OK;
  });
}
