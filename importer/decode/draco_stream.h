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

/// The sizes that the head of a Draco stream claims.
struct DracoSize {
  std::uint32_t faces = 0;
  std::uint32_t vertices = 0;  ///< a lower bound; attribute seams add more
};

/// Reads only the head, so that sizes can be checked before the decoder allocates memory for them (G68).
/// err   a sentence for people
tl::expected<DracoSize, std::string> probe_draco(gltf::Bytes stream);

/// Decodes a whole stream. No exception leaves it.
/// err   a sentence for people
tl::expected<std::shared_ptr<const draco::Mesh>, std::string> decode_draco_stream(gltf::Bytes stream);

}  // namespace sinew
