// SPDX-License-Identifier: MIT
#include "importer/ambient/ray_scene.h"

#if SINEW_EMBREE >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include <glm/geometric.hpp>

namespace sinew {
namespace {

constexpr std::size_t kPacket = 8;

/// An owning Embree handle.
template <class Handle>
using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, void (*)(Handle)>;

/// Embree filter callback: rejects hits on the backs of single-sided triangles.
void reject_back_faces(const RTCFilterFunctionNArguments* query) {
  const auto* triangles = static_cast<const RayTriangle*>(query->geometryUserPtr);
  for (unsigned i = 0; i < query->N; ++i) {
    if (query->valid[i] == 0) continue;
    const RayTriangle& triangle = triangles[RTCHitN_primID(query->hit, query->N, i)];
    const glm::dvec3 direction(RTCRayN_dir_x(query->ray, query->N, i), RTCRayN_dir_y(query->ray, query->N, i),
                               RTCRayN_dir_z(query->ray, query->N, i));
    if (!triangle.both_sides && glm::dot(direction, triangle.normal) >= 0.0) query->valid[i] = 0;
  }
}

#if SINEW_EMBREE >= 4
void cast_ray(RTCScene scene, RTCRayHit& ray) { rtcIntersect1(scene, &ray, nullptr); }
void cast_rays(RTCScene scene, const int* valid, RTCRay8& rays) { rtcOccluded8(valid, scene, &rays, nullptr); }
#else
void cast_ray(RTCScene scene, RTCRayHit& ray) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene, &context, &ray);
}
void cast_rays(RTCScene scene, const int* valid, RTCRay8& rays) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded8(valid, scene, &context, &rays);
}
#endif

/// A packet of eight rays from one point; lanes without a direction are disabled.
RTCRay8 packet_of(const glm::vec3& from, std::span<const glm::dvec3> directions, float limit, int* valid) {
  RTCRay8 rays{};
  for (std::size_t i = 0; i < kPacket; ++i) {
    const bool used = i < directions.size();
    const glm::vec3 direction(used ? directions[i] : glm::dvec3(0.0, 0.0, 1.0));
    valid[i] = used ? -1 : 0;
    rays.org_x[i] = from.x;
    rays.org_y[i] = from.y;
    rays.org_z[i] = from.z;
    rays.dir_x[i] = direction.x;
    rays.dir_y[i] = direction.y;
    rays.dir_z[i] = direction.z;
    rays.tfar[i] = limit;
    rays.mask[i] = ~0u;
  }
  return rays;
}

}  // namespace

struct RayScene::State {
  explicit State(std::vector<RayTriangle> all)
      : triangles(std::move(all)),
        device(rtcNewDevice(nullptr), rtcReleaseDevice),
        scene(device ? rtcNewScene(device.get()) : nullptr, rtcReleaseScene) {
    if (!scene) throw std::runtime_error("ray casting cannot be set up");
    rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
    if (!triangles.empty()) add_geometry();
    rtcCommitScene(scene.get());
    if (rtcGetDeviceError(device.get()) != RTC_ERROR_NONE) throw std::runtime_error("ray casting has no memory");
  }

  void add_geometry() {
    const Owned<RTCGeometry> owned(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE), rtcReleaseGeometry);
    const RTCGeometry geometry = owned.get();
    auto* corners = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), 3 * triangles.size()));
    auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), triangles.size()));
    if (!corners || !indices) throw std::runtime_error("ray casting has no memory");
    std::uint32_t next = 0;
    for (const RayTriangle& triangle : triangles)
      for (const glm::vec3& corner : triangle.corners) {
        *corners++ = corner;
        *indices++ = next++;
      }
    rtcSetGeometryUserData(geometry, triangles.data());
    rtcSetGeometryIntersectFilterFunction(geometry, reject_back_faces);
    rtcSetGeometryOccludedFilterFunction(geometry, reject_back_faces);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene.get(), geometry);
  }

  std::vector<RayTriangle> triangles;
  Owned<RTCDevice> device;
  Owned<RTCScene> scene;
};

RayScene::RayScene(std::vector<RayTriangle> triangles) : state_(std::make_unique<State>(std::move(triangles))) {}
RayScene::~RayScene() = default;

std::optional<RayScene::Hit> RayScene::nearest(const glm::dvec3& from, const glm::dvec3& direction) const {
  RTCRayHit ray{};
  ray.ray.org_x = static_cast<float>(from.x);
  ray.ray.org_y = static_cast<float>(from.y);
  ray.ray.org_z = static_cast<float>(from.z);
  ray.ray.dir_x = static_cast<float>(direction.x);
  ray.ray.dir_y = static_cast<float>(direction.y);
  ray.ray.dir_z = static_cast<float>(direction.z);
  ray.ray.tfar = 1e30f;
  ray.ray.mask = ~0u;
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  cast_ray(state_->scene.get(), ray);
  if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return Hit{ray.hit.primID, static_cast<double>(ray.hit.u), static_cast<double>(ray.hit.v)};
}

std::size_t RayScene::open_count(const glm::dvec3& from, std::span<const glm::dvec3> directions,
                                 double distance_m) const {
  std::size_t open = 0;
  const auto limit = static_cast<float>(distance_m);
  for (std::size_t first = 0; first < directions.size(); first += kPacket) {
    const auto some = directions.subspan(first, std::min(kPacket, directions.size() - first));
    alignas(32) int valid[kPacket];
    RTCRay8 rays = packet_of(glm::vec3(from), some, limit, valid);
    cast_rays(state_->scene.get(), valid, rays);
    for (std::size_t i = 0; i < some.size(); ++i) open += rays.tfar[i] >= 0.0f;  // Embree marks a hit by -infinity
  }
  return open;
}

}  // namespace sinew
