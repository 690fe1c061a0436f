// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "viewer/passes/covered_area.h"
#include "viewer/passes/render_options.h"
#include "viewer/passes/view.h"
#include "viewer/upload/frame_upload.h"
#include "viewer/upload/scene_upload.h"

namespace sinew::viewer {

/// Mirrors the push constants of shaders/geometry.glsl.
struct DrawConstants {
  std::array<glm::vec4, 3> view_from_mesh;  ///< rows
  float handedness = 1.0f;                  ///< -1 for mirrored meshes
  float point_size = 1.0f;
  float access_factor = 0.0f;  ///< AccessBlend::factor
};

/// Where the normals of a surface come from.
enum class NormalSource : std::uint8_t {
  none,     ///< points and lines, and triangles without normals
  faces,    ///< each triangle is flat
  vertices  ///< interpolated
};

/// What the shaders of a draw are compiled for.
struct SurfaceFeatures {
  NormalSource normals = NormalSource::none;
  bool tangents = false;
  bool double_sided = false;
  MaterialFeatures material;

  auto operator<=>(const SurfaceFeatures&) const = default;
};

/// One draw call. Each attribute has its own binding: the deformed one, else the mesh's own, else a default of stride
/// 0.
struct Draw {
  std::array<VkBuffer, kAttributeCount> buffers{};
  std::array<VkDeviceSize, kAttributeCount> offsets{}, strides{};
  VkBuffer indices = VK_NULL_HANDLE;
  VkDeviceSize indices_at = 0;
  std::uint32_t index_count = 0;
  VkDescriptorSet material = VK_NULL_HANDLE;
  DrawConstants constants{};
  SurfaceFeatures surface;
  Topology topology = Topology::triangles;
  bool masked = false, mirrored = false;
  bool blended = false;    ///< alpha is coverage
  bool transmits = false;  ///< light passes through, also where alpha covers all
  bool frosted = false;    ///< and what is behind is blurred by roughness
  float distance = 0.0f;   ///< from the eye plane to the centre of the primitive, metres
};

struct DrawnScene;

/// The draws of a frame: opaque and masked ones in the order of the scene; blended ones, and those that light passes
/// through, from far to near. With Transparency::weighted those that only blend are apart, in the order of the scene.
class DrawList {
 public:
  /// Collects the draws of the scenes, without instances that are hidden and primitives that are out of view.
  /// in   aspect  width / height of the picture;   casters  collects what casts shadows, too
  ///      transparency  weighted: what only blends is in weighted(), not in blended()
  /// cost O(primitives); allocates only while the number of draws grows
  void collect(std::span<const DrawnScene> scenes, std::uint32_t slot, const View& view, double aspect,
               float point_size, bool casters = false, Transparency transparency = Transparency::sorted);

  std::span<const Draw> opaque() const noexcept { return opaque_; }
  /// What opaque() may cover.
  const CoveredArea& opaque_area() const noexcept { return opaque_area_; }
  std::span<const Draw> blended() const noexcept { return blended_; }
  std::span<const Draw> weighted() const noexcept { return weighted_; }
  /// Of the bounds of weighted().
  DepthRange weighted_range() const noexcept { return weighted_range_; }
  /// Opaque and masked triangles, also those that are out of view.
  std::span<const Draw> casters() const noexcept { return casters_; }
  bool unlit() const noexcept { return unlit_; }  ///< some draw that is in view is unlit
  /// Some draw that is in view reads the table of the environment for lamps, too.
  bool reads_table() const noexcept { return reads_table_; }
  std::uint32_t hidden() const noexcept { return hidden_; }  ///< instances on hidden nodes
  std::uint32_t out_of_view() const noexcept {
    return out_of_view_;
  }  ///< primitives out of view, counted for each copy

 private:
  /// The frame whose draws are collected.
  struct Frame {
    std::uint32_t slot;
    const View& view;
    double aspect;
    float point_size;
    bool casters;
    Transparency transparency;
  };
  void add(const Frame& frame, const DrawnScene& drawn, std::size_t instance, const Affined& view_from_mesh,
           bool mirrored);
  void add_opaque(const Draw& draw, const Affined& view_from_bounds, const Aabb& bounds);
  void add_weighted(const Draw& draw, const DepthRange& range);

  std::vector<Draw> opaque_, blended_, weighted_, casters_;
  CoveredArea opaque_area_;
  DepthRange weighted_range_;
  bool unlit_ = false, reads_table_ = false;
  std::uint32_t hidden_ = 0, out_of_view_ = 0;
};

}  // namespace sinew::viewer
