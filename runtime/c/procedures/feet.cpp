// SPDX-License-Identifier: MIT
#include "runtime/c/procedures/feet.h"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "runtime/c/glue/call.h"
#include "runtime/c/glue/fields.h"
#include "runtime/c/glue/procedures.h"
#include "runtime/c/handles.h"
#include "runtime/pose/pose_memory.h"
#include "runtime/procedures/feet.h"

using namespace sinew;

static_assert(SINEW_MOST_FEET == kMostFeet);

/// The feet of one character, with a copy of the list that their setup refers to.
struct sinew_feet {
  const sinew_scene* scene;
  std::vector<FootSetup> list;
  Feet feet;
  sinew_ground_query find = nullptr;
  void* context = nullptr;
};

namespace {

struct ReadFeet {
  FeetSetup setup;
  std::vector<FootSetup> feet;
};

constexpr auto kFoot =
    c::fields(c::field<&sinew_foot::hip, &FootSetup::hip>(), c::field<&sinew_foot::knee, &FootSetup::knee>(),
              c::field<&sinew_foot::ankle, &FootSetup::ankle>(), c::field<&sinew_foot::toes, &FootSetup::toes>(),
              c::field<&sinew_foot::heel, &FootSetup::heel>(), c::field<&sinew_foot::tip, &FootSetup::tip>());

template <auto OfC, auto Own>
constexpr auto of_setup = c::field<OfC, &ReadFeet::setup, Own>();

constexpr auto kSetup =
    c::fields(c::copied_field<&sinew_feet_setup::feet, &sinew_feet_setup::foot_count, &ReadFeet::feet>(kFoot),
              of_setup<&sinew_feet_setup::pelvis, &FeetSetup::pelvis>,
              of_setup<&sinew_feet_setup::lock_below_m_s, &FeetSetup::lock_below_m_s>,
              of_setup<&sinew_feet_setup::free_above_m_s, &FeetSetup::free_above_m_s>,
              of_setup<&sinew_feet_setup::contact_height_m, &FeetSetup::contact_height_m>,
              of_setup<&sinew_feet_setup::release_beyond_m, &FeetSetup::release_beyond_m>,
              of_setup<&sinew_feet_setup::half_life_s, &FeetSetup::half_life_s>,
              of_setup<&sinew_feet_setup::step_half_life_s, &FeetSetup::step_half_life_s>,
              of_setup<&sinew_feet_setup::pelvis_half_life_s, &FeetSetup::pelvis_half_life_s>,
              of_setup<&sinew_feet_setup::most_pelvis_m, &FeetSetup::most_pelvis_m>,
              of_setup<&sinew_feet_setup::most_slope_rad, &FeetSetup::most_slope_rad>);

constexpr auto kHit = c::fields(c::field<&sinew_ground_hit::height_m, &GroundHit::height_m>(),
                                c::field<&sinew_ground_hit::normal, &GroundHit::normal>());

constexpr auto kFrame = c::fields(c::field<&sinew_feet_frame::root, &sinew_feet::feet, &Feet::root>(),
                                  c::field<&sinew_feet_frame::dt_s, &sinew_feet::feet, &Feet::dt_s>(),
                                  c::field<&sinew_feet_frame::find, &sinew_feet::find>(),
                                  c::field<&sinew_feet_frame::context, &sinew_feet::context>());

/// Ground::find of a handle whose caller finds the ground.
bool find_ground_in_c(void* context, std::size_t foot, const Vec3<double>& place, GroundHit& hit) {
  const auto& feet = *static_cast<const sinew_feet*>(context);
  const sinew_point at = c::to_c(place);
  auto found = c::written<sinew_ground_hit>(kHit, hit);
  return feet.find(feet.context, foot, &at, &found) != 0 && kHit.read(found, hit).error == SINEW_OK;
}

void run_feet_on(sinew_feet& feet, const PoseSpan& local, float share) noexcept {
  feet.feet.ground = {feet.find != nullptr ? &find_ground_in_c : nullptr, &feet};
  const PoseProcedure procedure = as_procedure(feet.feet);
  procedure.run(procedure.context, {feet.scene->scene.skeleton, local, {}, {}, share});
}

/// Checks setup and frame of feet, on a pose that is not run.
ErrorCode check_feet(const sinew_feet& feet) {
  PoseMemory pose(feet.scene->scene.skeleton.joint_count());
  FeetState state;
  const FeetJob job{.skeleton = &feet.scene->scene.skeleton,
                    .local = pose.span(),
                    .setup = &feet.feet.setup,
                    .root = feet.feet.root,
                    .dt_s = feet.feet.dt_s,
                    .state = &state};
  return check(job);
}

}  // namespace

sinew_error sinew_foot_on_rest_ground(const sinew_scene* scene, std::uint32_t hip, std::uint32_t knee,
                                      std::uint32_t ankle, std::uint32_t toes, sinew_foot* out) {
  return c::call(c::given(scene, out), [&] {
    const Skeleton& skeleton = scene->scene.skeleton;
    const std::size_t joints = skeleton.joint_count();
    if (hip >= joints || knee >= joints || ankle >= joints || (toes != SINEW_NONE && toes >= joints))
      return SINEW_INDEX_OUT_OF_RANGE;
    *out = c::written<sinew_foot>(kFoot, foot_on_rest_ground(skeleton, hip, knee, ankle, toes));
    return SINEW_OK;
  });
}

sinew_feet_setup sinew_default_feet_setup(void) { return c::written<sinew_feet_setup>(kSetup, ReadFeet{}); }

sinew_error sinew_feet_create(const sinew_scene* scene, const sinew_feet_setup* setup, sinew_feet** out) {
  return c::call(c::given(scene, setup, out), [&] {
    ReadFeet own;
    if (const sinew_error error = c::read_fields(setup, kSetup, own)) return error;
    auto made = std::make_unique<sinew_feet>(sinew_feet{scene, std::move(own.feet), {}});
    made->feet.setup = own.setup;
    made->feet.setup.feet = made->list;
    if (const ErrorCode code = check_feet(*made); code != ErrorCode::ok) return c::error_from(code);
    *out = made.release();
    return SINEW_OK;
  });
}
void sinew_feet_destroy(sinew_feet* feet) { delete feet; }

sinew_feet_frame sinew_default_feet_frame(void) {
  return c::written<sinew_feet_frame>(kFrame, sinew_feet{nullptr, {}, {}});
}

sinew_error sinew_feet_begin_frame(sinew_feet* feet, const sinew_feet_frame* frame) {
  return c::call(c::given(feet, frame), [&] {
    sinew_feet next{nullptr, {}, {}};
    if (const sinew_error error = c::read_fields(frame, kFrame, next)) return error;
    if (const sinew_error error = c::check_step(next.feet.root, next.feet.dt_s)) return error;
    feet->feet.root = next.feet.root;
    feet->feet.dt_s = next.feet.dt_s;
    feet->find = next.find;
    feet->context = next.context;
    return SINEW_OK;
  });
}

sinew_error sinew_feet_procedure(sinew_feet* feet, sinew_pose_procedure* out) {
  return c::call(c::given(feet, out), [&] { *out = {&c::run_procedure<run_feet_on>, feet, 0}; });
}

sinew_error sinew_feet_run(sinew_feet* feet, const sinew_pose* local) {
  return c::call(c::given(feet),
                 [&] { return c::run_at_once<run_feet_on>(*feet, feet->scene->scene.skeleton, local); });
}

sinew_error sinew_get_foot_result(const sinew_feet* feet, std::size_t foot, sinew_foot_result* out) {
  return c::call(c::given(feet), [&] {
    if (foot >= feet->list.size()) return SINEW_INDEX_OUT_OF_RANGE;
    const FootResult& own = feet->feet.results[foot];
    return c::write_struct({.struct_size = 0,
                            .status = c::to_c(own.ik.status),
                            .error = static_cast<std::int32_t>(c::error_from(feet->feet.error)),
                            .is_locked = own.is_locked ? 1u : 0u,
                            .metres_left = own.ik.metres_left,
                            .tip_above_ground_m = own.tip_above_ground_m,
                            .heel_above_ground_m = own.heel_above_ground_m},
                           out);
  });
}

std::size_t sinew_feet_state_bytes(void) { return sizeof(FeetState); }

sinew_error sinew_feet_get_state(const sinew_feet* feet, void* state, std::size_t size) {
  return c::call(c::given(feet),
                 [&] { return c::copy_state(std::as_bytes(std::span(&feet->feet.state, 1)), state, size); });
}

sinew_error sinew_feet_set_state(sinew_feet* feet, const void* state, std::size_t size) {
  return c::call(c::given(feet, state), [&] {
    if (size != sizeof(FeetState)) return SINEW_SIZE_MISMATCH;
    std::memcpy(&feet->feet.state, state, size);
    return SINEW_OK;
  });
}
