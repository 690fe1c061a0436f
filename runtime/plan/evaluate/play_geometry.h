// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/plan/evaluate/deform_primitive.h"
#include "runtime/plan/evaluate/visibility.h"
#include "runtime/plan/frame_tables.h"

namespace sinew {

/// Asks the source of each visible instance that plays a geometry cache for its vertices at the frame's time.
/// in   geometry  FrameInput::geometry
/// out  tables.shown
void show_sources(const CompiledPlan& plan, std::span<const GeometryInput> geometry, const Visibility& visibility,
                  const FrameTables& tables, FrameWork& work) noexcept;

/// Finds how an instance shows the vertices of its source, and the world matrix for them.
/// in   geometry  of the instance;   shown  vertices that its source shows;   world_from_joint  matrix of the
///      instance's joint
///      root, root_sign  FrameInput::root and the sign of its determinant
/// out  placed    world matrix, winding and flags; on input they hold the values of the pose
PlayedGeometry place_geometry(const CompiledPlan& plan, std::size_t instance, const GeometryInput& geometry,
                              const ShownVertices& shown, const Affine& world_from_joint, const Affine& root,
                              int root_sign, InstanceResult& placed) noexcept;

/// Runs the stages geometry_cache and flat normals for one primitive of an instance that plays a cache. If the weight
/// of the cache is below 1, the pose is evaluated too, with morph and skin.
/// in   p   index into CompiledPlan::primitives;   pose  of the instance, with the winding of the result
/// out  views of the frame's memory
/// cost O(V), plus morph and skin where the pose is evaluated; no allocation. Internal to plan/
DeformedPrimitive play_primitive(const CompiledPlan& plan, std::size_t p, const VertexSource& source,
                                 const PlayedGeometry& played, const InstancePose& pose, FrameMemory memory,
                                 FrameWork& work) noexcept;

}  // namespace sinew
