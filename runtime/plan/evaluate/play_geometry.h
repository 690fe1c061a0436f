// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/plan/evaluate/deform_primitive.h"
#include "runtime/plan/evaluate/visibility.h"
#include "runtime/plan/frame_tables.h"

namespace sinew {

/// Asks the source of each visible instance that plays for its vertices at the frame's time.
/// in   geometry  FrameInput::geometry
/// out  tables.shown
void show_sources(const CompiledPlan& plan, std::span<const GeometryInput> geometry, const Visibility& visibility,
                  const FrameTables& tables, FrameWork& work) noexcept;

/// How an instance shows its source, and where that places it.
/// in   geometry  of the instance;   shown  by its source;   world_from_joint  its joint's matrix
///      root, root_sign  FrameInput::root and the sign of its determinant
/// out  placed    world matrix, winding and flags, on input as the pose has them
PlayedGeometry place_geometry(const CompiledPlan& plan, std::size_t instance, const GeometryInput& geometry,
                              const ShownVertices& shown, const Affine& world_from_joint, const Affine& root,
                              int root_sign, InstanceResult& placed) noexcept;

/// Stages geometry_cache and flat normals for one primitive of an instance that plays. Where the weight is below 1 the
/// pose is evaluated too, with morph and skin.
/// in   p   index into CompiledPlan::primitives;   pose  of the instance, winding as in the result
/// out  views of the frame's memory
/// cost O(V), and the pose; no allocation. Internal to plan/
DeformedPrimitive play_primitive(const CompiledPlan& plan, std::size_t p, const VertexSource& source,
                                 const PlayedGeometry& played, const InstancePose& pose, FrameMemory memory,
                                 FrameWork& work) noexcept;

}  // namespace sinew
