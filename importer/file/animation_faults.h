// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <set>

#include "importer/file/document.h"

namespace sinew {

/// Broken buffers, buffer views and accessors, by their indices.
struct BrokenStores {
  const std::set<std::uint32_t>&buffers, &buffer_views, &accessors;
};

/// True if all bytes of a view were read. This is possible with a broken buffer, which may only be too short.
bool has_its_bytes(const gltf::Document& document, const gltf::BufferView& view) noexcept;

/// True if nothing but animation samplers reads these stores, directly or through a view or an accessor. Then the scene
/// is sound without the animation channels that use them.
/// in    document   references may be out of range
///      spares     accept data that nothing reads as well, because its samplers may have been emptied
/// cost  O(document)
bool only_animations_read(const gltf::Document& document, const BrokenStores& broken, bool spares);

}  // namespace sinew
