// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>

#include "runtime/compress/virtual_vertices.h"

namespace sinew {

/// A clip within a budget, and the keys that it kept: in authoring form and not rounded, for writing to a file.
struct ClipWithin {
  Animation keys;
  Clip clip;                      ///< with its certificate
  std::uint64_t truth_poses = 0;  ///< how many poses of the truth the search evaluated to measure clips
};

/// Compiles the smallest clip in which no virtual vertex, in model space, is farther than `budget_m` from where the
/// truth has it, at keys and between them. Tracks that hardly move become constant, keys are left out where the track's
/// own interpolation brings them back, and the others are rounded to the fewest bits. The budget is shared out along
/// the skeleton by what an error of each joint does to all below it (joint_reach.h). The compiled clip is then measured
/// (clip_error.h): joints above vertices that are off get less, and joints above vertices that all have room get more.
/// The smallest clip that holds is taken; after kMostRounds without one every key is kept.
///
/// Morph weights share the budget through how far they displace vertices. Properties keep every key: a length says
/// nothing about colours. A budget of 0 keeps everything, bit for bit. Same input, same clip.
/// in   scene     the animation's own, finished (scene.h), passed its checks
///      vertices  of that scene
///      budget_m  in the file's units, >= 0
/// cost seconds for ten thousand joints or an hour; allocates
ClipWithin compile_clip_within(const Scene& scene, const Animation& truth, const VirtualVertices& vertices,
                               double budget_m);
inline constexpr int kMostRounds = 32;

/// The search of compile_clip_within in parts, which the caller may run at the same time on several threads. The clip
/// does not depend on how they run. The arguments must outlive it.
/// in   budget_m  > 0
class ClipSearch {
 public:
  static constexpr std::size_t kParts = 2;

  ClipSearch(const Scene& scene, const Animation& truth, const VirtualVertices& vertices, double budget_m);
  ~ClipSearch();
  ClipSearch(const ClipSearch&) = delete;
  ClipSearch& operator=(const ClipSearch&) = delete;

  void run(std::size_t part);  ///< each part once
  ClipWithin take();           ///< the smallest clip that any part found; after all of them

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Compiles the animation as it is and measures it: what compile_clip_within answers for a budget of 0.
Clip compile_and_measure(const Scene& scene, const Animation& keys, const Animation& truth,
                         const VirtualVertices& vertices, double asked_m);

}  // namespace sinew
