// SPDX-License-Identifier: MIT
#include "importer/tool/commands.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "importer/file/regular_file.h"
#include "importer/tool/bake/geometry_table.h"
#include "importer/tool/bake/read_cache.h"
#include "importer/tool/certificate_table.h"
#include "importer/tool/info/info_json.h"
#include "importer/tool/info/info_text.h"
#include "importer/tool/load_file.h"
#include "importer/tool/messages.h"
#include "runtime/clip/clip_file.h"

namespace sinew::tool {
namespace {

using Json = nlohmann::ordered_json;

/// The first bytes of a file, at most `size`; none where it is no regular file.
std::vector<std::byte> read_head(const std::string& path, std::uint64_t size) {
  const RegularFile file(path);
  const auto whole = file.opened() ? file.size() : std::nullopt;
  std::vector<std::byte> bytes(static_cast<std::size_t>(std::min(size, whole.value_or(0))));
  if (!file.read(bytes)) bytes.clear();
  return bytes;
}

Json json_of(const Clip& clip) {
  Json out{{"name", clip.name()},
           {"duration_s", clip.duration_s()},
           {"joints", clip.joint_count()},
           {"weights", clip.weight_count()},
           {"properties", clip.property_count()},
           {"bytes", clip.byte_size()},
           {"certificate", nullptr}};
  if (const auto& c = clip.certificate())
    out["certificate"] = {{"asked_m", c->asked_m},
                          {"measured_m", c->measured_m},
                          {"weights_m", c->weights_m},
                          {"is_met", c->is_met()},
                          {"worst_joint", c->worst_joint == kNone ? Json() : Json(c->worst_joint)},
                          {"worst_time_s", c->worst_time_s},
                          {"times_checked", c->times_checked},
                          {"source_keys", c->source_keys},
                          {"kept_keys", c->kept_keys},
                          {"source_bytes", c->source_bytes},
                          {"bytes", c->bytes},
                          {"bytes_per_joint_second", c->bytes_per_joint_second(clip.duration_s())}};
  return out;
}

/// Prints what a file of compiled clips holds; nothing when the file is none.
std::optional<ExitCode> tell_about_clips(const std::string& file, bool json) {
  if (!looks_like_clips(read_head(file, kClipFileHead))) return std::nullopt;
  const std::vector<std::byte> bytes = read_head(file, std::numeric_limits<std::uint64_t>::max());
  const auto clips = load_clips(bytes);
  if (!clips) {
    return fail_with(ExitCode::input_at_fault, fmt::format("{}: byte {}: {}: {}", file, clips.error().offset,
                                                           clips.error().rule, clips.error().detail));
  }
  if (json) {
    Json out{{"file", file}, {"version", kClipFileVersion}, {"bytes", bytes.size()}, {"compiled_clips", Json::array()}};
    for (const Clip& clip : *clips) out["compiled_clips"].push_back(json_of(clip));
    fmt::print("{}\n", json_text(out));
    return ExitCode::done;
  }
  fmt::print("{}\ncompiled clips, version {}: {} in {} bytes\n{}", file, kClipFileVersion, clips->size(), bytes.size(),
             certificate_table(*clips, {}));
  return ExitCode::done;
}

/// Prints what a geometry cache holds; nothing when the file is none. Reads its head only.
std::optional<ExitCode> tell_about_geometry(const std::string& file, bool json) {
  const auto read = read_cache(file, false);
  if (!read) return std::nullopt;
  if (!*read) return read->error();
  const GeometryCache& cache = (*read)->cache;
  if (json)
    fmt::print("{}\n", json_text({{"file", file}, {"geometry_cache", geometry_json(cache)}}));
  else
    fmt::print("{}\ngeometry cache, version {}\n{}", file, kGeometryFileVersion, geometry_table(cache));
  return ExitCode::done;
}

struct InfoOptions {
  std::string file;
  bool json = false;
};

ExitCode tell_about(const InfoOptions& options) {
  if (const auto outcome = tell_about_clips(options.file, options.json)) return *outcome;
  if (const auto outcome = tell_about_geometry(options.file, options.json)) return *outcome;
  ImportOptions import;
  import.decode_images = false;
  import.probe_images = true;
  const auto file = load_file(options.file, import);
  if (!file) return ExitCode::input_at_fault;
  const nlohmann::ordered_json info = info_json(options.file, *file);
  if (options.json)
    fmt::print("{}\n", json_text(info));
  else
    fmt::print("{}", info_text(info));
  return ExitCode::done;
}

}  // namespace

void add_info(CLI::App& program, ExitCode& outcome) {
  auto options = std::make_shared<InfoOptions>();
  CLI::App* command = program.add_subcommand(
      "info", "Show what a file holds: nodes, meshes, skins, clips, materials, images, extensions");
  command->add_option("FILE", options->file, "A .gltf or .glb file, compiled clips, or a geometry cache")->required();
  command->add_flag("--json", options->json, "Print the same as JSON");
  command->callback([options, &outcome] { outcome = tell_about(*options); });
}

}  // namespace sinew::tool
