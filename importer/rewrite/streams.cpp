// SPDX-License-Identifier: MIT
#include "importer/rewrite/streams.h"

#include <compare>
#include <cstring>
#include <optional>

#include "importer/read/accessor.h"
#include "importer/rewrite/meshopt_stream.h"
#include "importer/rewrite/references.h"

namespace sinew::rewrite {
namespace {

/// All uses of an accessor: the first one, and a flag that tells if all others are the same.
struct Use {
  StreamUse use;
  std::string semantic;
  bool agree = true;
};

class Uses {
 public:
  void add(const Json& accessor, StreamUse use, const std::string& semantic = {}) {
    const auto known = uses_.try_emplace(index_of(accessor), Use{use, semantic}).first;
    known->second.agree &= known->second.use == use;
    if (known->second.semantic != semantic) known->second.semantic.clear();
    ++count_[known->first];
  }

  /// Removes accessors that have other users.
  void check(Draft& draft) {
    std::map<std::uint32_t, std::size_t> all;
    for_each_reference(draft.json, [&](Referenced kind, Json& index) {
      if (kind == Referenced::accessor) ++all[index_of(index)];
    });
    std::erase_if(uses_,
                  [&](const auto& entry) { return !entry.second.agree || all[entry.first] != count_[entry.first]; });
  }

  const std::map<std::uint32_t, Use>& list() const noexcept { return uses_; }

 private:
  std::map<std::uint32_t, Use> uses_;
  std::map<std::uint32_t, std::size_t> count_;
};

void add_primitive(const Json& primitive, Uses& uses) {
  for (const auto& [semantic, accessor] : primitive["attributes"].items())
    uses.add(accessor, StreamUse::vertex, semantic);
  for (const Json& target : primitive.value("targets", Json::array()))
    for (const auto& [semantic, accessor] : target.items()) uses.add(accessor, StreamUse::vertex, "target " + semantic);
  if (primitive.contains("indices"))
    uses.add(primitive["indices"], primitive.value("mode", 4) == 4 ? StreamUse::triangles : StreamUse::indices);
}

Uses find_uses(Draft& draft) {
  Uses uses;
  for (const Json& mesh : list_of(draft, "meshes"))
    for (const Json& primitive : mesh["primitives"]) add_primitive(primitive, uses);
  for (const Json& animation : list_of(draft, "animations"))
    for (const Json& sampler : animation["samplers"]) {
      uses.add(sampler["input"], StreamUse::key_times);
      uses.add(sampler["output"], StreamUse::key_values);
    }
  for (const Json& skin : list_of(draft, "skins"))
    if (skin.contains("inverseBindMatrices")) uses.add(skin["inverseBindMatrices"], StreamUse::matrices);
  uses.check(draft);
  return uses;
}

std::size_t padded_element(StreamUse use, std::size_t element) {
  return use == StreamUse::vertex ? (element + 3) / 4 * 4 : element;
}

std::size_t component_bytes_of(const Json& accessor) {
  return component_bytes(static_cast<gltf::ComponentType>(accessor["componentType"].get<int>()));
}

/// Reads the elements of an accessor that is not sparse.
std::optional<Stream> read_plain(const Json& accessor, const Json& view, Bytes bytes, const Use& use) {
  Stream stream{use.use, use.semantic, {}, 0, accessor["count"].get<std::size_t>(), Filter::none};
  const std::size_t element = component_bytes_of(accessor) * component_count(accessor);
  const std::size_t step = view.value("byteStride", element), offset = accessor.value("byteOffset", std::size_t{0});
  stream.stride = padded_element(use.use, element);
  if (stream.count == 0 || offset + step * (stream.count - 1) + element > bytes.size()) return std::nullopt;
  stream.bytes.resize(stream.stride * stream.count);
  for (std::size_t i = 0; i < stream.count; ++i)
    std::memcpy(stream.bytes.data() + i * stream.stride, bytes.data() + offset + i * step, element);
  return stream;
}

/// Reads a sparse accessor of floats, with replacements applied.
std::optional<Stream> read_sparse(const gltf::Document& document, std::uint32_t index, Json& accessor, const Use& use) {
  if (index >= document.accessors.size() || accessor["componentType"] != 5126) return std::nullopt;
  const std::vector<float> values = read_floats(document, index);
  Stream stream{use.use, use.semantic, {}, component_count(accessor) * sizeof(float), accessor["count"], Filter::none};
  stream.bytes.resize(values.size() * sizeof(float));
  std::memcpy(stream.bytes.data(), values.data(), stream.bytes.size());
  return stream;
}

/// Key of streams that can share a view.
struct Group {
  StreamUse use;
  std::size_t stride;
  Filter filter;
  int component_type;  ///< set for indices and keys only
  auto operator<=>(const Group&) const = default;
};

Group group_of(const Stream& stream, const Json& accessor) {
  return {stream.use, stream.stride, stream.filter,
          stream.use == StreamUse::vertex ? 0 : accessor["componentType"].get<int>()};
}

void describe_view(const Group& group, Json& view) {
  if (group.use == StreamUse::vertex) view["byteStride"] = group.stride;
  if (group.use == StreamUse::vertex) view["target"] = 34962;
  if (group.use == StreamUse::triangles || group.use == StreamUse::indices) view["target"] = 34963;
}

}  // namespace

std::size_t component_count(const Json& accessor) {
  static const std::map<std::string, std::size_t> kCounts{{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4},
                                                          {"MAT2", 4},   {"MAT3", 9}, {"MAT4", 16}};
  return kCounts.at(accessor["type"].get<std::string>());
}

std::vector<double> stored_values(const Stream& stream, const Json& accessor) {
  const auto type = static_cast<gltf::ComponentType>(accessor["componentType"].get<int>());
  const auto value = [&](std::size_t element, std::size_t component) -> double {
    switch (type) {
      case gltf::ComponentType::i8: return stream.at<std::int8_t>(element, component);
      case gltf::ComponentType::u8: return stream.at<std::uint8_t>(element, component);
      case gltf::ComponentType::i16: return stream.at<std::int16_t>(element, component);
      case gltf::ComponentType::u16: return stream.at<std::uint16_t>(element, component);
      case gltf::ComponentType::u32: return stream.at<std::uint32_t>(element, component);
      case gltf::ComponentType::f32: break;
    }
    return static_cast<double>(stream.at<float>(element, component));
  };
  const std::size_t components = component_count(accessor);
  std::vector<double> out;
  out.reserve(stream.count * components);
  for (std::size_t i = 0; i < stream.count; ++i)
    for (std::size_t c = 0; c < components; ++c) out.push_back(value(i, c));
  return out;
}

void set_normalized(Json& accessor, int component_type) {
  accessor["componentType"] = component_type;
  accessor["normalized"] = true;
}

Streams take_streams(const gltf::Document& document, Draft& draft, bool dense) {
  Streams streams;
  const Uses uses = find_uses(draft);
  Json& accessors = list_of(draft, "accessors");
  for (const auto& [index, use] : uses.list()) {
    Json& accessor = accessors[index];
    std::optional<Stream> stream;
    if (accessor.contains("sparse")) {
      if (dense) stream = read_sparse(document, index, accessor, use);
    } else if (accessor.contains("bufferView")) {
      const std::uint32_t view = index_of(accessor["bufferView"]);
      stream = read_plain(accessor, draft.json["bufferViews"][view], draft.bytes_of(view), use);
    }
    if (stream) streams.emplace(index, *std::move(stream));
  }
  return streams;
}

void put_streams(const Streams& streams, bool compress, Draft& draft) {
  std::map<Group, std::vector<std::uint32_t>> groups;
  for (const auto& [index, stream] : streams) groups[group_of(stream, draft.json["accessors"][index])].push_back(index);
  for (const auto& [group, members] : groups) {
    std::vector<std::byte> bytes;
    for (const std::uint32_t index : members) {
      Json& accessor = draft.json["accessors"][index];
      if (accessor.contains("bufferView")) draft.spare_views.insert(index_of(accessor["bufferView"]));
      if (const auto sparse = accessor.find("sparse"); sparse != accessor.end())
        for (const char* part : {"indices", "values"})
          draft.spare_views.insert(index_of(sparse->at(part).at("bufferView")));
      for (const char* old : {"sparse", "byteOffset"}) accessor.erase(old);
      if (!bytes.empty()) accessor["byteOffset"] = bytes.size();
      accessor["bufferView"] = draft.parts.size();
      const Stream& stream = streams.at(index);
      bytes.insert(bytes.end(), stream.bytes.begin(), stream.bytes.end());
    }
    auto encoded = compress ? encode_meshopt(group.use, group.stride, bytes) : std::nullopt;
    if (!encoded) undo_filter(group.filter, group.stride, bytes);
    const std::size_t decoded_size = bytes.size();
    const std::uint32_t view = draft.add_view(encoded ? std::move(encoded->bytes) : std::move(bytes));
    describe_view(group, draft.json["bufferViews"][view]);
    if (encoded) declare_meshopt(encoded->mode, group.filter, group.stride, decoded_size, view, draft);
  }
}

}  // namespace sinew::rewrite
