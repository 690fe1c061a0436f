// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <string>

#include <tl/expected.hpp>

#include "importer/file/document.h"

namespace draco {
class Mesh;
}

namespace sinew {

/// What the head of a Draco stream promises.
struct DracoSize {
  std::uint32_t faces = 0;
  std::uint32_t vertices = 0;  ///< at least; seams of attributes add more
};

/// Reads only the head, so that sizes can be judged before the decoder allocates for them (G68).
/// err  a sentence for people
tl::expected<DracoSize, std::string> probe_draco(gltf::Bytes stream);

/// err  a sentence for people
tl::expected<std::shared_ptr<const draco::Mesh>, std::string> decode_draco_stream(gltf::Bytes stream);

}  // namespace sinew
