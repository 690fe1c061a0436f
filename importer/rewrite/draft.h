// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <deque>
#include <set>
#include <string>
#include <vector>

#include "importer/rewrite/carried_document.h"

/// A rewritten document keeps its JSON, lists and indices. Each file of this folder implements one step on a Draft.
namespace sinew::rewrite {

using gltf::Bytes;
using gltf::Json;

/// The componentType of an accessor.
constexpr int kByte = 5120, kUnsignedByte = 5121, kShort = 5122, kUnsignedShort = 5123, kUnsignedInt = 5125,
              kFloat = 5126;

/// Location of a buffer view's bytes: a range of a block.
struct Part {
  std::uint32_t block = kNone;  ///< kNone = the bytes are missing
  std::size_t offset = 0, length = 0;
};

/// Information that the new file cannot represent.
struct Loss {
  std::string name;  ///< name of a rule or an extension
  std::string json_pointer, detail;
};

/// A document that is being rewritten. Lists keep their order, so that indices in unknown extensions stay valid.
struct Draft {
  Json json;
  std::vector<Bytes> blocks;                ///< buffers of the source, then decoded and new data
  std::vector<Part> parts;                  ///< parallel to json["bufferViews"]
  std::deque<std::vector<std::byte>> made;  ///< owns the new blocks
  /// Candidates for remove_unused(): may have lost their last use.
  std::set<std::uint32_t> spare_views, spare_accessors;
  std::vector<Loss> losses;

  Bytes bytes_of(std::uint32_t view) const {
    const Part& part = parts[view];
    return part.block == kNone ? Bytes{} : blocks[part.block].subspan(part.offset, part.length);
  }

  /// Appends a buffer view for new bytes; returns its index.
  std::uint32_t add_view(std::vector<std::byte> bytes);
  std::uint32_t add_view(Bytes bytes_that_stay);
};

/// Makes a draft from the JSON and the bytes of every view. Views without bytes are losses ("buffer-unread").
Draft make_draft(const CarriedDocument& source);

/// A list of the root object; an empty list if absent.
Json& list_of(Draft& draft, const char* name);

/// An index as a number of JSON, which may be written as 3.0.
inline std::uint32_t index_of(const Json& number) { return static_cast<std::uint32_t>(number.get<double>()); }

/// The extension of an object; null if absent.
inline Json* extension_of(Json& object, const char* name) {
  const auto all = object.find("extensions");
  if (all == object.end() || !all->is_object()) return nullptr;
  const auto found = all->find(name);
  return found == all->end() ? nullptr : &*found;
}

/// Removes an extension of an object; also the member `extensions` if it becomes empty.
void erase_extension(Json& object, const char* name);

/// declare() adds a name to extensionsUsed (and extensionsRequired); undeclare() removes it from both.
void declare(Draft& draft, const char* extension, bool required);
void undeclare(Draft& draft, const char* extension);

}  // namespace sinew::rewrite
