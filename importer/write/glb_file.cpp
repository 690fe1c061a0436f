// SPDX-License-Identifier: MIT
#include "importer/write/glb_file.h"

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

namespace sinew::write {
namespace {

using Json = nlohmann::json;
constexpr std::uint64_t kLargestGlb = 0xffffffffu;

/// Calls `change` for each entry of the list `list`, if the object has it.
template <class Change>
void for_each(Json& object, const char* list, Change change) {
  if (const auto found = object.find(list); found != object.end())
    for (auto& entry : *found) change(entry);
}

/// Removes what tinygltf writes but glTF forbids: null for an object without properties, a far plane of 0 for infinity,
/// and node -1 for a channel without a node.
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

constexpr std::size_t padded(std::size_t size) { return (size + 3) / 4 * 4; }

class Bytes {
 public:
  explicit Bytes(std::size_t size) { out.reserve(size); }

  void add_u32(std::size_t value) {
    for (int shift = 0; shift < 32; shift += 8) out.push_back(static_cast<std::byte>(value >> shift & 0xffu));
  }

  void add_chunk(std::string_view type, std::span<const std::byte> data, std::byte filler) {
    add_u32(padded(data.size()));
    const auto letters = std::as_bytes(std::span(type));
    out.insert(out.end(), letters.begin(), letters.end());
    out.insert(out.end(), data.begin(), data.end());
    out.resize(padded(out.size()), filler);
  }

  std::vector<std::byte> out;
};

}  // namespace

std::optional<std::vector<std::byte>> glb_file(tinygltf::Model& model) {
  std::vector<unsigned char> bin;
  if (!model.buffers.empty()) bin = std::move(model.buffers[0].data);
  model.buffers.clear();
  const std::string json = json_text(model, bin.size());
  const std::uint64_t length = 12 + 8 + padded(json.size()) + (bin.empty() ? 0 : 8 + padded(bin.size()));
  if (length > kLargestGlb) return std::nullopt;
  Bytes file(static_cast<std::size_t>(length));
  file.out.resize(4);
  std::memcpy(file.out.data(), "glTF", 4);
  file.add_u32(2);
  file.add_u32(static_cast<std::size_t>(length));
  file.add_chunk("JSON", std::as_bytes(std::span(json)), std::byte{' '});
  if (!bin.empty()) file.add_chunk(std::string_view("BIN\0", 4), std::as_bytes(std::span(bin)), std::byte{0});
  return std::move(file.out);
}

}  // namespace sinew::write
