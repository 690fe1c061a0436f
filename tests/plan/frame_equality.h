// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "runtime/base/bit_hash.h"
#include "runtime/base/same_bits.h"
#include "runtime/plan/frame_result.h"

namespace sinew::test {

inline std::uint64_t hash_shape(const DeformedPrimitive& p) {
  return BitHash().add(p.positions).add(p.normals).add(p.tangents).add(p.colors).value();
}

inline bool same_shape(const DeformedPrimitive& a, const DeformedPrimitive& b) {
  return a.instance == b.instance && a.primitive == b.primitive && same_bits<glm::vec3>(a.positions, b.positions) &&
         same_bits<glm::vec3>(a.normals, b.normals) && same_bits<glm::vec4>(a.tangents, b.tangents) &&
         same_bits<glm::vec4>(a.colors, b.colors) && (a.since_frame == 0) == (b.since_frame == 0);
}

inline bool same_instance(const InstanceResult& a, const InstanceResult& b) {
  return same_bits(a.world_from_mesh, b.world_from_mesh) && same_bits(a.bounds, b.bounds) &&
         a.first_primitive == b.first_primitive && a.mirrored == b.mirrored && a.visible == b.visible &&
         a.from_cache == b.from_cache && a.late == b.late;
}

/// Name of the first part in which two frames differ in any bit, such as "instances[2]"; empty if they are equal. Frame
/// numbers and work counters are not compared.
inline std::string first_difference(const FrameResult& a, const FrameResult& b) {
  if (!same_bits<Affine>(a.model, b.model)) return "model";
  if (!same_bits<float>(a.weights, b.weights)) return "weights";
  if (!same_bits<float>(a.properties, b.properties)) return "properties";
  if (!same_bits<bool>(a.hidden, b.hidden)) return "hidden";
  if (a.palettes.size() != b.palettes.size()) return "palettes";
  for (std::size_t s = 0; s < a.palettes.size(); ++s)
    if (!same_bits<JointMatrix>(a.palettes[s].matrices, b.palettes[s].matrices))
      return "palettes[" + std::to_string(s) + "]";
  if (a.instances.size() != b.instances.size()) return "instances";
  for (std::size_t i = 0; i < a.instances.size(); ++i)
    if (!same_instance(a.instances[i], b.instances[i])) return "instances[" + std::to_string(i) + "]";
  if (a.primitives.size() != b.primitives.size()) return "primitives";
  for (std::size_t p = 0; p < a.primitives.size(); ++p)
    if (!same_shape(a.primitives[p], b.primitives[p])) return "primitives[" + std::to_string(p) + "]";
  return {};
}

}  // namespace sinew::test
