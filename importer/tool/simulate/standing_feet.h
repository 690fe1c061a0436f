// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "importer/import_gltf.h"
#include "importer/tool/simulate/ground_profile.h"
#include "runtime/procedures/feet.h"

namespace sinew::tool {

/// The two feet of a humanoid on ground. It stays where it was made, since its procedure points into it.
class StandingFeet {
 public:
  /// err   a sentence for the user: the character has no legs that are known, or they cannot be used
  static tl::expected<std::unique_ptr<StandingFeet>, std::string> make(const ImportedFile& file, GroundProfile ground);

  /// Joints that feet turn or move: pelvis, thighs, shanks and feet.
  std::vector<std::uint32_t> joints() const;

  const GroundProfile& ground() const noexcept { return ground_; }

  /// Changes a pose of the clip. `starts` forgets the frames before.
  void run(const Skeleton& skeleton, const PoseSpan& pose, const Affined& root, double dt_s, bool starts);

  /// [2] left and right foot in the last run.
  const std::array<FootResult, 2>& results() const noexcept { return results_; }

 private:
  GroundProfile ground_;
  std::array<FootSetup, 2> feet_;
  FeetSetup setup_;
  FeetState state_;
  std::array<FootResult, 2> results_;
};

}  // namespace sinew::tool
