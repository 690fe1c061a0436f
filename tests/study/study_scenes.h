// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/plan/run_plan.h"
#include "viewer/app/clip_extent.h"

namespace sinew::viewer {

/// `draws` balls of 256 triangles in rows from the bottom left, 1 apart. The sheet has the aspect ratio 16:9.
Scene sheet_of_balls(std::uint32_t draws);

/// The outline of a person made of 19 balls of 2304 triangles each, 1.75 m high, facing +z.
Scene doll_of_balls();

/// A ball of 100,352 triangles and radius 1.
Scene fine_ball();

/// An unlit plane of 80 m at y = 0, across which a pattern of squares of three sizes repeats 40 times.
/// in   turned  rotates the pattern by 45 degrees
Scene patterned_plane(bool turned);

/// A sphere of radius 1 with tangents along its circles of latitude.
/// in   mapped  adds a normal map that leans all normals to one side
Scene sphere_with_tangents(bool mapped);

/// A scene without motion, its frame and its extent.
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
