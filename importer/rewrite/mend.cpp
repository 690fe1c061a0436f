// SPDX-License-Identifier: MIT
#include "importer/rewrite/mend.h"

#include <iterator>

#include "importer/write/write_scene.h"

namespace sinew::rewrite {
namespace {

void drop_empty_lists(Json& root) {
  for (auto entry = root.begin(); entry != root.end();)
    entry = entry->is_array() && entry->empty() ? root.erase(entry) : std::next(entry);
}

}  // namespace

void mend(Draft& draft) {
  const bool has_nodes = !list_of(draft, "nodes").empty();
  for (Json& skin : list_of(draft, "skins"))
    if (has_nodes && skin["joints"].empty()) skin["joints"] = Json::array({0});
  for (Json& camera : list_of(draft, "cameras")) {
    const auto lens = camera.find("orthographic");
    if (lens != camera.end() && lens->is_object() && lens->value("zfar", 0.0) <= 0.0)
      (*lens)["zfar"] = lens->value("znear", 0.0) + write::kFarPlane_m;
  }
  drop_empty_lists(draft.json);
}

}  // namespace sinew::rewrite
