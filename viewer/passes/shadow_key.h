// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "viewer/passes/draw_list.h"
#include "viewer/passes/shadow_view.h"

namespace sinew::viewer {

/// All that shadow maps depend on. Maps are drawn again only when it changes.
class ShadowKey {
 public:
  /// Remembers what the next maps depend on.
  /// in   picture  the images of the maps are made again when it changes
  /// out  true if maps that were drawn for the last key still hold
  bool holds(std::span<const ShadowView> views, std::span<const Caster> casters, VkExtent2D picture);

  /// Forgets the last key. Call it when the images of the maps are gone.
  void forget() noexcept { last_.clear(); }

 private:
  std::vector<std::uint64_t> last_, next_;
};

}  // namespace sinew::viewer
