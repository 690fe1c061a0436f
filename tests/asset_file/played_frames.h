// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "runtime/plan/frame_hash.h"
#include "runtime/plan/run_plan.h"

namespace sinew::test {

/// Hashes of poses, vertices, bounds and properties of every clip at four times; of the rest pose if there is no clip.
inline std::vector<std::uint64_t> hashes_of_frames(const Scene& scene, Skinning skinning = Skinning::linear) {
  const Plan plan = compile_plan(lend(scene), {.out = {.bounds = true}, .skin = {.kind = skinning}});
  FrameBuffer frame(plan);
  std::vector<std::uint64_t> hashes;
  for (std::uint32_t clip = 0; clip < scene.clips.size() || clip == 0; ++clip)
    for (const double part : {0.0, 0.3, 0.71, 1.0}) {
      FrameInput input;
      ClipLayer layer{.clip = clip};
      if (clip < scene.clips.size()) {
        layer.time_s = part * scene.clips[clip].duration_s();
        input.layers = {&layer, 1};
      }
      if (run_plan(plan, input, frame) != ErrorCode::ok) return {};
      const FrameResult& result = frame.result();
      BitHash hash;
      hash.add(result.properties);
      for (const InstanceResult& instance : result.instances) {
        const glm::vec3 corners[] = {instance.bounds.lower, instance.bounds.upper};
        hash.add(std::span(corners));
      }
      hashes.insert(hashes.end(), {hash_pose(result), hash_vertices(result), hash.value()});
    }
  return hashes;
}

}  // namespace sinew::test
