// SPDX-License-Identifier: MIT
#include "tests/fuzz/fuzz_targets.h"

#include <array>
#include <stdexcept>

namespace sinew::fuzz {

std::span<const Target> targets() noexcept {
  static constexpr std::array kTargets{Target{"glb", import_glb},           Target{"json", import_json},
                                       Target{"accessors", read_accessors}, Target{"compressed", decode_compressed},
                                       Target{"images", decode_images},     Target{"clips", load_compiled_clips},
                                       Target{"geometry", play_geometry},   Target{"assets", read_asset_files},
                                       Target{"poses", read_poses},         Target{"motion", read_motion},
                                       Target{"graphs", play_graphs},       Target{"graph_bytes", play_graph_bytes}};
  return kTargets;
}

void require(bool holds, const char* promise) {
  if (!holds) throw std::logic_error(promise);
}

}  // namespace sinew::fuzz
