// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <vector>

#include "runtime/clip/clip_file.h"
#include "runtime/paging/cut_clip.h"
#include "runtime/paging/page_table.h"
#include "runtime/pose/sample_clip.h"
#include "tests/support/tiny_assets.h"

namespace sinew::test {

/// The pages of a clip as a loader reads them.
inline std::vector<std::vector<std::byte>> pages_of(const Clip& clip, double page_s) {
  std::vector<std::vector<std::byte>> pages;
  for (std::size_t page = 0; page < page_count_of(clip.duration_s(), page_s); ++page) {
    const Clip cut = cut_page(clip, page_s, page);
    const Clip* const saved[] = {&cut};
    pages.push_back(save_clips(saved));
  }
  return pages;
}

/// Pose, morph weights and properties at one time.
inline std::vector<float> numbers_at(const Clip& clip, double time_s) {
  PoseBuffer pose(clip.joint_count());
  std::vector<float> weights(clip.weight_count()), properties(clip.property_count()), numbers;
  run_unchecked(SampleClipJob{&clip, time_s, pose.span(), weights, properties});
  for (std::size_t p = 0; p < PoseSpan::plane_count; ++p)
    numbers.insert(numbers.end(), pose.span().plane(PoseSpan::Plane(p)),
                   pose.span().plane(PoseSpan::Plane(p)) + clip.joint_count());
  numbers.insert(numbers.end(), weights.begin(), weights.end());
  numbers.insert(numbers.end(), properties.begin(), properties.end());
  return numbers;
}

}  // namespace sinew::test
