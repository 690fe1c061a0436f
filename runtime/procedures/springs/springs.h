// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "runtime/animation/skeleton.h"
#include "runtime/base/api.h"
#include "runtime/base/result.h"
#include "runtime/procedures/springs/spring_records.h"
#include "runtime/procedures/springs/spring_setup.h"

namespace sinew {

/// Springs of one skeleton, prepared for SpringsJob. Immutable, and shared by all characters on that skeleton.
class SINEW_API Springs {
 public:
  std::size_t joint_count() const noexcept { return joint_count_; }  ///< number of joints of the setup
  std::size_t skeleton_joint_count() const noexcept { return skeleton_joints_; }
  const SpringSettings& settings() const noexcept { return settings_; }

  /// Bytes of a character's state. The caller owns this block, aligned to 8 bytes; a copy of it restores the character.
  std::size_t state_bytes() const noexcept;

  /// Bytes of working memory, aligned to 8. Characters that run one after another may share it.
  std::size_t scratch_bytes() const noexcept;

  /// Private to the job: tables in the order of the skeleton.
  const SpringTables& tables() const noexcept { return tables_; }

 private:
  friend class SpringsCompiler;
  std::size_t joint_count_ = 0, skeleton_joints_ = 0;
  SpringSettings settings_;
  SpringTables tables_;
};

/// The entry of a setup that cannot be used, and why.
struct SpringsFault {
  ErrorCode code = ErrorCode::ok;
  std::string text;  ///< names list, index and rule: "joints[3]: another entry has the same joint"
};

/// Prepares springs. Joints that lie between two joints of a spring keep their animated rotation and are carried along.
/// in   skeleton  of the poses;   setup  indices into that skeleton and into its own lists
/// err  index_out_of_range     a joint, group, collider or centre does not exist, or a joint has two springs
///      not_finite, too_large, negative_weight, not_a_fraction   a number of the setup or the settings
///      unsupported            a joint has a fixed matrix
/// limits  A collider or centre below a swinging joint follows the animated pose. A joint whose tail has no length is
///         carried along.
/// cost O(J + colliders), allocates
SINEW_API tl::expected<Springs, SpringsFault> compile_springs(const Skeleton& skeleton, const SpringSetup& setup,
                                                              const SpringSettings& settings = {});

/// Adds `root` and all joints below it to a setup, depth first, with the values of `like`. The tail of a joint is its
/// first child. A joint without children has its tail at `end_m` metres behind it, in the direction of its own
/// translation, as in VRM 0.
/// limits  A joint with a fixed matrix cannot swing: it is left out, with all below it.
/// cost O(J), allocates
SINEW_API void add_chain_below(const Skeleton& skeleton, std::uint32_t root, const SpringJoint& like, double end_m,
                               SpringSetup& setup);

}  // namespace sinew
