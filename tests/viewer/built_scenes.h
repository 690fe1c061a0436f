// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "runtime/model/scene.h"
#include "runtime/plan/frame_result.h"

namespace sinew::viewer {

/// A scene built in code and its frame, to test the renderer without a file or a plan.
class BuiltScene {
 public:
  std::uint32_t add_material(const Material& material);
  /// Adds an instance of a mesh of one primitive; returns its index.
  std::uint32_t add(const Primitive& primitive, std::uint32_t material, const Affine& world_from_mesh = {},
                    bool mirrored = false);
  void add_light(const Light& light, const Affine& world_from_light);

  /// Replaces positions and normals of an instance's primitive, as skinning does.
  void deform(std::uint32_t instance, std::vector<glm::vec3> positions, std::vector<glm::vec3> normals);

  /// The frame of the complete scene. It refers to this object.
  FrameResult frame(std::uint64_t number = 1) const;
  Scene scene;

 private:
  struct Moved {
    std::vector<glm::vec3> positions, normals;
  };
  std::vector<Affine> model_;
  std::vector<InstanceResult> instances_;
  std::vector<Moved> moved_;
  mutable std::vector<DeformedPrimitive> primitives_;
};

/// A plain, rough, non-metallic material.
Material matte(const glm::vec3& color);

Affine translation(const glm::vec3& t);

/// A flat square in the plane y = 0, facing up, with texture coordinates in [0, 1].
Primitive square(float half_size);

/// A box on a floor with a sphere beside it.
BuiltScene box_and_sphere_on_floor();

/// A cylinder along +x from 0 to 2, bent upwards by `angle_rad` at x = 1, as by two bones.
BuiltScene bent_arm(float angle_rad);

}  // namespace sinew::viewer
