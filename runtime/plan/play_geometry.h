// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/plan/deform_primitive.h"
#include "runtime/plan/frame_changes.h"
#include "runtime/plan/visibility.h"

namespace sinew {

/// Asks the sources of all instances that play and are seen for what they show.
/// in   geometry  FrameInput::geometry
/// out  tables.shown
void show_sources(const CompiledPlan& plan, std::span<const GeometryInput> geometry, const Visibility& visibility,
                  const FrameTables& tables, FrameWork& work) noexcept;

/// What an instance shows from its source, and how that places it.
/// in   geometry  of the instance;   shown  by its source;   world_from_joint  its joint's matrix
///      root, root_sign  FrameInput::root and the sign of its determinant
/// out  placed    world matrix, winding and flags, on input as the pose has them
PlayedGeometry place_geometry(const CompiledPlan& plan, std::size_t instance, const GeometryInput& geometry,
                              const ShownVertices& shown, const Affine& world_from_joint, const Affine& root,
                              int root_sign, InstanceResult& placed) noexcept;

/// Keeps what an instance plays, with the frame since which it does.
void number_geometry(std::size_t slot, const PlayedGeometry& played, const FrameStep& step) noexcept;

/// Stage geometry_cache for one primitive of an instance that plays, with what it calls for of morph, skin and flat
/// normals: all of its pose where the weight is below 1, else nothing.
/// in   p   index into CompiledPlan::primitives;   pose  of the instance, winding as in the result
/// out  views of the frame's memory
/// cost O(V), and the pose; no allocation. Internal to plan/
DeformedPrimitive play_primitive(const CompiledPlan& plan, std::size_t p, const VertexSource& source,
                                 const PlayedGeometry& played, const InstancePose& pose, FrameMemory memory,
                                 FrameWork& work) noexcept;

}  // namespace sinew
