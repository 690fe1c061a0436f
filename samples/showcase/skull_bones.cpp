// SPDX-License-Identifier: MIT
#include "samples/showcase/skull_bones.h"

#include <cmath>

#include "samples/showcase/distances.h"

namespace sinew::showcase {
namespace {

using V = glm::vec3;

/// Mirrors a point to x > 0, the half in which the bones are modelled.
V left_half(const V& p) { return {std::abs(p.x), p.y, p.z}; }

float braincase(const V& p) {
  float d = ellipsoid(p, {0.0f, 4.6f, -1.0f}, {6.9f, 6.9f, 8.0f});
  d = joined(d, ellipsoid(p, {0.0f, 5.2f, 3.3f}, {5.6f, 5.6f, 5.6f}), 2.5f);           // forehead
  d = joined(d, ellipsoid(p, {0.0f, 2.4f, -4.6f}, {5.4f, 4.6f, 4.6f}), 2.0f);          // back of the head
  d = joined(d, ellipsoid(p, {0.0f, -0.4f, 0.0f}, {4.6f, 2.4f, 5.0f}), 2.0f);          // base
  d = joined(d, ellipsoid(p, {2.6f, 6.6f, 5.5f}, {2.7f, 2.5f, 2.5f}), 2.5f);           // frontal eminence
  d = joined(d, rod(p, {5.3f, 0.2f, -0.8f}, {4.9f, -2.5f, -0.2f}, 1.3f, 0.7f), 1.0f);  // mastoid process
  d = carved(d, ellipsoid(p, {9.0f, 1.6f, 5.4f}, {3.9f, 4.4f, 3.4f}), 2.0f);           // temple
  return joined(d, ellipsoid(p, {3.7f, 0.8f, 4.7f}, {1.7f, 2.9f, 2.6f}), 1.0f);        // behind the eye sockets
}

float face(const V& p) {
  const float ridge =
      std::max(arch(p - V(0.0f, -3.7f, kUpperRow.z), kUpperRow.radii, 1.9f, 0.62f), 2.5f - p.z);  // ridge of the teeth
  float d = joined(ellipsoid(p, {0.0f, -1.8f, 5.4f}, {2.9f, 3.2f, 3.6f}), ridge, 1.0f);
  d = joined(d, rod(p, {0.2f, 2.5f, 8.5f}, {0.35f, 0.7f, 9.5f}, 0.60f, 0.40f), 0.9f);  // nasal bone
  d = joined(d, rod(p, {1.3f, 2.2f, 8.2f}, {1.9f, -2.9f, 7.9f}, 0.5f, 0.9f), 1.0f);    // beside the nose
  d = joined(d, rod(p, {0.7f, 3.1f, 8.7f}, {3.2f, 3.75f, 8.3f}, 0.65f, 0.6f), 0.9f);   // brow
  d = joined(d, rod(p, {3.2f, 3.75f, 8.3f}, {5.2f, 2.7f, 6.9f}, 0.6f, 0.55f), 0.7f);
  d = joined(d, rod(p, {5.2f, 2.7f, 6.9f}, {5.1f, -0.4f, 6.8f}, 0.5f, 0.6f), 0.6f);     // outer rim of the socket
  d = joined(d, rod(p, {5.0f, -0.6f, 7.0f}, {1.8f, -0.3f, 8.1f}, 0.75f, 0.55f), 0.9f);  // lower rim
  d = joined(d, ellipsoid(p, {4.5f, -1.5f, 6.9f}, {1.3f, 1.2f, 1.1f}), 1.2f);           // cheekbone
  d = joined(d, rod(p, {4.2f, -2.0f, 6.6f}, {2.6f, -3.4f, 6.2f}, 0.8f, 0.8f), 0.8f);    // from there to the molars
  d = joined(d, rod(p, {5.0f, -1.5f, 6.6f}, {6.4f, -0.9f, 3.9f}, 0.7f, 0.42f), 0.6f);   // arch
  d = joined(d, rod(p, {6.4f, -0.9f, 3.9f}, {6.2f, 0.1f, 0.6f}, 0.42f, 0.6f), 0.3f);
  return joined(d, rod(p, {0.0f, -2.8f, 8.3f}, {0.0f, -2.8f, 9.2f}, 0.35f, 0.15f), 0.6f);  // spine below the nose
}

/// The opening of the nose: half of a pear shape; the septum divides it farther inside.
float nose(const V& p) {
  const float pear = joined(rod(p, {0.0f, 0.1f, 10.0f}, {0.0f, -0.4f, 6.0f}, 0.55f, 0.4f),
                            rod(p, {0.45f, -1.75f, 10.0f}, {0.4f, -1.6f, 5.5f}, 0.85f, 0.7f), 1.2f);
  const float septum = std::max(std::abs(p.x) - 0.09f, p.z - 6.9f);
  return carved(pear, septum, 0.15f);
}

float eye_socket(const V& p) {
  // The axis points back and inwards. The opening is nearly a square with round corners, whose outer side hangs down.
  const V axis = glm::normalize(V(0.40f, -0.06f, 1.0f));
  const V side = glm::normalize(V(1.0f, -0.16f, -0.40f));
  const V up = glm::cross(axis, side);
  const V off = p - V(3.15f, 1.4f, 7.6f);
  const float depth = glm::dot(off, axis), wide = glm::dot(off, side) / 2.0f, high = glm::dot(off, up) / 1.75f;
  const float across = std::cbrt(std::abs(wide * wide * wide) + std::abs(high * high * high));
  return 1.6f * (across - 1.0f - 0.23f * std::min(depth, 1.0f));
}

}  // namespace

float cranium(const V& point) {
  const V p = left_half(point);
  float d = joined(braincase(p), face(p), 0.7f);
  d = carved(d, ellipsoid(p, {2.9f, -2.1f, 8.6f}, {1.0f, 1.1f, 0.9f}), 1.2f);  // hollow above the canine
  d = carved(d, ellipsoid(p, {0.0f, -5.0f, 4.2f}, {2.2f, 1.8f, 3.8f}), 0.5f);  // palate
  d = carved(d, eye_socket(p), 0.35f);
  d = carved(d, nose(p), 0.25f);
  return carved(d, rod(p, {7.5f, 0.0f, -0.1f}, {5.2f, 0.0f, 0.2f}, 0.5f, 0.3f), 0.3f);  // ear canal
}

float mandible(const V& point) {
  const V p = left_half(point + V(0.0f, kJawDrop, 0.0f));
  const float rise = 0.3f * std::max(8.4f - p.z, 0.0f);  // the lower edge rises towards the angle of the jaw
  const float body = arch(p - V(0.0f, -7.9f + 0.65f * rise, 2.0f), {4.2f, 6.1f}, 2.2f - 0.25f * rise, 0.55f);
  const float ridge = arch(p - V(0.0f, -7.0f, kLowerRow.z), kLowerRow.radii, 1.2f, 0.5f);
  float d = carved(joined(body, ridge, 1.0f), p.z - 1.6f, 1.2f);
  d = joined(d, rod(p, {4.6f, -6.1f, 1.8f}, {5.2f, -3.6f, 1.6f}, 0.75f, 0.5f), 1.0f);   // ramus, behind
  d = joined(d, rod(p, {4.5f, -5.8f, 3.3f}, {5.0f, -3.4f, 2.8f}, 0.65f, 0.5f), 1.2f);   // ramus, in front
  d = joined(d, rod(p, {5.2f, -3.6f, 1.6f}, {5.4f, -1.1f, 1.0f}, 0.5f, 0.55f), 0.6f);   // condyle
  d = joined(d, rod(p, {5.0f, -3.4f, 2.9f}, {5.0f, -1.2f, 3.3f}, 0.45f, 0.25f), 0.6f);  // coronoid process
  return joined(d, ellipsoid(p, {0.0f, -8.7f, 8.2f}, {1.5f, 0.7f, 0.7f}), 0.9f);        // chin
}

}  // namespace sinew::showcase
