// SPDX-License-Identifier: MIT
// A lantern on a hand. It is a model with its own clip, placed on a joint of another character by an offset. The
// lantern has its own plan, and its root is the socket. So both play any clip, and each has its own clock.
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "runtime/math/axis_angle.h"
#include "runtime/plan/run_plan.h"
#include "samples/showcase/scene_builder.h"
#include "samples/showcase/shapes.h"

namespace {

using namespace sinew;

/// A joint that swings about z by `angle_rad` to both sides, once in `duration_s`.
BoneAnimation swing(std::uint32_t joint, float angle_rad, float duration_s) {
  BoneAnimation bone;
  bone.joint = joint;
  bone.rotation.times_s = {0.0f, 0.25f * duration_s, 0.75f * duration_s, duration_s};
  for (const float angle : {0.0f, angle_rad, -angle_rad, 0.0f})
    bone.rotation.values.push_back(quat_from_axis_angle(glm::vec3(0, 0, 1), angle));
  return bone;
}

/// A shoulder, an elbow half a metre below it, and a hand.
Scene make_arm() {
  showcase::SceneBuilder scene;
  const std::uint32_t shoulder = scene.add_joint("shoulder", kNone, {.translation = {0, 1.5f, 0}});
  const std::uint32_t elbow = scene.add_joint("elbow", shoulder, {.translation = {0, -0.3f, 0}});
  scene.add_joint("hand", elbow, {.translation = {0, -0.25f, 0}});
  scene.add_animation({"walk", 1.0, {swing(0, 0.5f, 1.0f), swing(1, 0.3f, 1.0f)}, {}});
  return scene.finish();
}

/// A handle, and below it a box that swings.
Scene make_lantern() {
  showcase::SceneBuilder scene;
  const std::uint32_t handle = scene.add_joint("handle", kNone, {});
  const std::uint32_t box = scene.add_joint("box", handle, {.translation = {0, -0.1f, 0}});
  scene.add_instance(box, scene.add_mesh({"box", {showcase::box({0, 0, 0}, glm::vec3(0.05f))}, {}, {}}));
  scene.add_animation({"sway", 0.7, {swing(handle, 0.4f, 0.7f)}, {}});
  return scene.finish();
}

/// The place on a character at which another model is attached.
struct Socket {
  std::uint32_t joint = 0;
  Affine offset;  ///< offset from the joint, applied before the joint's matrix
};

/// A model and the frame that it is in.
struct Actor {
  explicit Actor(Scene made) : plan(compile_plan(std::move(made), Needs{})), frame(plan) {}

  bool play(double time_s, const Affine& root) {
    const ClipLayer layer{.clip = 0, .time_s = std::fmod(time_s, plan.scene().animations[0].duration_s)};
    return run_plan(plan, {.layers = {&layer, 1}, .root = root}, frame) == ErrorCode::ok;
  }
  Affine at(const Socket& socket) const { return world_of(plan, frame.result().model, socket.joint) * socket.offset; }

  const Plan plan;
  FrameBuffer frame;
};

glm::vec3 place_of(const Affine& matrix) { return {matrix.row[0].w, matrix.row[1].w, matrix.row[2].w}; }

}  // namespace

int main(int argc, char** argv) {
  double seconds = 2.0;
  if (argc > 1) {
    const char* const end = argv[1] + std::strlen(argv[1]);
    const auto [stop, error] = std::from_chars(argv[1], end, seconds);
    if (argc > 2 || error != std::errc{} || stop != end || !(seconds > 0.0 && seconds <= 3600.0)) {
      std::fprintf(stderr, "usage: carry_a_prop [seconds, above 0]\n");
      return 2;
    }
  }
  Actor arm(make_arm()), lantern(make_lantern());
  const Socket grip{*arm.plan.scene().skeleton.find("hand"),
                    affine_from_transform(Transform{.translation = {0, -0.05f, 0.02f}})};
  for (double time_s = 0.0; time_s < seconds; time_s += 0.25) {
    if (!arm.play(time_s, {}) || !lantern.play(time_s, arm.at(grip))) return 1;
    const glm::vec3 held = place_of(arm.at(grip)), handle = place_of(lantern.frame.result().model[0]),
                    box = place_of(lantern.frame.result().instances[0].world_from_mesh);
    std::printf("%5.2f s   hand at %6.3f %6.3f %6.3f   lantern at %6.3f %6.3f %6.3f\n", time_s, held.x, held.y, held.z,
                box.x, box.y, box.z);
    if (glm::distance(held, handle) > 1e-6f || std::abs(glm::distance(handle, box) - 0.1f) > 1e-6f) {
      std::fprintf(stderr, "the lantern is not in the hand\n");
      return 1;
    }
  }
  return 0;
}
