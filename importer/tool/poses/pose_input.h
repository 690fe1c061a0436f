// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "importer/import_error.h"
#include "importer/tool/poses/pose.h"

namespace sinew::tool {

/// The facts of a pose file, without the poses themselves.
struct PoseSummary {
  std::optional<double> extent;      ///< the model's size: the longest side of the box around its rest pose
  std::vector<std::uint32_t> clips;  ///< the clip of each entry, in the order of the file; kNone = rest pose
  std::size_t poses = 0;             ///< number of poses of all clips
  std::array<bool, kVertexKinds.size()> kinds{};  ///< vertex arrays that some pose has
  std::set<std::string> bits;                     ///< names of hashes that some pose has

  bool holds(VertexKind kind) const { return kinds[static_cast<std::size_t>(kind)]; }
  friend bool operator==(const PoseSummary&, const PoseSummary&) = default;
};

/// Called with each pose of a file, and the index of its entry in PoseSummary::clips. (An entry may name its clip after
/// its poses.) Returns false to stop.
using PoseSink = std::function<bool(std::size_t clip_entry, const Pose& pose)>;

/// Reads a pose file, .json or .json.gz, told apart by content. Unknown keys are skipped.
/// in    sink  may be empty: then the file is only checked and summarized
/// out   facts about what was read: the whole file, unless the sink stopped before its end
/// err   rules "pose-file" (missing, unreadable, not JSON) and "pose-format" (with the JSON pointer of the wrong
///       value); the sink has then got the poses before it
/// cost  O(file), memory of one pose; a compressed file may unpack to at most 256 times its size
tl::expected<PoseSummary, ImportIssue> read_poses(const std::string& file, const PoseSink& sink = {});

/// The same from text.
tl::expected<PoseSummary, ImportIssue> parse_poses(std::string_view text, const PoseSink& sink = {});

}  // namespace sinew::tool
