// SPDX-License-Identifier: MIT
#include <string_view>
#include <vector>

#include "importer/formats/bvh_model.h"
#include "tests/fuzz/fuzz_targets.h"

namespace sinew::fuzz {
namespace {

/// Larger files take long and reveal nothing new.
constexpr std::size_t kMostJoints = 64, kMostNumbers = 4096;

/// Makes a glTF file, which is held to every rule of the importer: whatever is read can be written.
void make_model(const formats::Bvh& bvh) {
  formats::ModelDraft draft;
  formats::add_bvh(bvh, {}, "clip", draft);
  std::vector<ImportIssue> warnings;
  require(draft.finish("motion", warnings).has_value(), "motion that was read is a valid glTF file");
}

}  // namespace

void read_motion(Bytes input) {
  const auto bvh = formats::read_bvh({reinterpret_cast<const char*>(input.data()), input.size()});
  if (!bvh) {
    require(!bvh.error().rule.empty() && bvh.error().json_pointer.starts_with("line "), "an error names rule and line");
    return;
  }
  require(bvh->values.size() == bvh->frame_count * bvh->channel_count, "all frames are whole");
  require(bvh->values.size() <= input.size(), "no number without text");
  if (bvh->joints.size() <= kMostJoints && bvh->values.size() <= kMostNumbers) make_model(*bvh);
}

}  // namespace sinew::fuzz
