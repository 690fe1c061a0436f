// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <set>
#include <string>

#include "importer/rewrite/draft.h"

namespace sinew::rewrite {

enum class Referenced : std::uint8_t { accessor, view };

/// Visits every known accessor or buffer view index of a document. These are indices in core glTF 2.0, in known
/// extensions, and in members "accessor" or "bufferView" of any extension.
void for_each_reference(Json& root, const std::function<void(Referenced, Json& index)>& visit);

/// Calls `visit` for every extension object, with its name and JSON pointer. Does not search `extras`.
void for_each_extension(Json& root,
                        const std::function<void(const std::string& name, const std::string& place, Json&)>& visit);

/// Names of unknown extensions that contain numbers. These might be accessor or view indices, which would be wrong
/// after renumbering.
std::set<std::string> extensions_with_unknown_numbers(Json& root);

}  // namespace sinew::rewrite
