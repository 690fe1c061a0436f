// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>

#include "runtime/base/api.h"
#include "runtime/compress/virtual_vertices.h"

namespace sinew {

/// A clip within an error budget.
struct ClipWithin {
  Animation keys;                 ///< the keys that were kept, in authoring form and not rounded; for writing to a file
  Clip clip;                      ///< the compiled clip, with its certificate
  std::uint64_t truth_poses = 0;  ///< number of poses of the authoring form that the search evaluated
};

/// Compiles the smallest clip that the search finds within an error budget. No virtual vertex, in model space, is
/// farther than `budget_m` from its place in the authoring form, at keys and between them. Nearly constant tracks
/// become constant. Keys are dropped where the track's own interpolation restores them. The other keys are rounded to
/// the fewest bits. The budget is shared out along the skeleton by how much an error of each joint moves everything
/// below it (joint_reach.h). The compiled clip is then measured (clip_error.h), and the search goes on. Joints above
/// vertices over the budget get a smaller share, and joints with room get a larger one. The smallest clip within the
/// budget wins. If none is found in kMaxRounds rounds, every key is kept.
///
/// Morph weights share the budget by how far they displace vertices. Properties keep every key: a length in metres
/// means nothing for colours. A budget of 0 keeps everything, bit for bit. The same input always gives the same clip.
/// in   scene     the animation's own scene, finished (scene.h) and checked
///      vertices  of that scene
///      budget_m  in the file's units, >= 0
/// cost seconds for a clip with ten thousand joints, or for one that lasts an hour; allocates
SINEW_API ClipWithin compile_clip_within(const Scene& scene, const Animation& truth, const VirtualVertices& vertices,
                                         double budget_m);
inline constexpr int kMaxRounds = 32;

/// The search of compile_clip_within in parts that several threads may run at the same time. The clip does not depend
/// on how they run. The arguments must outlive it.
/// in   budget_m  > 0
class SINEW_API ClipSearch {
 public:
  static constexpr std::size_t kParts = 2;

  ClipSearch(const Scene& scene, const Animation& truth, const VirtualVertices& vertices, double budget_m);
  ~ClipSearch();
  ClipSearch(const ClipSearch&) = delete;
  ClipSearch& operator=(const ClipSearch&) = delete;

  void run(std::size_t part);  ///< call once for each part
  ClipWithin take();           ///< the smallest clip that any part found; call after all parts have run

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Compiles all keys of an animation and measures the clip: the result of compile_clip_within for a budget of 0.
SINEW_API Clip compile_and_measure(const Scene& scene, const Animation& keys, const Animation& truth,
                                   const VirtualVertices& vertices, double asked_m);

}  // namespace sinew
