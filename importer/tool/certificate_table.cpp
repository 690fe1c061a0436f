// SPDX-License-Identifier: MIT
#include "importer/tool/certificate_table.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "importer/tool/length_text.h"
#include "importer/tool/sampling_time.h"
#include "importer/tool/text_table.h"
#include "runtime/clip/unpack_clip.h"

namespace sinew::tool {
namespace {

std::string quoted(const std::string& name) {
  return name.empty() ? "" : nlohmann::json(name).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string joint_text(std::uint32_t joint, std::span<const std::string> names) {
  if (joint == kNone) return "";
  if (joint < names.size() && !names[joint].empty()) return quoted(names[joint]);
  return fmt::format("joint {}", joint);
}

}  // namespace

std::string certificate_table(std::span<const Clip> clips, std::span<const std::string> joint_names) {
  TextTable table({"#", "clip", "asked", "measured", "kept", "worst at", "worst time", "keys", "of", "bytes",
                   "of all keys", "bytes/joint/s", "ns/joint", "unpacked"});
  for (std::size_t i = 0; i < clips.size(); ++i) {
    if (!clips[i].certificate()) continue;
    const ClipCertificate& c = *clips[i].certificate();
    table.add(
        {std::to_string(i), quoted(clips[i].name()), length_text(c.asked_m), length_text(c.measured_m),
         c.is_met() ? "yes" : "NO", joint_text(c.worst_joint, joint_names), fmt::format("{:.4g} s", c.worst_time_s),
         std::to_string(c.kept_keys), std::to_string(c.source_keys), std::to_string(c.bytes),
         std::to_string(c.source_bytes),
         clips[i].duration_s() > 0.0 ? fmt::format("{:.1f}", c.bytes_per_joint_second(clips[i].duration_s())) : "",
         fmt::format("{:.2g}", sampling_ns_per_joint(clips[i])),
         fmt::format("{:.2g}", sampling_ns_per_joint(unpacked(clips[i])))});
  }
  return table.text();
}

}  // namespace sinew::tool
