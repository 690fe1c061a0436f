// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "importer/file/json_tree.h"

namespace sinew {

inline constexpr std::size_t kMaxJsonDepth = 256;

enum class JsonOutcome : std::uint8_t { read, invalid, too_deep };

/// Reads JSON text (RFC 8259) into a tree in one pass. Strings without escapes are not copied, numbers become the
/// nearest doubles. A zero byte behind the root value ends the text.
/// out    tree   holds the root after JsonOutcome::read; its strings point into `text`, which must outlive it
/// err    invalid: no JSON, no UTF-8, or a number beyond double (json_fault.h names the fault);
///        too_deep: nested more than kMaxJsonDepth deep
/// cost   O(text); allocates what the tree needs
JsonOutcome read_json(std::string_view text, JsonBuilder& tree);

}  // namespace sinew
