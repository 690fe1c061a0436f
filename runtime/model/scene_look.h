// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "runtime/model/scene.h"

namespace sinew {

/// One character's copy of the assets that property tracks change, since the scene itself never changes.
struct SceneLook {
  std::vector<Material> materials;
  std::vector<Light> lights;
  std::vector<Camera> cameras;

  SceneLook() = default;
  explicit SceneLook(const Scene& scene) : materials(scene.materials), lights(scene.lights), cameras(scene.cameras) {}
};

TextureUse& texture_of(Material& material, TextureSlot slot) noexcept;

/// The components of a property in the look; empty for node_visible, for which see FrameResult::hidden.
/// in   target   with its index in range
std::span<float> components_of(SceneLook& look, const PropertyTarget& target) noexcept;

/// Writes the property values of a frame into the look.
/// in   values[P]  FrameResult::properties; empty = change nothing;   look  made from the same scene
/// cost O(P), no allocation
void apply_properties(const Scene& scene, std::span<const float> values, SceneLook& look) noexcept;

/// Every property that an animation of the scene animates, with its rest value.
PropertyTable make_property_table(const Scene& scene);

}  // namespace sinew
