// SPDX-License-Identifier: MIT
#include "importer/geometry_cache/encode_geometry_cache.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>
#include <string>
#include <utility>

#include "importer/geometry_cache/encode_stream.h"
#include "runtime/base/all_below.h"
#include "runtime/base/checksum.h"
#include "runtime/base/contract.h"
#include "runtime/base/index.h"
#include "runtime/clip/byte_stream.h"
#include "runtime/geometry_cache/geometry_decoder.h"
#include "runtime/geometry_cache/geometry_format.h"
#include "runtime/geometry_cache/stored_bytes.h"

namespace sinew {
namespace {

tl::unexpected<ImportError> refuse(const char* rule, std::string detail) {
  return tl::unexpected(ImportError{"", {Severity::error, rule, "", std::move(detail)}, {}, {}});
}

std::optional<ImportError> check_mesh(const TakeMesh& mesh, std::size_t frame_count) {
  const std::string where = "mesh \"" + mesh.name + "\"";
  CONTRACT(!mesh.streams.empty() && mesh.streams[0].kind == GeometryKind::positions);
  for (std::size_t s = 1; s < mesh.streams.size(); ++s) CONTRACT(mesh.streams[s - 1].kind < mesh.streams[s].kind);
  if (mesh.triangles.size() % 3 != 0 || !all_below(mesh.triangles, mesh.vertex_count))
    return refuse("cache-triangles", where + " has a corner that is cut off, or of a vertex that is not there").value();
  for (const TakeStream& stream : mesh.streams) {
    if (stream.frames.empty() || stream.frames.size() != frame_count || mesh.vertex_count > kMaxPoints)
      return refuse("cache-frames", where + " has " + std::to_string(stream.frames.size()) + " frames of " +
                                        std::to_string(frame_count) + ", or too many vertices")
          .value();
    for (std::size_t f = 0; f < stream.frames.size(); ++f) {
      if (stream.frames[f].size() != mesh.vertex_count)
        return refuse("cache-frames", where + " has " + std::to_string(stream.frames[f].size()) +
                                          " vertices in frame " + std::to_string(f) + ", not " +
                                          std::to_string(mesh.vertex_count))
            .value();
      for (std::size_t v = 0; v < stream.frames[f].size(); ++v)
        for (int axis = 0; axis < 3; ++axis)
          if (!std::isfinite(stream.frames[f][v][axis]))
            return refuse("cache-values",
                          where + ": vertex " + std::to_string(v) + " is not finite in frame " + std::to_string(f))
                .value();
    }
  }
  return std::nullopt;
}

/// Quantization grid of a stream.
struct Grid {
  float step = 0.0f;
  double reach = 0.0;  // largest error of a decoded value, in steps
};

/// The coarsest grid that meets the error budget: half the diagonal of a cell equals the budget minus float rounding.
ImportResult<Grid> grid_of(const TakeStream& stream) {
  double largest = 0.0;
  for (const auto& frame : stream.frames)
    for (const glm::vec3& p : frame)
      for (int axis = 0; axis < 3; ++axis) largest = std::max(largest, std::abs(static_cast<double>(p[axis])));
  const double rounding = 2.0 * 0x1p-23 * largest, within = stream.budget - rounding;
  if (!(within >= 0.5 * stream.budget) || !(within > 0x1p-100))
    return refuse("cache-budget", "a budget of " + std::to_string(stream.budget) +
                                      " is below what float holds of numbers up to " + std::to_string(largest));
  const auto step = static_cast<float>(2.0 * within / std::sqrt(3.0));
  return Grid{step, within / static_cast<double>(step) * (1.0 + 1e-7)};
}

void write_table(std::span<const std::uint8_t> bytes, ByteWriter& out) {
  std::vector<std::byte> stored;
  out.add(store_bytes(bytes, stored, kDirectoryZstdLevel));
  out.bytes().insert(out.bytes().end(), stored.begin(), stored.end());
}

std::span<const std::uint8_t> bytes_of(const auto& numbers) {
  return {reinterpret_cast<const std::uint8_t*>(numbers.data()), numbers.size() * sizeof(numbers[0])};
}

void write_mesh(const GeometryMesh& mesh, ByteWriter& out) {
  out.add(std::span<const char>(mesh.name));
  out.add(mesh.vertex_count);
  out.add(static_cast<std::uint32_t>(mesh.triangles.size()));
  write_table(planes_of_numbers(mesh.triangles), out);
  out.add(mesh.certificate.between_m);
  for (const glm::vec3& corner : {mesh.bounds.lower, mesh.bounds.upper})
    for (int axis = 0; axis < 3; ++axis) out.add(corner[axis]);
  out.add(static_cast<std::uint8_t>(mesh.streams.size()));
  for (const GeometryStream& stream : mesh.streams) {
    out.add(static_cast<std::uint8_t>(stream.kind));
    out.add(stream.step);
    out.add(stream.point_count);
    out.add(stream.most_payload);
    out.add(stream.asked);
    out.add(stream.measured);
    write_table(planes_of_numbers(stream.point_of_vertex), out);
    write_table(stream.corners, out);
  }
}

/// Writes the file from the encoded streams.
class FileWriter {
 public:
  FileWriter(const GeometryTake& take, const EncodeGeometryOptions& options) : take_(take), options_(options) {}

  std::vector<GeometryMesh> meshes;
  std::vector<std::vector<std::byte>> frames;  // [frames] bytes of all streams

  void add(const TakeMesh& mesh, std::vector<EncodedStream> streams) {
    GeometryMesh& out = meshes.emplace_back();
    out.name = mesh.name;
    out.vertex_count = mesh.vertex_count;
    if (options_.keep_triangles) out.triangles = mesh.triangles;
    frames.resize(mesh.streams[0].frames.size());
    for (EncodedStream& stream : streams) {
      for (std::size_t f = 0; f < frames.size(); ++f)
        frames[f].insert(frames[f].end(), stream.frames[f].begin(), stream.frames[f].end());
      out.streams.push_back(std::move(stream.info));
    }
  }

  std::vector<std::byte> file() const {
    ByteWriter directory;
    directory.add(take_.start_s);
    directory.add(take_.frame_s);
    directory.add(static_cast<std::uint32_t>(frames.size()));
    directory.add(options_.segment_frames);
    directory.add(static_cast<std::uint32_t>(meshes.size()));
    for (const GeometryMesh& mesh : meshes) write_mesh(mesh, directory);
    std::vector<std::uint32_t> sizes;
    std::vector<std::uint64_t> sums;
    std::uint64_t bytes = 0;
    for (const auto& frame : frames) {
      sizes.push_back(static_cast<std::uint32_t>(frame.size()));
      sums.push_back(checksum(frame));
      bytes += frame.size();
    }
    write_table(planes_of_numbers(sizes), directory);
    write_table(bytes_of(sums), directory);
    write_table(bytes_of(boxes()), directory);
    ByteWriter out;
    for (const char c : kGeometryMagic) out.add(c);
    out.add(kGeometryFileVersion);
    out.add(std::uint32_t{0});
    const std::uint64_t head = kGeometryFileHead + directory.bytes().size();
    out.add(head);
    out.add(head + bytes);
    out.add(checksum(directory.bytes()));
    std::vector<std::byte> file = std::move(out.bytes());
    file.insert(file.end(), directory.bytes().begin(), directory.bytes().end());
    for (const auto& frame : frames) file.insert(file.end(), frame.begin(), frame.end());
    return file;
  }

  /// Bounds of the decoded vertices, for each frame; known only after measuring.
  std::vector<std::vector<Aabb>> boxes_of_mesh;

 private:
  /// Frame bounds quantized relative to the mesh's bounds, rounded outwards plus one step for float rounding.
  std::vector<std::uint16_t> boxes() const {
    std::vector<std::uint16_t> out;
    for (std::size_t f = 0; f < frames.size(); ++f)
      for (std::size_t m = 0; m < meshes.size(); ++m) {
        if (boxes_of_mesh.empty()) {
          out.insert(out.end(), 6, 0);
          continue;
        }
        const Aabb &all = meshes[m].bounds, &box = boxes_of_mesh[m][f];
        const auto part = [&](double from, double to, int axis) {
          const double size = double{all.upper[axis]} - all.lower[axis];
          const double parts = size > 0.0 ? std::floor((to - from) / size * 65535.0) - 1.0 : 0.0;
          return static_cast<std::uint16_t>(std::clamp(parts, 0.0, 65535.0));
        };
        for (int axis = 0; axis < 3; ++axis) out.push_back(part(all.lower[axis], box.lower[axis], axis));
        for (int axis = 0; axis < 3; ++axis) out.push_back(part(box.upper[axis], all.upper[axis], axis));
      }
    return out;
  }

  const GeometryTake& take_;
  const EncodeGeometryOptions& options_;
};

double largest_distance(std::span<const glm::vec3> a, std::span<const glm::vec3> b) {
  double most = 0.0;
  for (std::size_t v = 0; v < a.size(); ++v) most = std::max(most, glm::distance(glm::dvec3(a[v]), glm::dvec3(b[v])));
  return most;
}

/// Decodes all frames as playback does, to measure errors and bounds.
class Measurement {
 public:
  Measurement(const GeometryTake& take, FileWriter& writer)
      : take_(take), writer_(writer), file_(writer.file()), cache_(opened(file_)), decoder_(cache_) {}

  /// Decodes all frames and stores the measurements in the meshes.
  void run() {
    writer_.boxes_of_mesh.assign(take_.meshes.size(), {});
    for (std::uint32_t f = 0; f < cache_.frame_count(); ++f) {
      if (f > 0) measure_between(f);
      CONTRACT(decoder_.decode(f, source_) == GeometryStatus::ok);
      std::size_t stream = 0;
      for (std::size_t m = 0; m < take_.meshes.size(); ++m)
        for (std::size_t s = 0; s < take_.meshes[m].streams.size(); ++s) measure_stream(f, m, s, stream++);
    }
  }

 private:
  static GeometryCache opened(std::span<const std::byte> file) {
    auto cache = GeometryCache::open(file);
    CONTRACT(cache.has_value());
    return std::move(*cache);
  }

  std::span<const glm::vec3> decoded(std::size_t mesh, std::size_t stream) {
    vertices_.resize(take_.meshes[mesh].vertex_count);
    CONTRACT(decoder_.write_vertices(stream, vertices_) == GeometryStatus::ok);
    return vertices_;
  }

  void measure_between(std::uint32_t frame) {
    std::size_t stream = 0;
    for (std::size_t m = 0; m < take_.meshes.size(); stream += take_.meshes[m++].streams.size()) {
      if (take_.meshes[m].between.empty()) continue;
      CONTRACT(decoder_.decode_time(take_.start_s + (frame - 0.5) * take_.frame_s, source_) == GeometryStatus::ok);
      double& most = writer_.meshes[m].certificate.between_m;
      most = std::max(most, largest_distance(decoded(m, stream), take_.meshes[m].between[frame - 1]));
    }
  }

  void measure_stream(std::uint32_t frame, std::size_t m, std::size_t s, std::size_t stream) {
    const TakeStream& truth = take_.meshes[m].streams[s];
    const std::span<const glm::vec3> shown = decoded(m, stream);
    GeometryStream& out = writer_.meshes[m].streams[s];
    out.asked = truth.budget;
    out.measured = std::max(out.measured, largest_distance(shown, truth.frames[frame]));
    if (s > 0) return;
    Aabb box;
    for (const glm::vec3& p : shown) box.add(p);
    if (shown.empty()) box = {glm::vec3(0.0f), glm::vec3(0.0f)};
    writer_.boxes_of_mesh[m].push_back(box);
    Aabb& all = writer_.meshes[m].bounds;
    all.add(box.lower);
    all.add(box.upper);
  }

  const GeometryTake& take_;
  FileWriter& writer_;
  std::vector<std::byte> file_;
  GeometryCache cache_;
  GeometryDecoder decoder_;
  MappedFrames source_{cache_, file_};
  std::vector<glm::vec3> vertices_;
};

}  // namespace

ImportResult<std::vector<std::byte>> encode_geometry_cache(const GeometryTake& take,
                                                           const EncodeGeometryOptions& options) {
  CONTRACT(options.segment_frames > 0);
  if (take.meshes.empty()) return refuse("cache-frames", "there is no mesh");
  const std::size_t frame_count = take.meshes[0].streams.empty() ? 0 : take.meshes[0].streams[0].frames.size();
  FileWriter writer(take, options);
  for (const TakeMesh& mesh : take.meshes) {
    if (auto error = check_mesh(mesh, frame_count)) return tl::unexpected(std::move(*error));
    std::vector<EncodedStream> streams;
    for (const TakeStream& stream : mesh.streams) {
      const auto grid = grid_of(stream);
      if (!grid) return tl::unexpected(grid.error());
      streams.push_back(encode_stream(stream, mesh.triangles, grid->step, grid->reach, options.segment_frames));
    }
    writer.add(mesh, std::move(streams));
  }
  Measurement(take, writer).run();
  return writer.file();
}

}  // namespace sinew
