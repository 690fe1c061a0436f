// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "runtime/paging/key_slices.h"

namespace sinew {

/// Whether two clips move the same with tracks of the same kinds and ranges, and rest alike where they move nothing:
/// whether they may be parts of one clip.      cost O(tracks + joints)
bool moves_alike(const Clip& a, const Clip& b);

/// Puts parts that cut_clip made together again. They are given one after another, in time, and may be freed in
/// between.
class ClipJoiner {
 public:
  /// in   head  first_keys of the clip: its name, duration and certificate are those of the clip
  explicit ClipJoiner(const Clip& head);

  /// False where a part does not move what the head moves, or does not begin where the one before it ends; the joiner
  /// is of no use any more then.
  /// cost O(keys of the part + tracks)
  bool add(const Clip& part);

  /// The clip that was cut: it samples the same bits. Once, after at least one part.
  Clip clip();

 private:
  Clip head_;
  std::vector<std::vector<float>> times_s_;   ///< [group]
  std::vector<std::vector<KeySlices>> keys_;  ///< [group][block]
};

}  // namespace sinew
