// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/plan/run_plan.h"
#include "viewer/app/clip_extent.h"

namespace sinew::viewer {

/// Balls of 256 triangles side by side, `draws` in all, in rows from the bottom left: 1 apart and as wide as 16:9.
Scene sheet_of_balls(std::uint32_t draws);

/// The outline of a person from 19 balls of 2304 triangles, 1.75 m high, facing +z.
Scene doll_of_balls();

/// A ball of 100,352 triangles and radius 1.
Scene fine_ball();

/// A plane of 80 m at y = 0, 40 times across a pattern of squares of three sizes, as it is, without light.
/// in   turned  the pattern by 45 degrees
Scene patterned_plane(bool turned);

/// A sphere of radius 1 with tangents along its circles of latitude.
/// in   mapped  with a normal map that leans all normals to one side
Scene sphere_with_tangents(bool mapped);

/// A scene that stands still, its frame and its extent.
struct Still {
  explicit Still(Scene made);
  Still(const Still&) = delete;
  Still& operator=(const Still&) = delete;

  Scene scene;
  Plan plan;
  FrameBuffer buffer;
  ClipExtent bounds;
};

}  // namespace sinew::viewer
