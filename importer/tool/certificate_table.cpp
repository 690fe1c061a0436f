// SPDX-License-Identifier: MIT
#include "importer/tool/certificate_table.h"

#include <cmath>
#include <vector>

#include <fmt/core.h>

#include "importer/tool/length_text.h"
#include "importer/tool/messages.h"
#include "importer/tool/text_table.h"

namespace sinew::tool {
namespace {

std::string joint_text(std::uint32_t joint, std::span<const std::string> names) {
  if (joint == kNone) return "";
  if (joint < names.size() && !names[joint].empty()) return in_quotes(names[joint]);
  return fmt::format("joint {}", joint);
}

}  // namespace

bool keeps_promise(const ClipCertificate& certificate) {
  return certificate.is_met() || (certificate.asked_m == 0.0 && certificate.kept_keys == certificate.source_keys);
}

std::string certified_clips_table(std::span<const CertifiedClip> clips, std::span<const std::string> joint_names) {
  TextTable table({"#", "clip", "asked", "measured", "kept", "worst at", "worst time", "keys", "of", "bytes",
                   "of all keys", "bytes/joint/s"});
  for (const CertifiedClip& clip : clips) {
    const ClipCertificate& c = clip.certificate;
    const bool asked = std::isfinite(c.asked_m);
    table.add({std::to_string(clip.number), clip.name.empty() ? "" : in_quotes(clip.name),
               asked ? length_text(c.asked_m) : "-", length_text(c.measured_m),
               !asked             ? "-"
               : keeps_promise(c) ? "yes"
                                  : "NO",
               joint_text(c.worst_joint, joint_names), fmt::format("{:.4g} s", c.worst_time_s),
               std::to_string(c.kept_keys), std::to_string(c.source_keys), std::to_string(c.bytes),
               std::to_string(c.source_bytes),
               clip.duration_s > 0.0 ? fmt::format("{:.1f}", c.bytes_per_joint_second(clip.duration_s)) : ""});
  }
  return table.text();
}

std::string certificate_table(std::span<const Clip> clips, std::span<const std::string> joint_names) {
  std::vector<CertifiedClip> certified;
  for (std::size_t i = 0; i < clips.size(); ++i) {
    if (!clips[i].certificate()) continue;
    certified.push_back({i, clips[i].name(), clips[i].duration_s(), *clips[i].certificate()});
  }
  return certified_clips_table(certified, joint_names);
}

}  // namespace sinew::tool
