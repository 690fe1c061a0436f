// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <deque>
#include <set>
#include <string>
#include <vector>

#include "importer/rewrite/carried_document.h"

/// A document that is written again keeps its JSON, lists and indices. Each file of this folder does one step on a
/// Draft.
namespace sinew::rewrite {

using gltf::Bytes;
using gltf::Json;

/// Where the bytes of a buffer view lie: a part of a block.
struct Part {
  std::uint32_t block = kNone;  ///< kNone = the bytes are missing
  std::size_t offset = 0, length = 0;
};

/// Something that the new file cannot hold.
struct Loss {
  std::string name;  ///< of a rule or an extension
  std::string json_pointer, detail;
};

/// A document on its way to a new file. Lists keep their order, so that indices in extensions that nobody here knows
/// stay right.
struct Draft {
  Json json;
  std::vector<Bytes> blocks;                             ///< buffers of the source, then what was decoded or made
  std::vector<Part> parts;                               ///< parallel to json["bufferViews"]
  std::deque<std::vector<std::byte>> made;               ///< owns the blocks that were made
  std::set<std::uint32_t> spare_views, spare_accessors;  ///< may have lost their last use; remove_unused() looks
  std::vector<Loss> losses;

  Bytes bytes_of(std::uint32_t view) const {
    const Part& part = parts[view];
    return part.block == kNone ? Bytes{} : blocks[part.block].subspan(part.offset, part.length);
  }

  /// Appends a view of its own; returns its index.
  std::uint32_t add_view(std::vector<std::byte> bytes);
  std::uint32_t add_view(Bytes bytes_that_stay);
};

/// Takes the JSON and the bytes of every view. Views without bytes are losses ("buffer-unread").
Draft make_draft(const CarriedDocument& source);

/// The entries of a list of the root object; an empty list where there is none.
Json& list_of(Draft& draft, const char* name);

/// The extension of an object, null where it has none.
inline Json* extension_of(Json& object, const char* name) {
  const auto all = object.find("extensions");
  if (all == object.end() || !all->is_object()) return nullptr;
  const auto found = all->find(name);
  return found == all->end() ? nullptr : &*found;
}

/// Removes an extension of an object, and the member `extensions` with the last one.
void erase_extension(Json& object, const char* name);

/// Adds a name to extensionsUsed, or takes it out of extensionsUsed and extensionsRequired.
void declare(Draft& draft, const char* extension, bool required);
void undeclare(Draft& draft, const char* extension);

}  // namespace sinew::rewrite
