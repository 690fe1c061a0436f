// SPDX-License-Identifier: MIT
#include "importer/file/quarantine.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <string_view>

#include "importer/file/animation_faults.h"
#include "importer/file/json_pointer.h"

namespace sinew {
namespace {

using gltf::Document;
using gltf::Json;

struct ListTraits {
  std::string_view name;
  const char* smallest;  ///< smallest valid entry of this list
};
constexpr ListTraits kTraits[Quarantine::kLists] = {
    {"accessors", R"({"componentType":5126,"count":0,"type":"SCALAR"})"},
    {"animations", R"({"channels":[],"samplers":[]})"},
    {"buffers", R"({"byteLength":0})"},
    {"bufferViews", R"({"buffer":0,"byteLength":0})"},
    {"cameras", R"({"type":"perspective","perspective":{"yfov":1,"znear":0.1}})"},
    {"images", "{}"},
    {"materials", "{}"},
    {"meshes", R"({"primitives":[]})"},
    {"nodes", "{}"},
    {"samplers", "{}"},
    {"scenes", "{}"},
    {"skins", R"({"joints":[]})"},
    {"textures", "{}"},
};

/// A parsed location such as "/meshes/3/primitives/1/indices": list, entry, and the part if there is one.
struct BrokenPlace {
  std::size_t list = 0;
  std::uint32_t index = 0;
  std::string_view parts;  ///< "primitives", "channels", "samplers", or empty
  std::uint32_t part = 0;
};

std::string_view next_token(std::string_view& place) {
  if (!place.starts_with('/')) return {};
  const auto end = place.find('/', 1);
  const auto token = place.substr(1, end == place.npos ? end : end - 1);
  place.remove_prefix(std::min(token.size() + 1, place.size()));
  return token;
}

std::optional<std::uint32_t> as_index(std::string_view token) {
  std::uint32_t index = 0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), index);
  return error == std::errc() && end == token.data() + token.size() && !token.empty() ? std::optional(index)
                                                                                      : std::nullopt;
}

std::optional<BrokenPlace> parse_place(std::string_view place) {
  const auto name = next_token(place);
  const auto list =
      std::find_if(std::begin(kTraits), std::end(kTraits), [&](const ListTraits& t) { return t.name == name; });
  const auto index = as_index(next_token(place));
  if (list == std::end(kTraits) || !index) return std::nullopt;
  BrokenPlace out{static_cast<std::size_t>(list - kTraits), *index, {}, 0};
  const std::string_view parts = next_token(place);
  const bool of_mesh = out.list == Quarantine::meshes && parts == "primitives";
  const bool of_animation = out.list == Quarantine::animations && (parts == "channels" || parts == "samplers");
  const auto part = of_mesh || of_animation ? as_index(next_token(place)) : std::nullopt;
  if (part) {
    out.parts = parts;
    out.part = *part;
  }
  return out;
}

/// Marks all entries that use a broken entry, then empties all marked entries. Each list is visited once.
class Emptying {
 public:
  Emptying(Document& document, Quarantine::Broken& broken, IssueLog& log)
      : d_(document), broken_(broken.entries), parts_(broken), primitives_(broken.primitives), log_(log) {}

  void run() {
    for (auto& buffer : marked(d_.buffers, Quarantine::buffers)) {
      if (!buffer->bytes.empty()) continue;  // the buffer is only too short: a view inside its bytes is sound
      buffer->placeholder = true;
      buffer->byte_length = 0;
      buffer->bytes = {};
    }
    empty_views();
    empty_accessors();
    empty_images();
    empty_meshes();
    empty_skins();
    empty_nodes();
    empty_animations();
    for (auto& material : marked(d_.materials, Quarantine::materials)) *material = {};
    for (auto& texture : marked(d_.textures, Quarantine::textures)) *texture = {};
    for (auto& sampler : marked(d_.samplers, Quarantine::samplers)) *sampler = {};
    for (auto& camera : marked(d_.cameras, Quarantine::cameras)) *camera = {};
    for (auto& scene : marked(d_.scenes, Quarantine::scenes)) *scene = {};
  }

 private:
  bool is(Quarantine::List list, std::uint32_t index) const { return broken_[list].contains(index); }

  /// The broken entries of a list; mutes later reports about them.
  template <class T>
  std::vector<T*> marked(std::vector<T>& list, Quarantine::List kind) {
    std::vector<T*> out;
    for (const std::uint32_t i : broken_[kind]) {
      if (i >= list.size()) continue;
      log_.mute(pointer(kTraits[kind].name, i));
      out.push_back(&list[i]);
    }
    return out;
  }

  void empty_views() {
    for (std::uint32_t v = 0; v < d_.buffer_views.size(); ++v)
      if (is(Quarantine::buffers, d_.buffer_views[v].buffer) && !has_its_bytes(d_, d_.buffer_views[v]))
        broken_[Quarantine::buffer_views].insert(v);
    for (auto& view : marked(d_.buffer_views, Quarantine::buffer_views)) *view = {};
  }

  void empty_accessors() {
    for (std::uint32_t a = 0; a < d_.accessors.size(); ++a) {
      const auto& accessor = d_.accessors[a];
      if (is(Quarantine::buffer_views, accessor.buffer_view) ||
          is(Quarantine::buffer_views, accessor.sparse.indices_view) ||
          is(Quarantine::buffer_views, accessor.sparse.values_view))
        broken_[Quarantine::accessors].insert(a);
    }
    for (auto& accessor : marked(d_.accessors, Quarantine::accessors)) {
      accessor->buffer_view = kNone;
      accessor->count = 0;
      accessor->sparse = {};
    }
  }

  void empty_images() {
    for (std::uint32_t i = 0; i < d_.images.size(); ++i)
      if (is(Quarantine::buffer_views, d_.images[i].buffer_view)) broken_[Quarantine::images].insert(i);
    for (auto& image : marked(d_.images, Quarantine::images)) *image = {};
  }

  bool uses_broken_accessor(const std::map<std::string, int>& attributes) const {
    return std::any_of(attributes.begin(), attributes.end(),
                       [&](const auto& entry) { return is(Quarantine::accessors, entry.second); });
  }

  bool is_broken(const gltf::Primitive& primitive) const {
    return uses_broken_accessor(primitive.attributes) || is(Quarantine::accessors, primitive.indices) ||
           std::any_of(primitive.targets.begin(), primitive.targets.end(),
                       [&](const auto& t) { return uses_broken_accessor(t); });
  }

  /// An emptied primitive keeps its target count, because all primitives of a mesh must agree on it.
  void empty_meshes() {
    for (std::uint32_t m = 0; m < d_.meshes.size(); ++m)
      for (std::uint32_t p = 0; p < d_.meshes[m].primitives.size(); ++p) {
        auto& primitive = d_.meshes[m].primitives[p];
        if (is(Quarantine::meshes, m) || is_broken(primitive)) primitives_.emplace(m, p);
        if (!primitives_.contains({m, p})) continue;
        log_.mute(pointer("meshes", m, "primitives", p));
        const std::size_t targets = primitive.targets.size();
        primitive = {};
        primitive.targets.resize(targets);
      }
    marked(d_.meshes, Quarantine::meshes);
  }

  void empty_skins() {
    for (std::uint32_t s = 0; s < d_.skins.size(); ++s) {
      if (is(Quarantine::accessors, d_.skins[s].inverseBindMatrices)) {
        log_.mute(pointer("skins", s, "inverseBindMatrices"));
        d_.skins[s].inverseBindMatrices = gltf::kAbsent;
      }
      // Emptied nodes cut trees apart, so that joints of a skin seem to have no common root.
      if (!broken_[Quarantine::nodes].empty()) log_.mute(pointer("skins", s, "joints"));
    }
    for (auto& skin : marked(d_.skins, Quarantine::skins)) *skin = {};
  }

  bool has_broken_primitive(std::uint32_t mesh) const {
    const auto first = primitives_.lower_bound({mesh, 0});
    return is(Quarantine::meshes, mesh) || (first != primitives_.end() && first->first == mesh);
  }

  bool has_broken_mesh(const gltf::Node& node) const {
    return node.mesh != gltf::kAbsent && has_broken_primitive(node.mesh);
  }

  bool has_broken_copies(const gltf::Node& node) const {
    const Json::json_pointer place("/EXT_mesh_gpu_instancing/attributes");
    if (!node.extensions.contains(place)) return false;
    const Json& attributes = node.extensions.at(place);
    return std::any_of(attributes.begin(), attributes.end(), [&](const Json& accessor) {
      return accessor.is_number_unsigned() && accessor.get<std::uint64_t>() < d_.accessors.size() &&
             is(Quarantine::accessors, accessor.get<std::uint32_t>());
    });
  }

  void empty_nodes() {
    for (std::uint32_t n = 0; n < d_.nodes.size(); ++n) {
      auto& node = d_.nodes[n];
      if (has_broken_copies(node)) log_.mute(pointer("nodes", n, "extensions", "EXT_mesh_gpu_instancing"));
      if (is(Quarantine::skins, node.skin)) node.skin = gltf::kAbsent;
      if (has_broken_mesh(node)) {
        log_.mute(pointer("nodes", n, "skin"));
        log_.mute(pointer("nodes", n, "weights"));
      }
    }
    for (auto& node : marked(d_.nodes, Quarantine::nodes)) *node = {};
  }

  bool is_broken_node(std::uint32_t node) const {
    return is(Quarantine::nodes, node) || (node < d_.nodes.size() && has_broken_mesh(d_.nodes[node]));
  }

  /// True if the channel's node, or the target of its pointer, is broken.
  bool has_broken_target(const gltf::AnimationChannel& channel) const {
    const auto place = parse_place(channel.pointer);
    if (!place) return is_broken_node(channel.node);
    if (place->list == Quarantine::nodes) return is_broken_node(place->index);
    if (place->list == Quarantine::meshes) return has_broken_primitive(place->index);
    return broken_[place->list].contains(place->index);
  }

  void empty_animations() {
    for (std::uint32_t a = 0; a < d_.animations.size(); ++a) {
      const auto& animation = d_.animations[a];
      for (std::uint32_t s = 0; s < animation.samplers.size(); ++s)
        if (is(Quarantine::accessors, animation.samplers[s].input) ||
            is(Quarantine::accessors, animation.samplers[s].output))
          log_.mute(pointer("animations", a, "samplers", s));
      for (std::uint32_t c = 0; c < animation.channels.size(); ++c)
        if (has_broken_target(animation.channels[c])) log_.mute(pointer("animations", a, "channels", c, "target"));
      empty_channels(a);
    }
    for (auto& animation : marked(d_.animations, Quarantine::animations)) *animation = {};
  }

  /// Empties the broken samplers of an animation, and the channels that are broken or use such a sampler. An empty
  /// channel has no target and no sampler.
  void empty_channels(std::uint32_t a) {
    auto& [name, samplers, channels, extras] = d_.animations[a];
    for (std::uint32_t c = 0; c < channels.size(); ++c) {
      if (!parts_.channels.contains({a, c}) && !parts_.samplers.contains({a, channels[c].sampler})) continue;
      log_.mute(pointer("animations", a, "channels", c));
      channels[c] = {};
    }
    for (auto s = parts_.samplers.lower_bound({a, 0}); s != parts_.samplers.end() && s->first == a; ++s) {
      log_.mute(pointer("animations", a, "samplers", s->second));
      if (s->second < samplers.size()) samplers[s->second] = {};
    }
  }

  Document& d_;
  std::array<std::set<std::uint32_t>, Quarantine::kLists>& broken_;
  const Quarantine::Broken& parts_;
  Quarantine::Parts& primitives_;
  IssueLog& log_;
};

}  // namespace

bool Quarantine::empty() const noexcept {
  const auto& lists = broken_.entries;
  return std::all_of(lists.begin(), lists.end(), [](const auto& list) { return list.empty(); }) &&
         broken_.primitives.empty() && broken_.channels.empty() && broken_.samplers.empty() && !broken_.scene &&
         !broken_.asset && !broken_.too_deep;
}

bool Quarantine::holds_only_animations_and_data() const noexcept {
  for (std::size_t list = 0; list < kLists; ++list)
    if (list != accessors && list != animations && list != buffers && list != buffer_views &&
        !broken_.entries[list].empty())
      return false;
  return broken_.primitives.empty() && !broken_.scene && !broken_.asset && !broken_.too_deep;
}

bool Quarantine::touches_only_animations(const Document& document) {
  const auto& lists = broken_.entries;
  const bool emptied = others_emptied_ || !lists[animations].empty() || !broken_.samplers.empty();
  const bool only = holds_only_animations_and_data() &&
                    only_animations_read(document, {lists[buffers], lists[buffer_views], lists[accessors]}, emptied);
  others_emptied_ = others_emptied_ || (only && !empty());
  return only;
}

bool Quarantine::mark(IssueLog& log) { return mark(log, false); }

bool Quarantine::mark(IssueLog& log, bool replaces_asset) {
  const auto places = log.settle();
  if (!places) return false;
  for (const std::string& text : *places) {
    if (replaces_asset && (text.empty() || text == "/asset" || text.starts_with("/asset/"))) {
      broken_.asset = true;
      log.mute("/asset");
      continue;
    }
    if (text == "/nodes") {
      broken_.too_deep = true;
      continue;
    }
    if (text == "/scene") {
      broken_.scene = true;
      log.mute(text);
      continue;
    }
    const auto place = parse_place(text);
    if (!place) return false;
    if (place->parts.empty())
      broken_.entries[place->list].insert(place->index);
    else
      (place->parts == "primitives" ? broken_.primitives
       : place->parts == "channels" ? broken_.channels
                                    : broken_.samplers)
          .emplace(place->index, place->part);
  }
  return true;
}

void Quarantine::empty_marked(Document& document, IssueLog& log) {
  if (broken_.scene) document.scene = kNone;
  Emptying(document, broken_, log).run();
}

bool Quarantine::isolate(JsonTree& document, IssueLog& log) {
  if (!document.root.IsObject() || !mark(log, true) || broken_.too_deep) return false;  // here "/nodes" is no array
  if (broken_.asset) replace_asset(document);
  while (broken_.scene && document.root.RemoveMember("scene")) {
  }
  replace_parts(document, log);
  replace_entries(document, log);
  return true;
}

/// Treats a document without a valid `asset` as glTF 2.0.
void Quarantine::replace_asset(JsonTree& document) const {
  while (document.root.RemoveMember("asset")) {
  }
  document.root.AddMember(JsonNode("asset"), from_json(Json{{"version", "2.0"}}, document.pool), document.pool);
}

void Quarantine::replace_entries(JsonTree& document, IssueLog& log) const {
  for (std::size_t list = 0; list < kLists; ++list)
    for (const std::uint32_t index : broken_.entries[list]) {
      log.mute(pointer(kTraits[list].name, index));
      (*find_member(document.root, kTraits[list].name))[index] =
          from_json(Json::parse(kTraits[list].smallest), document.pool);
    }
}

/// An emptied primitive keeps its target count, because all primitives of a mesh must agree on it.
void Quarantine::replace_parts(JsonTree& document, IssueLog& log) const {
  const auto replace = [&](const char* list, const char* parts, const Parts& broken, const char* smallest) {
    for (const auto& [index, part] : broken) {
      log.mute(pointer(list, index, parts, part));
      JsonNode& entry = (*find_member((*find_member(document.root, list))[index], parts))[part];
      Json empty = Json::parse(smallest);
      const JsonNode* targets = entry.IsObject() ? find_member(entry, "targets") : nullptr;
      if (targets != nullptr && targets->IsArray() && !targets->Empty())
        empty["targets"] = Json::array_t(targets->Size(), Json::object());
      entry = from_json(empty, document.pool);
    }
  };
  replace("meshes", "primitives", broken_.primitives, R"({"attributes":{}})");
  replace("animations", "channels", broken_.channels, R"({"sampler":0,"target":{"path":""}})");
  replace("animations", "samplers", broken_.samplers, R"({"input":0,"output":0})");
}

}  // namespace sinew
