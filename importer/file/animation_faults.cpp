// SPDX-License-Identifier: MIT
#include "importer/file/animation_faults.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "importer/file/meshopt_extension.h"

namespace sinew {
namespace {

using gltf::Json;

/// The broken entries of a list: one mark for each entry.
class Marks {
 public:
  Marks(std::size_t count, const std::set<std::uint32_t>& broken) : marks_(count, false) {
    for (const std::uint32_t index : broken)
      if (index < count) marks_[index] = true;
  }
  /// True if the index is in range and its entry is marked.
  template <class Index>
  bool holds(Index index) const {
    return static_cast<std::uint32_t>(index) < marks_.size() && marks_[static_cast<std::uint32_t>(index)];
  }
  void set(std::size_t index) { marks_[index] = true; }

 private:
  std::vector<bool> marks_;
};

/// The index at `place` of an extension; kNone if there is none.
std::uint32_t find_index(const Json& extension, const char* place) {
  const auto found = extension.is_object() ? extension.find(place) : extension.end();
  return extension.is_object() && found != extension.end() && found->is_number_unsigned() && *found < kNone
             ? found->get<std::uint32_t>()
             : kNone;
}

const Json& find_extension(const Json& extensions, const char* name) {
  static const Json kNothing;
  const auto found = extensions.is_object() ? extensions.find(name) : extensions.end();
  return extensions.is_object() && found != extensions.end() ? *found : kNothing;
}

/// The buffer with the compressed stream of a view; kNone if it has none.
std::uint32_t compressed_source(const gltf::BufferView& view) {
  const MeshoptExtension compressed = meshopt_extension(view.extensions);
  return compressed ? find_index(*compressed.value, "buffer") : kNone;
}

Marks broken_views(const gltf::Document& d, const BrokenStores& broken) {
  const Marks buffers(d.buffers.size(), broken.buffers);
  Marks views(d.buffer_views.size(), broken.buffer_views);
  for (std::size_t v = 0; v < d.buffer_views.size(); ++v) {
    const bool broken_buffer = buffers.holds(d.buffer_views[v].buffer) && !has_its_bytes(d, d.buffer_views[v]);
    if (broken_buffer || buffers.holds(compressed_source(d.buffer_views[v]))) views.set(v);
  }
  return views;
}

Marks broken_accessors(const gltf::Document& d, const BrokenStores& broken, const Marks& views) {
  Marks accessors(d.accessors.size(), broken.accessors);
  for (std::size_t a = 0; a < d.accessors.size(); ++a) {
    const gltf::Accessor& accessor = d.accessors[a];
    if (views.holds(accessor.buffer_view) || views.holds(accessor.sparse.indices_view) ||
        views.holds(accessor.sparse.values_view))
      accessors.set(a);
  }
  return accessors;
}

/// True if a sampler reads each broken entry, or if the entry lies in another broken one.
bool samplers_read_all(const gltf::Document& d, const BrokenStores& broken) {
  std::set<std::uint32_t> accessors, views, buffers;
  for (const gltf::Animation& animation : d.animations)
    for (const gltf::AnimationSampler& sampler : animation.samplers) accessors.insert({sampler.input, sampler.output});
  for (std::uint32_t a = 0; a < d.accessors.size(); ++a) {
    const gltf::Accessor& accessor = d.accessors[a];
    const std::uint32_t stored_in[] = {accessor.buffer_view, accessor.sparse.indices_view, accessor.sparse.values_view};
    if (accessors.contains(a)) views.insert(std::begin(stored_in), std::end(stored_in));
    if (std::any_of(std::begin(stored_in), std::end(stored_in),
                    [&](std::uint32_t view) { return broken.buffer_views.contains(view); }))
      accessors.insert(a);
  }
  for (std::uint32_t v = 0; v < d.buffer_views.size(); ++v) {
    const std::uint32_t buffer = d.buffer_views[v].buffer;
    if (views.contains(v)) buffers.insert({buffer, compressed_source(d.buffer_views[v])});
    if (broken.buffers.contains(buffer)) views.insert(v);
  }
  const auto in = [](const std::set<std::uint32_t>& part, const std::set<std::uint32_t>& whole) {
    return std::includes(whole.begin(), whole.end(), part.begin(), part.end());
  };
  return in(broken.accessors, accessors) && in(broken.buffer_views, views) && in(broken.buffers, buffers);
}

}  // namespace

bool has_its_bytes(const gltf::Document& document, const gltf::BufferView& view) noexcept {
  if (view.buffer >= document.buffers.size()) return false;
  const std::uint64_t there = document.buffers[view.buffer].bytes.size();
  return view.byte_length > 0 && view.byte_offset <= there && view.byte_length <= there - view.byte_offset;
}

bool only_animations_read(const gltf::Document& d, const BrokenStores& broken, bool spares) {
  if (!spares && !samplers_read_all(d, broken)) return false;
  const Marks views = broken_views(d, broken), accessors = broken_accessors(d, broken, views);
  const auto any_of = [&](const std::map<std::string, int>& attributes) {
    return std::any_of(attributes.begin(), attributes.end(), [&](const auto& a) { return accessors.holds(a.second); });
  };
  for (const gltf::Image& image : d.images)
    if (views.holds(image.buffer_view)) return false;
  for (const gltf::Mesh& mesh : d.meshes)
    for (const gltf::Primitive& primitive : mesh.primitives)
      if (any_of(primitive.attributes) || accessors.holds(primitive.indices) ||
          std::any_of(primitive.targets.begin(), primitive.targets.end(), any_of) ||
          views.holds(find_index(find_extension(primitive.extensions, "KHR_draco_mesh_compression"), "bufferView")))
        return false;
  for (const auto& skin : d.skins)
    if (accessors.holds(skin.inverseBindMatrices)) return false;
  for (const auto& node : d.nodes) {
    const Json& copies = find_extension(node.extensions, "EXT_mesh_gpu_instancing");
    if (!copies.is_object() || !copies.contains("attributes")) continue;
    for (const auto& [name, accessor] : copies["attributes"].items())
      if (accessor.is_number_unsigned() && accessors.holds(accessor.get<std::uint64_t>())) return false;
  }
  return true;
}

}  // namespace sinew
