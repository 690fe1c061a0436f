// SPDX-License-Identifier: MIT
#include "viewer/study/ray_caster.h"

#if SINEW_EMBREE >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "runtime/math/determinant_sign.h"
#include "runtime/math/normal_transform.h"
#include "runtime/model/mesh_copies.h"

namespace sinew::viewer {
namespace {

struct Triangle {
  glm::vec3 corners[3], normals[3];
  glm::dvec3 geometric;
  bool double_sided;
};

/// Adds triangles in world space with counter-clockwise front faces; reverses the winding of mirrored meshes.
void add_triangles(const Primitive& primitive, const DeformedPrimitive& deformed, const Affined& world_from_mesh,
                   bool mirrored, bool double_sided, std::vector<Triangle>& out) {
  const std::span<const glm::vec3> positions =
      deformed.positions.empty() ? std::span<const glm::vec3>(primitive.positions) : deformed.positions;
  const std::span<const glm::vec3> normals =
      deformed.normals.empty() ? std::span<const glm::vec3>(primitive.normals) : deformed.normals;
  const Mat3<double> linear = linear_part(world_from_mesh);
  for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
    Triangle triangle{};
    triangle.double_sided = double_sided;
    glm::dvec3 corners[3];
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t v = primitive.indices[i + (mirrored ? 2 - c : c)];
      corners[c] = transform_point(world_from_mesh, glm::dvec3(positions[v]));
      triangle.corners[c] = glm::vec3(corners[c]);
      if (!normals.empty()) triangle.normals[c] = glm::vec3(transform_normal(linear, glm::dvec3(normals[v])));
    }
    triangle.geometric = normalised_or(glm::cross(corners[1] - corners[0], corners[2] - corners[0]), glm::dvec3(0.0));
    if (triangle.geometric == glm::dvec3(0.0)) continue;
    if (normals.empty() || primitive.flat_normals)
      for (glm::vec3& normal : triangle.normals) normal = glm::vec3(triangle.geometric);
    out.push_back(triangle);
  }
}

std::vector<Triangle> triangles_of(const Scene& scene, const FrameResult& frame) {
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < frame.instances.size(); ++i) {
    const InstanceResult& placed = frame.instances[i];
    if (!placed.visible) continue;
    const Mesh& mesh = scene.meshes[scene.instances[i].mesh];
    for_each_copy(scene.instances[i], affine_cast<double>(placed.world_from_mesh), [&](const Affined& world_from_copy) {
      const bool mirrored = scene.instances[i].copies.empty() ? placed.mirrored : determinant_sign(world_from_copy) < 0;
      for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
        const Primitive& primitive = mesh.primitives[p];
        const Material* material = primitive.material == kNone ? nullptr : &scene.materials[primitive.material];
        if (primitive.topology != Topology::triangles || (material && material->alpha_mode == AlphaMode::blend))
          continue;
        add_triangles(primitive, frame.primitives[placed.first_primitive + p], world_from_copy, mirrored,
                      material && material->double_sided, triangles);
      }
    });
  }
  return triangles;
}

/// Filter callback of Embree: rejects hits on back faces.
void leave_out_back_faces(const RTCFilterFunctionNArguments* asked) {
  const auto& triangle = static_cast<const Triangle*>(asked->geometryUserPtr)[RTCHitN_primID(asked->hit, asked->N, 0)];
  const glm::dvec3 direction(RTCRayN_dir_x(asked->ray, asked->N, 0), RTCRayN_dir_y(asked->ray, asked->N, 0),
                             RTCRayN_dir_z(asked->ray, asked->N, 0));
  if (!triangle.double_sided && glm::dot(direction, triangle.geometric) >= 0.0) asked->valid[0] = 0;
}

RTCRay ray_of(const glm::dvec3& from, const glm::dvec3& direction, double limit) {
  RTCRay ray{};
  ray.org_x = static_cast<float>(from.x);
  ray.org_y = static_cast<float>(from.y);
  ray.org_z = static_cast<float>(from.z);
  ray.dir_x = static_cast<float>(direction.x);
  ray.dir_y = static_cast<float>(direction.y);
  ray.dir_z = static_cast<float>(direction.z);
  ray.tnear = 0.0f;
  ray.tfar = static_cast<float>(limit);
  ray.mask = ~0u;
  return ray;
}

#if SINEW_EMBREE >= 4
void cast_ray(RTCScene scene, RTCRayHit& ray) { rtcIntersect1(scene, &ray, nullptr); }
void cast_ray(RTCScene scene, RTCRay& ray) { rtcOccluded1(scene, &ray, nullptr); }
#else
void cast_ray(RTCScene scene, RTCRayHit& ray) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene, &context, &ray);
}
void cast_ray(RTCScene scene, RTCRay& ray) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(scene, &context, &ray);
}
#endif

double reversed_bits(std::uint32_t i) {
  std::uint32_t reversed = 0;
  for (int bit = 0; bit < 32; ++bit) reversed |= (i >> bit & 1u) << (31 - bit);
  return reversed * 0x1p-32;
}

}  // namespace

struct RayCaster::State {
  explicit State(std::vector<Triangle> all)
      : triangles(std::move(all)), device(rtcNewDevice(nullptr)), scene(device ? rtcNewScene(device) : nullptr) {
    if (!scene) throw std::runtime_error("ray casting cannot be set up");
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    if (!triangles.empty()) add_geometry();
    rtcCommitScene(scene);
    if (rtcGetDeviceError(device) != RTC_ERROR_NONE) throw std::runtime_error("ray casting has no memory");
  }
  ~State() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  void add_geometry() {
    const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* corners = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), 3 * triangles.size()));
    auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), triangles.size()));
    if (!corners || !indices) throw std::runtime_error("ray casting has no memory");
    std::uint32_t next = 0;
    for (const Triangle& triangle : triangles)
      for (const glm::vec3& corner : triangle.corners) {
        *corners++ = corner;
        *indices++ = next++;
      }
    rtcSetGeometryUserData(geometry, triangles.data());
    rtcSetGeometryIntersectFilterFunction(geometry, leave_out_back_faces);
    rtcSetGeometryOccludedFilterFunction(geometry, leave_out_back_faces);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
  }

  std::vector<Triangle> triangles;
  RTCDevice device;
  RTCScene scene;
};

RayCaster::RayCaster(const Scene& scene, const FrameResult& frame)
    : state_(std::make_unique<State>(triangles_of(scene, frame))) {}
RayCaster::~RayCaster() = default;

std::optional<RayCaster::Seen> RayCaster::seen(const glm::dvec3& from, const glm::dvec3& direction) const {
  RTCRayHit ray{ray_of(from, direction, 1e30), {}};
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  cast_ray(state_->scene, ray);
  if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  const Triangle& hit = state_->triangles[ray.hit.primID];
  const double u = static_cast<double>(ray.hit.u), v = static_cast<double>(ray.hit.v), w = 1.0 - u - v;
  const auto between = [&](const glm::vec3* of) {
    return w * glm::dvec3(of[0]) + u * glm::dvec3(of[1]) + v * glm::dvec3(of[2]);
  };
  const glm::dvec3 geometric = glm::dot(direction, hit.geometric) < 0.0 ? hit.geometric : -hit.geometric;
  const glm::dvec3 normal = normalised_or(between(hit.normals), geometric);
  return Seen{between(hit.corners), glm::dot(normal, geometric) < 0.0 ? -normal : normal, geometric};
}

double RayCaster::open_share(const Seen& at, double radius_m, int ray_count) const {
  // Coordinates are floats: the start is moved off its triangle by more than their rounding errors.
  const double off = 0x1p-20 * (std::abs(at.point.x) + std::abs(at.point.y) + std::abs(at.point.z)) + 1e-5 * radius_m;
  const glm::dvec3 from = at.point + off * at.geometric;
  const glm::dvec3 aside = std::abs(at.normal.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 tangent = glm::normalize(glm::cross(at.normal, aside)), bitangent = glm::cross(at.normal, tangent);
  int open = 0;
  for (int i = 0; i < ray_count; ++i) {
    const double angle = 2.0 * std::numbers::pi * reversed_bits(static_cast<std::uint32_t>(i)),
                 height2 = (i + 0.5) / ray_count;  // cos^2 is uniform
    const glm::dvec3 flat = tangent * std::cos(angle) + bitangent * std::sin(angle);
    RTCRay ray = ray_of(from, flat * std::sqrt(1.0 - height2) + at.normal * std::sqrt(height2), radius_m);
    cast_ray(state_->scene, ray);
    open += ray.tfar >= 0.0f;
  }
  return static_cast<double>(open) / ray_count;
}

}  // namespace sinew::viewer
