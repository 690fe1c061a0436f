// SPDX-License-Identifier: MIT
#include "importer/tool/certificate_table.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "importer/tool/length_text.h"
#include "importer/tool/messages.h"
#include "importer/tool/text_table.h"
#include "runtime/clip/unpack_clip.h"
#include "runtime/pose/pose_memory.h"
#include "runtime/pose/sample_clip.h"

namespace sinew::tool {
namespace {

std::string joint_text(std::uint32_t joint, std::span<const std::string> names) {
  if (joint == kNone) return "";
  if (joint < names.size() && !names[joint].empty()) return in_quotes(names[joint]);
  return fmt::format("joint {}", joint);
}

/// Time of one sample on this machine, in nanoseconds per joint: the median of runs at times all over the clip, joints
/// and weights together. Takes some milliseconds.
double sampling_ns_per_joint(const Clip& clip) {
  constexpr int kRuns = 15, kSamples = 200;
  constexpr double kGolden = 0.61803398874989485;
  const std::size_t joints = clip.joint_count();
  if (joints == 0) return 0.0;
  PoseMemory memory(joints);
  std::vector<float> weights(clip.weight_count());
  std::vector<double> ns;
  double time_s = 0.0;
  for (int r = 0; r < kRuns; ++r) {
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 0; i < kSamples; ++i) {
      time_s = clip.duration_s() > 0.0 ? std::fmod(time_s + kGolden * clip.duration_s(), clip.duration_s()) : 0.0;
      run(SampleClipJob{.clip = &clip, .time_s = time_s, .pose = memory.span(), .weights = weights});
    }
    const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - begin;
    ns.push_back(took.count() / (kSamples * static_cast<double>(joints)));
  }
  std::nth_element(ns.begin(), ns.begin() + kRuns / 2, ns.end());
  return ns[kRuns / 2];
}

}  // namespace

std::string certificate_table(std::span<const Clip> clips, std::span<const std::string> joint_names) {
  TextTable table({"#", "clip", "asked", "measured", "kept", "worst at", "worst time", "keys", "of", "bytes",
                   "of all keys", "bytes/joint/s", "ns/joint", "unpacked"});
  for (std::size_t i = 0; i < clips.size(); ++i) {
    if (!clips[i].certificate()) continue;
    const ClipCertificate& c = *clips[i].certificate();
    const bool asked = std::isfinite(c.asked_m);
    table.add(
        {std::to_string(i), clips[i].name().empty() ? "" : in_quotes(clips[i].name()),
         asked ? length_text(c.asked_m) : "-", length_text(c.measured_m),
         !asked       ? "-"
         : c.is_met() ? "yes"
                      : "NO",
         joint_text(c.worst_joint, joint_names), fmt::format("{:.4g} s", c.worst_time_s), std::to_string(c.kept_keys),
         std::to_string(c.source_keys), std::to_string(c.bytes), std::to_string(c.source_bytes),
         clips[i].duration_s() > 0.0 ? fmt::format("{:.1f}", c.bytes_per_joint_second(clips[i].duration_s())) : "",
         fmt::format("{:.2g}", sampling_ns_per_joint(clips[i])),
         fmt::format("{:.2g}", sampling_ns_per_joint(unpacked(clips[i])))});
  }
  return table.text();
}

}  // namespace sinew::tool
