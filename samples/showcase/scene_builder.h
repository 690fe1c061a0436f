// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "runtime/model/scene.h"

namespace sinew::showcase {

/// Builds a Scene piece by piece. Add joints level by level: all roots, then their children, and so on.
class SceneBuilder {
 public:
  std::uint32_t add_material(std::string name, const glm::vec3& base_color, float roughness, float metallic = 0.0f);
  std::uint32_t add_material(Material material);
  std::uint32_t add_texture(Image image, const Sampler& sampler);
  std::uint32_t add_joint(std::string name, std::uint32_t parent, const Transform& rest);
  std::uint32_t add_skin(Skin skin);
  std::uint32_t add_mesh(Mesh mesh);
  void add_instance(std::uint32_t joint, std::uint32_t mesh, std::uint32_t skin = kNone);
  /// Adds a light on its own root joint. It shines along the joint's -z axis.
  void add_light(Light light, const Transform& rest);
  void add_animation(Animation animation);

  /// Adds a static mesh of one primitive on its own root joint. Returns the joint.
  std::uint32_t add_prop(const std::string& name, Primitive primitive, std::uint32_t material,
                         const Transform& rest = {});

  /// Completes the scene. It must pass check(Scene).
  Scene finish();

 private:
  Scene scene_;
  std::vector<std::uint32_t> depth_;
};

}  // namespace sinew::showcase
