// SPDX-License-Identifier: MIT
#include "importer/tool/bake/bake_points.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "importer/file/sandboxed_files.h"
#include "importer/geometry_cache/read_obj.h"
#include "importer/platform/files.h"
#include "importer/tool/messages.h"
#include "runtime/base/contract.h"

namespace sinew::tool {
namespace {

constexpr std::uint64_t kMostFileBytes = std::uint64_t{4} << 30;

tl::unexpected<ImportError> refuse(const std::string& file, const char* rule, std::string detail) {
  return tl::unexpected(ImportError{file, {Severity::error, rule, "", std::move(detail)}, {}, {}});
}

ImportResult<std::vector<std::byte>> read_file(const std::filesystem::path& path) {
  auto bytes = SandboxedFiles(std::nullopt, kMostFileBytes).read_path(path);
  if (bytes) return std::move(*bytes);
  const bool is_large = bytes.error().kind == FileFault::Kind::too_large;
  return refuse(platform::text_of(path), is_large ? "file-too-large" : "file-unreadable", bytes.error().detail);
}

ImportResult<ObjMesh> read_obj_file(const std::filesystem::path& path) {
  const auto bytes = read_file(path);
  if (!bytes) return tl::unexpected(bytes.error());
  return read_obj({reinterpret_cast<const char*>(bytes->data()), bytes->size()}, platform::text_of(path));
}

TakeMesh mesh_of(std::string name, std::size_t vertices, std::vector<std::uint32_t> triangles) {
  TakeMesh mesh;
  mesh.name = std::move(name);
  mesh.vertex_count = static_cast<std::uint32_t>(vertices);
  mesh.triangles = std::move(triangles);
  mesh.streams.push_back({GeometryKind::positions, {}});
  return mesh;
}

/// in  rest  vertices of the mesh at rest, in the order of the points
ImportResult<PointCache> read_points(const PointsOptions& options, std::span<const glm::vec3> rest,
                                     std::string& found) {
  const auto bytes = read_file(platform::path_of(options.file));
  if (!bytes) return tl::unexpected(bytes.error());
  auto points = read_point_cache(*bytes, options.file, options.fps);
  if (!points) return points;
  if (points->point_count() != rest.size())
    return refuse(options.file, "points-count",
                  fmt::format("{}, and the mesh has {}", counted(points->point_count(), "point"),
                              rest.size() == 1 ? "1 vertex" : fmt::format("{} vertices", rest.size())));
  UpAxis up = options.up.value_or(UpAxis::y);
  if (!options.up) {
    const auto axis = find_up_axis(*points, rest, options.file);
    if (!axis) return tl::unexpected(axis.error());
    up = *axis;
    found = fmt::format("{}: {} is up, since its first frame is the mesh at rest that way", options.file,
                        up == UpAxis::y ? "y" : "z");
  }
  if (up == UpAxis::z) turn_to_y_up(*points);
  return points;
}

BakedPoints moved_by(TakeMesh mesh, PointCache points, std::string found) {
  BakedPoints out;
  out.take.start_s = points.start_s;
  out.take.frame_s = points.frame_s;
  mesh.streams[0].frames = std::move(points.frames);
  out.take.meshes.push_back(std::move(mesh));
  out.found = std::move(found);
  return out;
}

/// A name that ends in a number: the text before the number, the number, and how many digits it has.
struct Numbered {
  std::string before;
  std::uint64_t number = 0;
  std::size_t digits = 0;

  std::string name(std::uint64_t n, const std::string& extension) const {
    return fmt::format("{}{:0{}}{}", before, n, digits, extension);
  }
};

std::optional<Numbered> numbered(const std::string& stem) {
  std::size_t first = stem.size();
  while (first > 0 && stem.size() - first < 18 && std::isdigit(static_cast<unsigned char>(stem[first - 1])) != 0)
    --first;
  if (first == stem.size()) return std::nullopt;
  Numbered out{stem.substr(0, first), 0, stem.size() - first};
  std::from_chars(stem.data() + first, stem.data() + stem.size(), out.number);
  return out;
}

}  // namespace

ImportResult<BakedPoints> bake_points(const std::filesystem::path& obj, const PointsOptions& options) {
  auto mesh = read_obj_file(obj);
  if (!mesh) return tl::unexpected(mesh.error());
  std::string found;
  auto points = read_points(options, mesh->positions, found);
  if (!points) return tl::unexpected(points.error());
  return moved_by(mesh_of(platform::text_of(obj.stem()), mesh->positions.size(), std::move(mesh->triangles)),
                  std::move(*points), std::move(found));
}

ImportResult<BakedPoints> bake_points(const Scene& scene, const PointsOptions& options) {
  if (scene.instances.size() != 1 || scene.meshes.size() != 1 || scene.meshes[0].primitives.size() != 1 ||
      scene.meshes[0].primitives[0].topology != Topology::triangles)
    return refuse(options.file, "points-mesh",
                  "a point cache moves one mesh of triangles, and the scene is not of that kind");
  const Primitive& primitive = scene.meshes[0].primitives[0];
  std::vector<glm::vec3> rest(primitive.vertex_count());
  const auto in_file = [&](std::size_t v) { return primitive.source_vertex.empty() ? v : primitive.source_vertex[v]; };
  for (std::size_t v = 0; v < rest.size(); ++v)
    if (in_file(v) >= rest.size())
      return refuse(options.file, "points-mesh", "the mesh shares its vertices with another one");
  for (std::size_t v = 0; v < rest.size(); ++v) rest[in_file(v)] = primitive.positions[v];
  std::string found;
  auto points = read_points(options, rest, found);
  if (!points) return tl::unexpected(points.error());
  for (auto& frame : points->frames) {
    const std::vector<glm::vec3> by_file = frame;
    for (std::size_t v = 0; v < frame.size(); ++v) frame[v] = by_file[in_file(v)];
  }
  return moved_by(mesh_of(scene.meshes[0].name, rest.size(), primitive.indices), std::move(*points), std::move(found));
}

ImportResult<std::vector<std::filesystem::path>> numbered_obj_files(const std::filesystem::path& first) {
  const auto name = numbered(platform::text_of(first.stem()));
  if (!name)
    return refuse(platform::text_of(first), "obj-frames",
                  "its name ends in no number, and there is no point cache: give --points");
  std::vector<std::filesystem::path> files;
  std::filesystem::path next = first;
  do {
    files.push_back(next);
    next = first.parent_path() /
           platform::path_of(name->name(name->number + files.size(), platform::text_of(first.extension())));
  } while (std::filesystem::exists(next));
  return files;
}

ImportResult<BakedPoints> bake_numbered_obj(const std::vector<std::filesystem::path>& files, double fps) {
  CONTRACT(!files.empty());
  const auto name = numbered(platform::text_of(files.front().stem()));
  BakedPoints out;
  out.take.frame_s = 1.0 / fps;
  for (const std::filesystem::path& path : files) {
    auto mesh = read_obj_file(path);
    if (!mesh) return tl::unexpected(mesh.error());
    if (out.take.meshes.empty())
      out.take.meshes.push_back(mesh_of(name ? name->before : "", mesh->positions.size(), mesh->triangles));
    TakeMesh& taken = out.take.meshes[0];
    if (mesh->positions.size() != taken.vertex_count || mesh->triangles != taken.triangles)
      return refuse(platform::text_of(path), "obj-topology",
                    "it has other faces or another number of vertices than " + platform::text_of(files.front()));
    taken.streams[0].frames.push_back(std::move(mesh->positions));
  }
  out.found = fmt::format("{} to {}: {}", platform::text_of(files.front()), platform::text_of(files.back().filename()),
                          counted(files.size(), "frame"));
  return out;
}

}  // namespace sinew::tool
