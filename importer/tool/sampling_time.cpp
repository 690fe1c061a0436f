// SPDX-License-Identifier: MIT
#include "importer/tool/sampling_time.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include "runtime/pose/pose_memory.h"
#include "runtime/pose/sample_clip.h"

namespace sinew::tool {
namespace {

constexpr int kRuns = 15, kSamples = 200;
constexpr double kGolden = 0.61803398874989485;

}  // namespace

double sampling_ns_per_joint(const Clip& clip) {
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

}  // namespace sinew::tool
