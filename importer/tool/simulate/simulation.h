// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "importer/import_gltf.h"
#include "importer/tool/simulate/ground_profile.h"
#include "importer/tool/simulate/root_path.h"
#include "runtime/procedures/look_at/look_at.h"

namespace sinew::tool {

/// A joint that a simulation computes, after one step.
struct SimulatedJoint {
  Vec4<double> rotation{0.0, 0.0, 0.0, 1.0};  ///< x y z w, local
  Vec3<double> tail{0.0};  ///< World position of the bone's end; of the joint itself if it has no spring.
};

/// The feet, eyes, constraints and springs of a character, stepped frame by frame while a clip plays.
class Simulation {
 public:
  /// in    clip   index, or kNone for the rest pose;   look_at  place in the world that the eyes look at;   ground
  ///       under the feet of a humanoid. The file must outlive the simulation.
  /// err   a sentence for the user: the file has nothing to simulate, or something that cannot be used
  static tl::expected<Simulation, std::string> make(const ImportedFile& file, std::uint32_t clip,
                                                    const std::optional<Vec3<double>>& look_at,
                                                    const std::optional<GroundProfile>& ground);

  Simulation(Simulation&&) noexcept;
  ~Simulation();

  /// Names of the joints that step() returns: first those with springs, then those with constraints alone, then eyes.
  /// With ground, pelvis and legs follow.
  const std::vector<std::string>& joints() const noexcept;
  const std::vector<std::string>& left_out() const noexcept;

  /// Where the character looked in the last step; nothing if it looks at nothing.
  const std::optional<Gaze>& gaze() const noexcept;

  /// Left and right foot in the last step; empty without ground.
  std::span<const FootResult> feet() const noexcept;

  /// Puts springs at rest with the character in its pose at `time_s`.
  void reset(double time_s, const Vec3<double>& root);

  /// Advances by `dt_s` to the pose of the clip at `time_s`.
  const std::vector<SimulatedJoint>& step(double time_s, double dt_s, const Vec3<double>& root);

 private:
  struct Parts;
  explicit Simulation(std::unique_ptr<Parts> parts) noexcept;
  std::unique_ptr<Parts> parts_;
};

}  // namespace sinew::tool
