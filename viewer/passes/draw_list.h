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
  float visibility_factor = 0.0f;  ///< VisibilityBlend::factor
  float padding = 0.0f;
  glm::vec4 shadow_w{0.0f};  ///< shadow maps: view_from_mesh has rows x, y and z of map_from_mesh, this is row w
};

/// Source of a surface's normals.
enum class NormalSource : std::uint8_t {
  none,     ///< points and lines, and triangles without normals
  faces,    ///< one normal per triangle, from derivatives
  vertices  ///< vertex normals, interpolated
};

/// Properties of a draw that select a shader variant.
struct SurfaceFeatures {
  NormalSource normals = NormalSource::none;
  bool tangents = false;
  bool double_sided = false;
  MaterialFeatures material;

  auto operator<=>(const SurfaceFeatures&) const = default;
};

/// One draw call. Each attribute has its own binding: the deformed stream, else the static one, else a default value
/// with stride 0.
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
  bool transmits = false;  ///< KHR_materials_transmission: light passes through, even at alpha 1
  bool frosted = false;    ///< transmits, and roughness blurs what is behind, or a volume refracts it
  float distance = 0.0f;   ///< metres from the eye plane to the primitive's center
};

/// A draw into shadow maps, with all that the maps depend on.
struct Caster {
  Draw draw;
  Affined world_from_mesh;
  std::uint64_t scene = 0;  ///< SceneUpload::number()
  std::uint32_t variant = kNone;
  /// Identifies the shape of a caster that changes: its frame buffer, and the frame since which it is the same. For an
  /// alpha-tested caster that is the newest frame, as its material may be animated. since = 0 means unknown: the caster
  /// counts as changed in every frame.
  std::uint64_t source = 0, since = 0;
};

struct DrawnScene;

/// The draw calls of a frame. Opaque and masked draws are in scene order; blended and transmissive ones are sorted from
/// far to near. With Transparency::weighted, draws that only blend are in a separate list, in scene order.
class DrawList {
 public:
  /// Collects the draws of the scenes. Skips hidden instances and primitives that are out of view.
  /// in   aspect  width / height of the picture;   casters  also collect shadow casters
  ///      transparency  weighted: draws that only blend go to weighted() instead of blended()
  /// cost O(primitives); allocates only while the number of draws grows
  void collect(std::span<const DrawnScene> scenes, std::uint32_t slot, const View& view, double aspect,
               float point_size, bool casters = false, Transparency transparency = Transparency::sorted);

  std::span<const Draw> opaque() const noexcept { return opaque_; }
  /// Screen area that opaque() may cover.
  const CoveredArea& opaque_area() const noexcept { return opaque_area_; }
  std::span<const Draw> blended() const noexcept { return blended_; }
  std::span<const Draw> weighted() const noexcept { return weighted_; }
  /// Range of distances of the draws of weighted().
  DepthRange weighted_range() const noexcept { return weighted_range_; }
  /// Screen area that any draw may cover.
  const CoveredArea& drawn_area() const noexcept { return drawn_area_; }
  /// Opaque and masked triangles, including those out of view.
  std::span<const Caster> casters() const noexcept { return casters_; }
  /// World bounds of the opaque draws and casters; empty = unknown, or there are none.
  Aabb standing() const noexcept { return unbounded_ ? Aabb{} : standing_; }
  bool unlit() const noexcept { return unlit_; }  ///< true if a visible draw is unlit
  /// True if a visible draw needs the split-sum table for direct lights: sheen does.
  bool reads_table() const noexcept { return reads_table_; }
  std::uint32_t hidden() const noexcept { return hidden_; }  ///< number of instances on hidden nodes
  /// Number of primitives outside of the view. If an instance has several copies, each culled copy counts.
  std::uint32_t out_of_view() const noexcept { return out_of_view_; }

 private:
  /// Arguments of collect() for the helpers below.
  struct Frame {
    std::uint32_t slot;
    const View& view;
    double aspect;
    float point_size;
    bool casters;
    Transparency transparency;
  };
  void add(const Frame& frame, const DrawnScene& drawn, std::size_t instance, const Affined& world_from_mesh,
           bool mirrored);
  void add_standing(const Affined& world_from_bounds, const Aabb& bounds);
  void add_opaque(const Draw& draw, const Affined& view_from_bounds, const Aabb& bounds);
  void add_weighted(const Draw& draw, const DepthRange& range);

  std::vector<Draw> opaque_, blended_, weighted_;
  std::vector<Caster> casters_;
  CoveredArea opaque_area_, drawn_area_;
  Aabb standing_;
  bool unbounded_ = false;  ///< something stands there whose bounds are unknown
  DepthRange weighted_range_;
  bool unlit_ = false, reads_table_ = false;
  std::uint32_t hidden_ = 0, out_of_view_ = 0;
};

}  // namespace sinew::viewer
