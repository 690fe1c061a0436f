// SPDX-License-Identifier: MIT
#include "importer/tool/bake/geometry_table.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include <fmt/core.h>

#include "importer/tool/length_text.h"
#include "importer/tool/messages.h"
#include "importer/tool/text_table.h"

namespace sinew::tool {
namespace {

/// Bytes of the positions of all frames as floats.
double raw_bytes(const GeometryCache& cache) {
  double bytes = 0.0;
  for (const GeometryMesh& mesh : cache.meshes())
    bytes += 12.0 * mesh.vertex_count * cache.frame_count() * static_cast<double>(mesh.streams.size());
  return bytes;
}

std::uint32_t segments(const GeometryCache& cache) { return (cache.frame_count() - 1) / cache.segment_frames() + 1; }

/// Bytes per second of the frames, played at their rate.
double bytes_a_second(const GeometryCache& cache) {
  const double frames = static_cast<double>(cache.file_bytes() - cache.frames()[0].offset);
  return frames / (cache.frame_s() * cache.frame_count());
}

std::string rate_text(double bytes) {
  return bytes < 1e6 ? fmt::format("{:.1f} kB", 1e-3 * bytes) : fmt::format("{:.2f} MB", 1e-6 * bytes);
}

std::string between_text(const GeometryCertificate& certificate) {
  return certificate.between_m < 0.0 ? "" : length_text(certificate.between_m);
}

}  // namespace

const char* name_of(GeometryKind kind) {
  constexpr const char* kNames[] = {"positions", "normals", "colours"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::string error_text(GeometryKind kind, double error) {
  if (kind == GeometryKind::positions) return length_text(error);
  if (kind == GeometryKind::colors) return fmt::format("{:.3g}", error);
  return fmt::format("{:.3g} deg", std::asin(std::min(error, 1.0)) * 180.0 / std::numbers::pi);
}

std::string geometry_table(const GeometryCache& cache) {
  TextTable table(
      {"#", "mesh", "stream", "vertices", "points", "triangles", "asked", "measured", "kept", "between frames"});
  for (std::size_t m = 0; m < cache.meshes().size(); ++m) {
    const GeometryMesh& mesh = cache.meshes()[m];
    for (const GeometryStream& stream : mesh.streams) {
      const bool first = &stream == mesh.streams.data();
      table.add({first ? std::to_string(m) : "", first && !mesh.name.empty() ? in_quotes(mesh.name) : "",
                 name_of(stream.kind), std::to_string(mesh.vertex_count), std::to_string(stream.point_count),
                 first ? std::to_string(mesh.triangles.size() / 3) : "", error_text(stream.kind, stream.asked),
                 error_text(stream.kind, stream.measured), stream.measured <= stream.asked ? "yes" : "NO",
                 first ? between_text(mesh.certificate) : ""});
    }
  }
  const double raw = raw_bytes(cache);
  const double bytes = static_cast<double>(cache.file_bytes());
  const std::uint32_t segment = std::min(cache.segment_frames(), cache.frame_count());
  return table.text() + fmt::format(
                            "{} at {:.4g} a second, {}, {:.1f} % of raw floats, {} a second\n"
                            "{} of up to {}; a seek decodes no more\n",
                            counted(cache.frame_count(), "frame"), 1.0 / cache.frame_s(),
                            counted(cache.file_bytes(), "byte"), raw > 0.0 ? 100.0 * bytes / raw : 0.0,
                            rate_text(bytes_a_second(cache)), counted(segments(cache), "segment"),
                            counted(segment, "frame"));
}

Json geometry_json(const GeometryCache& cache) {
  Json out{{"frames", cache.frame_count()}, {"segment_frames", cache.segment_frames()},
           {"segments", segments(cache)},   {"bytes_a_second", bytes_a_second(cache)},
           {"start_s", cache.start_s()},    {"frame_s", cache.frame_s()},
           {"bytes", cache.file_bytes()},   {"raw_bytes", raw_bytes(cache)},
           {"meshes", Json::array()}};
  for (const GeometryMesh& mesh : cache.meshes()) {
    const GeometryCertificate& c = mesh.certificate;
    out["meshes"].push_back({{"name", mesh.name},
                             {"vertices", mesh.vertex_count},
                             {"points", mesh.streams[0].point_count},
                             {"triangles", mesh.triangles.size() / 3},
                             {"asked_m", c.asked_m},
                             {"measured_m", c.measured_m},
                             {"between_m", c.between_m < 0.0 ? Json() : Json(c.between_m)},
                             {"streams", Json::array()}});
    for (const GeometryStream& stream : mesh.streams)
      out["meshes"].back()["streams"].push_back({{"kind", name_of(stream.kind)},
                                                 {"points", stream.point_count},
                                                 {"step", stream.step},
                                                 {"asked", stream.asked},
                                                 {"measured", stream.measured}});
  }
  return out;
}

}  // namespace sinew::tool
