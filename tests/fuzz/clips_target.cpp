// SPDX-License-Identifier: MIT
#include <vector>

#include "runtime/clip/clip_file.h"
#include "runtime/pose/sample_clip.h"
#include "tests/clip/clip_fields.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/support/tiny_assets.h"

namespace sinew::fuzz {
namespace {

/// A valid head for the bytes after it, so that the code behind the checksum is reached.
std::vector<std::byte> signed_block(Bytes body) {
  std::vector<std::byte> block = save_clips({});
  block.resize(kClipFileHead);
  block.insert(block.end(), body.begin(), body.end());
  test::sign(block);
  return block;
}

}  // namespace

void load_compiled_clips(Bytes input) {
  if (const auto as_it_is = load_clips(input); !as_it_is)
    require(!as_it_is.error().rule.empty(), "an error names its rule");
  const auto clips = load_clips(signed_block(input));
  if (!clips) return require(clips.error().offset >= kClipFileHead, "an error says where it is");
  std::vector<const Clip*> loaded;
  for (const Clip& clip : *clips) {
    loaded.push_back(&clip);
    test::PoseBuffer pose(clip.joint_count());
    std::vector<float> weights(clip.weight_count()), properties(clip.property_count());
    for (const double time_s : {0.0, 0.37, clip.duration_s()})
      run_unchecked(SampleClipJob{
          .clip = &clip, .time_s = time_s, .pose = pose.span(), .weights = weights, .properties = properties});
  }
  require(load_clips(save_clips(loaded)).has_value(), "what was loaded can be saved and loaded again");
}

}  // namespace sinew::fuzz
