// SPDX-License-Identifier: MIT
// An engine with a folder `runtime` of its own, first among its include folders. Exit status 0 when both scenes are
// what they are.
#include <sinew/frame.h>
#include <sinew/plan.h>
#include <sinew/scene.h>

#include "runtime/model/scene.h"

int main() {
  const engine::Scene own;
  sinew::Scene scene;
  finish_scene(scene);
  const sinew::Plan plan = compile_plan(lend(scene), {});
  sinew::FrameBuffer frame(plan);
  return own.characters == 2 && run_plan(plan, {}, frame) == sinew::ErrorCode::ok ? 0 : 1;
}
