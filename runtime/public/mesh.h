// SPDX-License-Identifier: MIT
#pragma once
/// Meshes and skins: vertices as arrays of each attribute, joints and weights of each vertex, bind matrices, copies of
/// an instance.
///
///     for (const sinew::Primitive& primitive : scene.meshes[instance.mesh].primitives)
///       upload(primitive.positions, primitive.indices);
///     for_each_copy(instance, world_from_mesh, [&](const sinew::Affine& world) { draw(world); });
#include "runtime/model/mesh.h"
#include "runtime/model/skin.h"
