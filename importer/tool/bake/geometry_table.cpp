// SPDX-License-Identifier: MIT
#include "importer/tool/bake/geometry_table.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

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

std::string between_text(const GeometryCertificate& certificate) {
  return certificate.between_m < 0.0 ? "" : length_text(certificate.between_m);
}

}  // namespace

std::string geometry_table(const GeometryCache& cache) {
  TextTable table({"#", "mesh", "vertices", "points", "triangles", "asked", "measured", "kept", "between frames"});
  for (std::size_t m = 0; m < cache.meshes().size(); ++m) {
    const GeometryMesh& mesh = cache.meshes()[m];
    const GeometryCertificate& c = mesh.certificate;
    table.add({std::to_string(m), mesh.name.empty() ? "" : in_quotes(mesh.name), std::to_string(mesh.vertex_count),
               std::to_string(mesh.streams[0].point_count), std::to_string(mesh.triangles.size() / 3),
               length_text(c.asked_m), length_text(c.measured_m), c.measured_m <= c.asked_m ? "yes" : "NO",
               between_text(c)});
  }
  const double raw = raw_bytes(cache), bytes = static_cast<double>(cache.file_bytes());
  return table.text() + fmt::format("{} at {:.4g} a second in segments of {}, {}, {:.1f} % of raw floats\n",
                                    counted(cache.frame_count(), "frame"), 1.0 / cache.frame_s(),
                                    cache.segment_frames(), counted(cache.file_bytes(), "byte"),
                                    raw > 0.0 ? 100.0 * bytes / raw : 0.0);
}

nlohmann::ordered_json geometry_json(const GeometryCache& cache) {
  nlohmann::ordered_json out{{"frames", cache.frame_count()},
                             {"segment_frames", cache.segment_frames()},
                             {"start_s", cache.start_s()},
                             {"frame_s", cache.frame_s()},
                             {"bytes", cache.file_bytes()},
                             {"raw_bytes", raw_bytes(cache)},
                             {"meshes", nlohmann::ordered_json::array()}};
  for (const GeometryMesh& mesh : cache.meshes()) {
    const GeometryCertificate& c = mesh.certificate;
    out["meshes"].push_back(
        {{"name", mesh.name},
         {"vertices", mesh.vertex_count},
         {"points", mesh.streams[0].point_count},
         {"triangles", mesh.triangles.size() / 3},
         {"asked_m", c.asked_m},
         {"measured_m", c.measured_m},
         {"between_m", c.between_m < 0.0 ? nlohmann::ordered_json() : nlohmann::ordered_json(c.between_m)}});
  }
  return out;
}

}  // namespace sinew::tool
