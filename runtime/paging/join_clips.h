// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "runtime/base/api.h"
#include "runtime/paging/key_slices.h"

namespace sinew {

/// True if two clips may be parts of one clip: they have the same tracks in all but their keys, and the same
/// constants.
/// cost O(tracks + joints)
SINEW_API bool moves_alike(const Clip& a, const Clip& b);

/// Reassembles a clip from the parts that cut_clip made, added in the order of time. A part may be freed once it was
/// added.
class SINEW_API ClipJoiner {
 public:
  /// in   head  first_keys() of the clip; the result has its name, duration and certificate
  explicit ClipJoiner(const Clip& head);

  /// False if the part does not have the tracks of the head, or does not begin where the previous part ends. The
  /// joiner cannot be used any more then.
  /// cost O(keys of the part + tracks)
  bool add(const Clip& part);

  /// The reassembled clip; it samples the same bits as the one that was cut. Call it once, after at least one part.
  Clip clip();

 private:
  Clip head_;
  std::vector<std::vector<float>> times_s_;   ///< [group] key times so far
  std::vector<std::vector<KeySlices>> keys_;  ///< [group][block] keys so far
};

}  // namespace sinew
