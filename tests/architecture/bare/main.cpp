// SPDX-License-Identifier: MIT
// A program without RTTI and exceptions. The jobs and run_plan() that it links are compiled in the same way: frames
// need neither. Exit status 0 if the frame is right.
#include <cstdio>

#include "runtime/plan/run_plan.h"
#include "runtime/playback/playback_clock.h"
#include "tests/scenes/hand_scenes.h"

#if defined(__cpp_exceptions) || defined(__cpp_rtti)
#error "this program is to be compiled with -fno-exceptions -fno-rtti"
#endif

int main() {
  const sinew::Scene scene = sinew::test::arm_scene();
  sinew::Needs needs;
  needs.skin.kind = sinew::Skinning::dual_quaternion;
  const sinew::Plan plan = sinew::compile_plan(lend(scene), needs);
  sinew::FrameBuffer frame(plan);
  sinew::PlaybackClock clock(1.0, sinew::PlayMode::clamp);
  clock.advance(1.0);
  const sinew::ClipLayer layer{0, clock.time_s()};
  if (run_plan(plan, {.layers = {&layer, 1}, .weights = {}, .root = {}}, frame) != sinew::ErrorCode::ok) return 1;
  const glm::vec3 tip = frame.result().primitives[0].positions[1];
  std::printf("the arm's tip is at %.6f %.6f %.6f\n", static_cast<double>(tip.x), static_cast<double>(tip.y),
              static_cast<double>(tip.z));
  return glm::dot(tip - glm::vec3(-1, 1, 0), tip - glm::vec3(-1, 1, 0)) < 1e-10f ? 0 : 1;
}
