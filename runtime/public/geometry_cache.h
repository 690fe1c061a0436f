// SPDX-License-Identifier: MIT
#pragma once
/// Vertices of every frame from a .sgeo file, for motion that no skeleton can express. GeometryCache reads the file's
/// tables, bind_by_name finds the meshes of a scene, and GeometryPlayer decodes while frames ask for vertices
/// (FrameInput::geometry). bake_geometry.h writes such files.
///
///     sinew::GeometryPlayer player(cache, frames, scene, bindings);
///     const sinew::GeometryInput playing[] = {player.at(clock.time_s())};
///     run_plan(plan, {.geometry = playing}, frame);
#include "runtime/geometry_cache/bind_geometry.h"
#include "runtime/geometry_cache/frame_window.h"
#include "runtime/geometry_cache/geometry_cache.h"
#include "runtime/geometry_cache/geometry_decoder.h"
#include "runtime/geometry_cache/geometry_player.h"
#include "runtime/geometry_cache/scene_of_cache.h"
