// SPDX-License-Identifier: MIT
#include "runtime/c/procedures/look_at.h"

#include <cmath>

#include "runtime/c/glue/call.h"
#include "runtime/c/glue/fields.h"
#include "runtime/c/glue/procedures.h"
#include "runtime/c/handles.h"
#include "runtime/procedures/look_at/look_at.h"

using namespace sinew;

namespace sinew::c {

template <>
inline constexpr bool kSameBytes<sinew_gaze_range, GazeRange> = true;
template <>
inline constexpr auto kEnum<EyeKind> = enum_values<EyeKind, sinew_eye_kind>(
    {{EyeKind::joints, SINEW_EYES_ARE_JOINTS}, {EyeKind::weights, SINEW_EYES_ARE_WEIGHTS}});

}  // namespace sinew::c

/// The eyes of one character and their target.
struct sinew_look_at {
  const sinew_scene* scene;
  Eyes eyes;
  LookAt look;
};

namespace {

constexpr auto kEyes = c::fields(
    c::field<&sinew_eyes_setup::kind, &EyesSetup::kind>(), c::field<&sinew_eyes_setup::head, &EyesSetup::head>(),
    c::field<&sinew_eyes_setup::left, &EyesSetup::left>(), c::field<&sinew_eyes_setup::right, &EyesSetup::right>(),
    c::field<&sinew_eyes_setup::between_eyes_m, &EyesSetup::between_eyes_m>(),
    c::field<&sinew_eyes_setup::forward, &EyesSetup::forward>(), c::field<&sinew_eyes_setup::up, &EyesSetup::up>(),
    c::field<&sinew_eyes_setup::inner, &EyesSetup::inner>(), c::field<&sinew_eyes_setup::outer, &EyesSetup::outer>(),
    c::field<&sinew_eyes_setup::down, &EyesSetup::down>(), c::field<&sinew_eyes_setup::upward, &EyesSetup::upward>(),
    c::field<&sinew_eyes_setup::fade_rad, &EyesSetup::fade_rad>());

void run_look_at_on(sinew_look_at& look, const PoseSpan& local, float share) noexcept {
  const PoseProcedure procedure = as_procedure(look.look);
  procedure.run(procedure.context, {look.scene->scene.skeleton, local, {}, {}, share});
}

}  // namespace

sinew_eyes_setup sinew_default_eyes_setup(void) { return c::written<sinew_eyes_setup>(kEyes, EyesSetup{}); }

sinew_error sinew_look_at_create(const sinew_scene* scene, const sinew_eyes_setup* setup, sinew_look_at** out) {
  return c::call(c::given(scene, setup, out), [&] {
    EyesSetup own;
    if (const sinew_error error = c::read_fields(setup, kEyes, own)) return error;
    const auto eyes = prepare_eyes(scene->scene.skeleton, own);
    if (!eyes) return c::error_from(eyes.error());
    *out = new sinew_look_at{scene, *eyes, {}};
    (*out)->look.eyes = &(*out)->eyes;
    (*out)->look.weight = 0.0f;
    return SINEW_OK;
  });
}
void sinew_look_at_destroy(sinew_look_at* look) { delete look; }

sinew_error sinew_look_at_set_target(sinew_look_at* look, const sinew_point* target, float weight) {
  return c::call(c::given(look, target), [&] {
    if (!std::isfinite(target->x) || !std::isfinite(target->y) || !std::isfinite(target->z)) return SINEW_NOT_FINITE;
    if (!(weight >= 0.0f && weight <= 1.0f)) return SINEW_NOT_A_FRACTION;
    look->look.target = {target->x, target->y, target->z};
    look->look.weight = weight;
    return SINEW_OK;
  });
}

sinew_error sinew_look_at_procedure(sinew_look_at* look, sinew_pose_procedure* out) {
  return c::call(c::given(look, out), [&] {
    *out = {&c::run_procedure<run_look_at_on>, look, as_procedure(look->look).version};
  });
}

sinew_error sinew_look_at_run(sinew_look_at* look, const sinew_pose* local) {
  return c::call(c::given(look),
                 [&] { return c::run_at_once<run_look_at_on>(*look, look->scene->scene.skeleton, local); });
}

sinew_error sinew_get_gaze(const sinew_look_at* look, sinew_gaze* out) {
  return c::call(c::given(look), [&] {
    const Gaze& own = look->look.gaze;
    return c::write_struct({.struct_size = 0,
                            .error = static_cast<std::int32_t>(c::error_from(look->look.error)),
                            .yaw_rad = own.yaw_rad,
                            .pitch_rad = own.pitch_rad,
                            .left = own.left,
                            .right = own.right,
                            .up = own.up,
                            .down = own.down,
                            .is_limited = own.is_limited ? 1u : 0u},
                           out);
  });
}
