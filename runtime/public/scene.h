// SPDX-License-Identifier: MIT
#pragma once
/// The scene: everything of one file. Importers and readers of asset files make it. A scene that is built by hand needs
/// finish_scene and check once. Assets never change afterwards; a character's state lies in its FrameBuffer (frame.h).
///
///     finish_scene(scene);
///     if (check(scene) != sinew::ErrorCode::ok) return;
///     const sinew::Plan plan = compile_plan(share(std::move(scene)), {});
#include "runtime/model/scene.h"
#include "runtime/model/scene_look.h"
