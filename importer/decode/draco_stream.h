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

/// Sizes declared in the header of a Draco stream.
struct DracoSize {
  std::uint32_t faces = 0;
  std::uint32_t vertices = 0;  ///< a lower bound; attribute seams add more
};

/// Reads only the header, so that sizes can be checked before the decoder allocates memory.
/// err   a message for users
tl::expected<DracoSize, std::string> probe_draco(gltf::Bytes stream);

/// Decodes a whole stream. Never throws.
/// err   a message for users
tl::expected<std::shared_ptr<const draco::Mesh>, std::string> decode_draco_stream(gltf::Bytes stream);

}  // namespace sinew
