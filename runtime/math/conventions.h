// SPDX-License-Identifier: MIT
#pragma once
/// Read this first: the conventions of every header in sinew.
///
/// - Right-handed axes, +Y up, glTF's +Z forward. Metres, seconds, radians.
/// - Column vectors: `p_world = world_from_local * p_local`; in a product adjacent words match.
/// - Quaternions are stored x y z w; the product `a * b` applies b first. q and -q are the same rotation.
/// - A local transform is T * R * S (glTF 2.0, "Transformations"): scale first, translation last.
/// - Normals keep to the outside of a solid, also where a matrix M mirrors it: n' points along sign(det M) cof(M) n,
/// the
///   direction of the inverse transpose without its division (N22). Unskinned meshes, every kind of skinning and flat
///   faces follow this one rule; the linear rule's M n lies on the same side. Mirroring turns the winding of triangles
///   round instead: InstanceResult::mirrored tells (G48). A tangent follows the surface, t' along M t, and keeps its
///   handedness w: the bitangent is w cross(n', t'), negated where the instance is mirrored.
/// - An affine matrix is 3x4 and kept as three rows of four, so that it is 48 bytes, loads without over-reading and
///   can be uploaded to a GPU as three vec4; the fourth row is 0 0 0 1 and never stored.
/// - Every kernel is a template over float and double: double is the truth that tests hold float to.
/// - Same input, same bits (N27, N28), for every thread count: poses on every instruction set; deformed vertices on
/// every one
///   with fused multiply-add (AVX2, AVX-512, NEON, SVE), and on every one without (SSE and the scalar fallback), which
///   round such sums twice: between the two, vertices differ in their last digits. (Rounding once without the hardware,
///   through double, was measured to take 4 to 8 times as long.) Built with contraction off, so that nothing depends on
///   what the compiler fuses; tests/golden holds the bits.
/// - GLM supplies types and plain arithmetic. Its quaternion functions are not used where they fail (N02, N07, N11,
///   N12, N14, N15): those kernels are in this folder.
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace sinew {

template <class T>
using Vec2 = glm::vec<2, T, glm::defaultp>;
template <class T>
using Vec3 = glm::vec<3, T, glm::defaultp>;
template <class T>
using Vec4 = glm::vec<4, T, glm::defaultp>;
template <class T>
using Quat = glm::qua<T, glm::defaultp>;
template <class T>
using Mat3 = glm::mat<3, 3, T, glm::defaultp>;
template <class T>
using Mat4 = glm::mat<4, 4, T, glm::defaultp>;

/// Quaternion from its components in storage order (GLM's own constructor takes w first).
template <class T>
constexpr Quat<T> quat_xyzw(T x, T y, T z, T w) noexcept {
  return Quat<T>(w, x, y, z);
}

}  // namespace sinew
