// SPDX-License-Identifier: MIT
#include "runtime/geometry_cache/geometry_player.h"

#include <algorithm>
#include <bit>

#include "runtime/base/bit_hash.h"
#include "runtime/base/contract.h"
#include "runtime/math/quaternion.h"

namespace sinew {
namespace {

/// Index of the first stream of a mesh among the streams of all meshes.
std::size_t first_stream(const GeometryCache& cache, std::size_t mesh) noexcept {
  std::size_t first = 0;
  for (std::size_t m = 0; m < mesh; ++m) first += cache.meshes()[m].streams.size();
  return first;
}

std::vector<std::uint32_t> points_of(const GeometryStream& stream, std::span<const std::uint32_t> vertices) {
  std::vector<std::uint32_t> points;
  points.reserve(vertices.size());
  for (const std::uint32_t v : vertices) points.push_back(stream.point_of_vertex[v]);
  return points;
}

/// Identifies the content: equal for two players that play the same file in the same instances.
std::uint64_t content_of(const GeometryCache& cache, std::span<const GeometryBinding> bindings) noexcept {
  const std::uint64_t content = cache.content();
  BitHash hash;
  hash.add(std::span(&content, 1));
  for (const GeometryBinding& b : bindings) {
    const std::uint32_t numbers[] = {b.instance, b.primitive, b.mesh};
    hash.add(std::span(numbers));
  }
  return hash.value();
}

}  // namespace

GeometryPlayer::GeometryPlayer(const GeometryCache& cache, FrameSource frames, const Scene& scene,
                               std::span<const GeometryBinding> bindings, VertexSpace space)
    : cache_(cache), frames_(frames), decoder_(cache), space_(space), content_(content_of(cache, bindings)) {
  CONTRACT(check(cache, scene, bindings) == ErrorCode::ok);
  for (const GeometryBinding& binding : bindings)
    add(binding, scene.meshes[scene.instances[binding.instance].mesh].primitives[binding.primitive]);
  std::sort(instances_.begin(), instances_.end(),
            [](const Instance& a, const Instance& b) { return a.instance < b.instance; });
  for (Instance& instance : instances_)
    std::sort(instance.primitives.begin(), instance.primitives.end(),
              [](const Played& a, const Played& b) { return a.primitive < b.primitive; });
}

void GeometryPlayer::add(const GeometryBinding& binding, const Primitive& primitive) {
  auto at = std::find_if(instances_.begin(), instances_.end(),
                         [&](const Instance& known) { return known.instance == binding.instance; });
  if (at == instances_.end()) at = instances_.insert(at, Instance{binding.instance, {}});
  const GeometryMesh& mesh = cache_.meshes()[binding.mesh];
  const std::vector<std::uint32_t> vertices = *match_vertices(mesh, primitive);
  Played& played = at->primitives.emplace_back();
  played.primitive = binding.primitive;
  played.mesh = binding.mesh;
  played.positions = first_stream(cache_, binding.mesh);
  played.normals = kNoStream;
  played.position_of = points_of(mesh.streams[0], vertices);
  std::size_t most_points = mesh.streams[0].point_count;
  for (std::size_t s = 1; s < mesh.streams.size(); ++s)
    if (mesh.streams[s].kind == GeometryKind::normals) {
      played.normals = played.positions + s;
      played.normal_of = points_of(mesh.streams[s], vertices);
      most_points = std::max<std::size_t>(most_points, mesh.streams[s].point_count);
    }
  points_.resize(std::max(points_.size(), most_points));
}

std::vector<std::uint32_t> GeometryPlayer::instances() const {
  std::vector<std::uint32_t> all;
  for (const Instance& instance : instances_) all.push_back(instance.instance);
  return all;
}

VertexSource GeometryPlayer::source() noexcept {
  VertexSource out;
  out.has = [](const void* player, std::uint32_t instance) noexcept {
    return static_cast<const GeometryPlayer*>(player)->find(instance) != nullptr;
  };
  out.show = [](void* player, std::uint32_t instance, double time_s) noexcept {
    return static_cast<GeometryPlayer*>(player)->show(instance, time_s);
  };
  out.write = [](void* player, std::uint32_t instance, std::uint32_t primitive, std::span<glm::vec3> positions,
                 std::span<glm::vec3> normals) noexcept {
    return static_cast<GeometryPlayer*>(player)->write(instance, primitive, positions, normals);
  };
  out.context = this;
  out.content = content_;
  out.space = space_;
  return out;
}

const GeometryPlayer::Instance* GeometryPlayer::find(std::uint32_t instance) const noexcept {
  const auto at = std::lower_bound(instances_.begin(), instances_.end(), instance,
                                   [](const Instance& known, std::uint32_t i) { return known.instance < i; });
  return at != instances_.end() && at->instance == instance ? &*at : nullptr;
}

Aabb GeometryPlayer::bounds_of_frame(const Instance& instance, std::uint32_t frame) const noexcept {
  Aabb box;
  for (const Played& played : instance.primitives) {
    const Aabb own = cache_.bounds(frame, played.mesh);
    box.add(own.lower);
    box.add(own.upper);
  }
  return box;
}

/// in   part  fraction of the way from the previous frame to `frame`, as in GeometryDecoder
Aabb GeometryPlayer::bounds_between(const Instance& instance, std::uint32_t frame, float part) const noexcept {
  Aabb box = bounds_of_frame(instance, frame);
  if (part < 1.0f) {
    const Aabb before = bounds_of_frame(instance, frame - 1);
    box.add(before.lower);
    box.add(before.upper);
  }
  return box;
}

Aabb GeometryPlayer::bounds(std::uint32_t instance, double time_s) const noexcept {
  const Instance* const known = find(instance);
  if (known == nullptr) return {};
  const auto [frame, part] = cache_.frame_time(time_s);
  return part > 0.0f ? bounds_between(*known, frame + 1, part) : bounds_of_frame(*known, frame);
}

ShownVertices GeometryPlayer::show(std::uint32_t instance, double time_s) noexcept {
  const std::uint64_t decoded_before = decoder_.frames_decoded();
  if (frames_.prefetch != nullptr) frames_.prefetch(frames_.context, decoder_.next_for_time(time_s));
  status_ = decoder_.decode_time(time_s, frames_);
  const Instance* const known = find(instance);
  ShownVertices shown;
  shown.is_late = status_ != GeometryStatus::ok;
  shown.frames_decoded = static_cast<std::uint32_t>(decoder_.frames_decoded() - decoded_before);
  shown.is_there = known != nullptr && decoder_.frame() != kNone;
  if (!shown.is_there) return shown;
  shown.moment = std::uint64_t{decoder_.frame()} << 32 | std::bit_cast<std::uint32_t>(decoder_.part());
  shown.bounds = bounds_between(*known, decoder_.frame(), decoder_.part());
  return shown;
}

bool GeometryPlayer::write(std::uint32_t instance, std::uint32_t primitive, std::span<glm::vec3> positions,
                           std::span<glm::vec3> normals) noexcept {
  const Played& played = find(instance)->primitives[primitive];
  const auto write_stream = [&](std::size_t stream, const GeometryStream& info, std::span<const std::uint32_t> point_of,
                                std::span<glm::vec3> out) {
    const std::span points = std::span(points_).first(info.point_count);
    CONTRACT(decoder_.write_points(stream, points) == GeometryStatus::ok);
    for (std::size_t v = 0; v < out.size(); ++v) out[v] = points[point_of[v]];
  };
  const std::vector<GeometryStream>& streams = cache_.meshes()[played.mesh].streams;
  if (!positions.empty()) write_stream(played.positions, streams[0], played.position_of, positions);
  if (normals.empty() || played.normals == kNoStream) return false;
  write_stream(played.normals, streams[played.normals - played.positions], played.normal_of, normals);
  for (glm::vec3& n : normals) n = normalised_or(n, glm::vec3(0.0f, 1.0f, 0.0f));
  return true;
}

}  // namespace sinew
