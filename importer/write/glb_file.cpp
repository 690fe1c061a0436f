// SPDX-License-Identifier: MIT
#include "importer/write/glb_file.h"

#include <nlohmann/json.hpp>
#include <span>
#include <sstream>
#include <string>
#include <utility>

#include "importer/write/glb_bytes.h"

namespace sinew::write {
namespace {

using Json = nlohmann::json;

/// Calls `change` for each entry of the member `list`, if it exists.
template <class Change>
void for_each(Json& object, const char* list, Change change) {
  if (const auto found = object.find(list); found != object.end())
    for (auto& entry : *found) change(entry);
}

/// Removes output of tinygltf that glTF forbids: null for an empty object, zfar 0 for infinity, node -1 for a channel
/// without a node.
void mend(Json& root) {
  for (auto& [name, list] : root.items())
    if (list.is_array())
      for (auto& entry : list)
        if (entry.is_null()) entry = Json::object();
  for_each(root, "cameras", [](Json& camera) {
    const auto perspective = camera.find("perspective");
    if (perspective != camera.end() && perspective->at("zfar") == 0.0) perspective->erase("zfar");
  });
  for_each(root, "animations", [](Json& animation) {
    for_each(animation, "channels", [](Json& channel) {
      Json& target = channel["target"];
      if (target.value("node", 0) < 0) target.erase("node");
    });
  });
}

std::string json_text(const tinygltf::Model& model, std::size_t bin_bytes) {
  std::ostringstream stream;
  tinygltf::TinyGLTF().WriteGltfSceneToStream(&model, stream, false, false);
  Json root = Json::parse(std::move(stream).str());
  mend(root);
  if (bin_bytes > 0) root["buffers"] = Json::array({{{"byteLength", bin_bytes}}});
  return root.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::optional<std::vector<std::byte>> glb_file(tinygltf::Model& model) {
  std::vector<unsigned char> bin;
  if (!model.buffers.empty()) bin = std::move(model.buffers[0].data);
  model.buffers.clear();
  const std::string json = json_text(model, bin.size());
  return glb_bytes(json, std::as_bytes(std::span(bin)));
}

}  // namespace sinew::write
