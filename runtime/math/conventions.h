// SPDX-License-Identifier: MIT
#pragma once
/// Read this first: the conventions of every header in sinew.
///
/// - Right-handed axes, +Y up, glTF's +Z forward. Metres, seconds, radians.
/// - Column vectors: `p_world = world_from_local * p_local`. Space names on both sides of a `*` are equal: here
///   `local`.
/// - Quaternions are stored x y z w; the product `a * b` applies b first. q and -q are the same rotation.
/// - A local transform is T * R * S (glTF 2.0, "Transformations"): scale first, translation last.
/// - Normals point to the outside of a solid, also where a matrix M mirrors it: n' = normalise(sign(det M) cof(M) n).
///   This is the direction of the inverse transpose; without the division it also exists where M is singular. The sign
///   is exact (determinant_sign.h). Unskinned meshes, every kind of skinning and flat faces follow this rule.
///   Mirroring reverses the winding of triangles instead: InstanceResult::mirrored says so in every frame.
/// - A tangent follows the surface, t' = normalise(M t), and keeps its handedness w. The bitangent is w cross(n', t'),
///   negated where the instance is mirrored.
/// - An affine matrix is 3x4 and stored as three rows of four: 48 bytes, which load without over-reading and upload to
///   a GPU as three vec4. The fourth row is 0 0 0 1 and not stored.
/// - `[J]` in a comment is the length of an array. J counts joints of a skeleton, V vertices of a primitive and T
///   morph targets of a mesh. W counts morph weights of a scene, and P components of its animated properties. K counts
///   keys of a track, or joints that poses of a plan keep.
/// - Functions of this folder are templates over float and double. Tests compare the float results with double.
/// - The same input gives the same bits, for every number of threads. Poses have the same bits on every instruction
///   set. Deformed vertices have one set of bits with fused multiply-add (AVX2, AVX-512, NEON) and another without it
///   (SSE, scalar). The two differ in the last digits, since without it each multiply-add rounds twice. (Emulating it
///   through double took 4 to 8 times as long.) The build turns contraction off, so results do not depend on what a
///   compiler fuses. The tests compare against stored bits (tests/golden).
/// - GLM supplies types and plain arithmetic. This folder replaces those of its functions that lose accuracy or fail
///   in edge cases: opposite or equal quaternions, tiny rotations, matrices near half turns, nearly opposite vectors,
///   and tiny or mirroring scales.
/// - GLM options that change the layout of its types are refused below. A program with another layout than the library
///   would link without an error, and fail when it runs.
#include <cstddef>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "runtime/math/vectors.h"

static_assert(sizeof(glm::dvec3) == 24 && alignof(glm::dvec4) == alignof(double) && alignof(glm::quat) == 4 &&
                  sizeof(glm::mat3) == 36 && alignof(glm::mat4) == 4,
              "sinew needs GLM's packed types: do not define GLM_FORCE_DEFAULT_ALIGNED_GENTYPES.");
static_assert(offsetof(glm::quat, x) == 0 && offsetof(glm::quat, w) == 12,
              "sinew needs GLM's quaternions in the order x y z w: do not define GLM_FORCE_QUAT_DATA_WXYZ.");

// An option of GLM 1.0. A static_assert cannot check the order: not all options leave the constructors constexpr.
#ifdef GLM_FORCE_QUAT_CTOR_XYZW
#error "sinew needs GLM's quaternion constructor to take w first: do not define GLM_FORCE_QUAT_CTOR_XYZW."
#endif

namespace sinew {

template <class T>
using Vec2 = glm::vec<2, T, glm::defaultp>;

/// Quaternion from its components in storage order (GLM's own constructor takes w first).
template <class T>
constexpr Quat<T> quat_xyzw(T x, T y, T z, T w) noexcept {
  return Quat<T>(w, x, y, z);
}

}  // namespace sinew
