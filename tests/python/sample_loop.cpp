// SPDX-License-Identifier: MIT
// Prints nanoseconds per joint of a plain loop that samples the first clip of a file. It is measured twice: into one
// pose, and with each pose kept as an array of transforms.
//   sinew-sample-loop FILE POSES REPEATS
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "importer/import_gltf.h"
#include "runtime/pose/pose_memory.h"
#include "runtime/pose/sample_clip.h"

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const auto file = sinew::import_gltf(argv[1]);
  const int poses = std::atoi(argv[2]), repeats = std::atoi(argv[3]);
  if (!file || file->scene.clips.empty() || poses < 1 || repeats < 1) return 1;
  const sinew::Clip& clip = file->scene.clips.front();
  sinew::PoseMemory memory(clip.joint_count());
  std::vector<float> weights(clip.weight_count());
  std::vector<sinew::Transform> kept(static_cast<std::size_t>(poses) * clip.joint_count());
  for (const bool keeps : {false, true}) {
    std::vector<double> ns;
    for (int i = 0; i < repeats; ++i) {
      const auto begin = std::chrono::steady_clock::now();
      sinew::Transform* row = kept.data();
      for (int p = 0; p < poses; ++p) {
        const sinew::SampleClipJob job{.clip = &clip,
                                       .time_s = clip.duration_s() * p / poses,
                                       .pose = memory.span(),
                                       .weights = weights,
                                       .holds_clip = p > 0};
        if (run(job) != sinew::ErrorCode::ok) return 1;
        if (keeps)
          for (std::size_t j = 0; j < clip.joint_count(); ++j) *row++ = job.pose.get(j);
      }
      ns.push_back(std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - begin).count());
    }
    std::sort(ns.begin(), ns.end());
    std::printf("%.3f\n", ns[ns.size() / 2] / poses / static_cast<double>(clip.joint_count()));
  }
}
