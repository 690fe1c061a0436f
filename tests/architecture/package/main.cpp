// SPDX-License-Identifier: MIT
// An engine with its own folder `runtime`, which comes first among its include folders. Exit status 0 if each Scene is
// the right one.
#include <sinew/runtime/plan/run_plan.h>

#include "runtime/model/scene.h"

int main() {
  const engine::Scene own;
  sinew::Scene scene;
  finish_scene(scene);
  const sinew::Plan plan = compile_plan(scene, {});
  sinew::FrameBuffer frame(plan);
  return own.characters == 2 && run_plan(plan, {}, frame) == sinew::ErrorCode::ok ? 0 : 1;
}
