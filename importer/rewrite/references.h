// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <set>
#include <string>

#include "importer/rewrite/draft.h"

namespace sinew::rewrite {

enum class Referenced : std::uint8_t { accessor, view };

/// Visits every number of a document that is known to be the index of an accessor or a buffer view: those of glTF 2.0,
/// those of the extensions in a table, and members of any extension that are called "accessor" or "bufferView".
void for_each_reference(Json& root, const std::function<void(Referenced, Json& index)>& visit);

/// Calls `visit` for every extension object, with its name and the pointer to it. `extras` are not searched.
void for_each_extension(Json& root,
                        const std::function<void(const std::string& name, const std::string& place, Json&)>& visit);

/// Names of extensions in the document that hold numbers which may be indices of accessors or views: those that no
/// table here knows. Such numbers would be wrong after entries have moved.
std::set<std::string> extensions_with_unknown_numbers(Json& root);

}  // namespace sinew::rewrite
