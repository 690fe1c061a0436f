// SPDX-License-Identifier: MIT
#include "importer/rewrite/reorder_vertices.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "importer/import_gltf.h"
#include "importer/rewrite/take_decoded.h"

namespace sinew::rewrite {
namespace {

/// Largest vertex count for 16-bit indices; 65535 is the primitive restart index.
constexpr std::size_t kMostNarrow = 65535;

using Indices = std::vector<unsigned>;
using IndexLists = std::vector<std::pair<std::uint32_t, Indices>>;  ///< (accessor, indices)

Indices read_indices(const Stream& stream, const Json& accessor) {
  Indices out(stream.count);
  for (std::size_t i = 0; i < stream.count; ++i) {
    const int type = accessor["componentType"];
    if (type == kUnsignedByte) out[i] = stream.at<std::uint8_t>(i, 0);
    if (type == kUnsignedShort) out[i] = stream.at<std::uint16_t>(i, 0);
    if (type == kUnsignedInt) out[i] = stream.at<std::uint32_t>(i, 0);
  }
  return out;
}

template <class T>
void store(const Indices& indices, Stream& stream) {
  const std::vector<T> values(indices.begin(), indices.end());
  stream.count = values.size();
  stream.stride = sizeof(T);
  stream.bytes.resize(values.size() * sizeof(T));
  std::memcpy(stream.bytes.data(), values.data(), stream.bytes.size());
}

void write_indices(const Indices& indices, Stream& stream, Json& accessor) {
  const unsigned most = *std::max_element(indices.begin(), indices.end());
  const bool narrow = most < kMostNarrow;
  narrow ? store<std::uint16_t>(indices, stream) : store<std::uint32_t>(indices, stream);
  accessor["componentType"] = narrow ? kUnsignedShort : kUnsignedInt;
  accessor["count"] = indices.size();
  for (const char* bound : {"min", "max"}) accessor.erase(bound);
}

/// Primitives that share the same vertex accessors.
struct Pool {
  std::set<std::uint32_t> accessors;  ///< accessors of attributes and displacements
  std::set<std::uint32_t> indices;
  std::vector<Json*> without_indices;
  bool fixed = false;  ///< the order of its vertices must not change
};

/// True if an extension may refer to vertices of its primitive.
bool names_vertices(const Json& primitive) {
  const Json extensions = primitive.value("extensions", Json::object());
  return std::any_of(extensions.items().begin(), extensions.items().end(),
                     [](const auto& entry) { return extension_support(entry.key()) == ExtensionSupport::unknown; });
}

std::set<std::uint32_t> vertex_accessors(const Json& primitive) {
  std::set<std::uint32_t> out;
  for (const Json& accessor : primitive["attributes"]) out.insert(index_of(accessor));
  for (const Json& target : primitive.value("targets", Json::array()))
    for (const Json& accessor : target) out.insert(index_of(accessor));
  return out;
}

class Reorder {
 public:
  /// in   orders_triangles   false = triangles keep their order, and indices are added only if that is smaller
  Reorder(Streams& streams, Draft& draft, bool orders_triangles)
      : streams_(streams), draft_(draft), orders_triangles_(orders_triangles) {}

  void run() {
    collect();
    for (Pool& pool : pools_)
      if (!pool.fixed) reorder(pool);
  }

 private:
  Json& accessor(std::uint32_t index) { return draft_.json["accessors"][index]; }

  /// True for an accessor without stored elements, which are all zero.
  bool is_zeros(std::uint32_t index) {
    return !accessor(index).contains("bufferView") && !accessor(index).contains("sparse");
  }

  void collect() {
    for (Json& mesh : list_of(draft_, "meshes"))
      for (Json& primitive : mesh["primitives"]) add(primitive);
    std::map<std::uint32_t, Pool*> owners;
    for (Pool& pool : pools_)
      for (const auto* members : {&pool.accessors, &pool.indices})
        for (const std::uint32_t index : *members)
          if (Pool* owner = owners.try_emplace(index, &pool).first->second; owner != &pool)
            owner->fixed = pool.fixed = true;
  }

  void add(Json& primitive) {
    const std::set<std::uint32_t> accessors = vertex_accessors(primitive);
    const auto [known, is_new] = pool_of_.try_emplace(accessors, pools_.size());
    if (is_new) pools_.push_back({accessors, {}, {}, false});
    Pool* pool = &pools_[known->second];
    pool->fixed |= primitive.value("mode", 4) != 4 || names_vertices(primitive) || accessors.empty();
    for (const std::uint32_t index : accessors) pool->fixed |= !streams_.contains(index) && !is_zeros(index);
    if (!primitive.contains("indices")) {
      pool->without_indices.push_back(&primitive);
    } else {
      const std::uint32_t indices = index_of(primitive["indices"]);
      pool->indices.insert(indices);
      pool->fixed |= !streams_.contains(indices) || streams_.at(indices).count % 3 != 0;
    }
  }

  void reorder(Pool& pool) {
    const std::size_t vertices = accessor(*pool.accessors.begin())["count"];
    for (const std::uint32_t index : pool.accessors)
      if (accessor(index)["count"] != vertices) return;
    if (vertices == 0 || (!pool.without_indices.empty() && vertices % 3 != 0)) return;
    IndexLists lists;
    for (const std::uint32_t index : pool.indices) {
      lists.emplace_back(index, read_indices(streams_.at(index), accessor(index)));
      const Indices& list = lists.back().second;
      // Invalid index, in a primitive that is never drawn.
      if (*std::max_element(list.begin(), list.end()) >= vertices) return;
    }
    const Joined joined = find_equal(pool, vertices);
    if (!pool.without_indices.empty()) {
      if (!orders_triangles_ && !indices_pay(pool, vertices, joined.count)) return;
      lists.push_back(add_indices(pool, vertices));
    }
    join(pool, vertices, joined, lists);
    const std::size_t unique = joined.count;
    Indices all;
    for (auto& [index, list] : lists) {
      if (orders_triangles_) meshopt_optimizeVertexCacheStrip(list.data(), Indices(list).data(), list.size(), unique);
      all.insert(all.end(), list.begin(), list.end());
    }
    Indices to(unique);
    const std::size_t left = meshopt_optimizeVertexFetchRemap(to.data(), all.data(), all.size(), unique);
    remap(pool, unique, left, to);
    for (auto& [index, list] : lists) {
      for (unsigned& vertex : list) vertex = to[vertex];
      write_indices(list, streams_.at(index), accessor(index));
    }
  }

  std::pair<std::uint32_t, Indices> add_indices(const Pool& pool, std::size_t vertices) {
    Indices indices(vertices);
    std::iota(indices.begin(), indices.end(), 0u);
    draft_.json["accessors"].push_back({{"componentType", kUnsignedInt}, {"count", vertices}, {"type", "SCALAR"}});
    const auto index = static_cast<std::uint32_t>(draft_.json["accessors"].size() - 1);
    Stream stream{StreamUse::triangles, {}, {}, 4, vertices, Filter::none};
    store<std::uint32_t>(indices, stream);
    streams_.emplace(index, std::move(stream));
    for (Json* primitive : pool.without_indices) (*primitive)["indices"] = index;
    return {index, std::move(indices)};
  }

  /// Renumbering after merging bit-identical vertices.
  struct Joined {
    std::size_t count;  ///< number of distinct vertices
    Indices to;         ///< [vertices] new index; empty = unchanged
  };

  /// True if indices take fewer bytes than the vertices that they save.
  bool indices_pay(const Pool& pool, std::size_t vertices, std::size_t unique) const {
    std::size_t bytes = 0;
    for (const std::uint32_t index : pool.accessors)
      if (const auto found = streams_.find(index); found != streams_.end()) bytes += found->second.stride;
    const std::size_t index_bytes = unique <= kMostNarrow ? sizeof(std::uint16_t) : sizeof(std::uint32_t);
    return (vertices - unique) * bytes > vertices * index_bytes + kBytesOfAccessor;
  }

  Joined find_equal(const Pool& pool, std::size_t vertices) const {
    Indices each((vertices + 2) / 3 * 3, 0u);  // meshoptimizer needs whole triangles
    std::iota(each.begin(), each.begin() + static_cast<std::ptrdiff_t>(vertices), 0u);
    Indices to;  // renumbering by the streams so far
    std::size_t unique = vertices;
    std::vector<meshopt_Stream> parts;
    const auto join = [&] {
      Indices next(vertices);
      if (!to.empty()) parts.push_back({to.data(), sizeof(unsigned), sizeof(unsigned)});
      unique =
          meshopt_generateVertexRemapMulti(next.data(), each.data(), each.size(), vertices, parts.data(), parts.size());
      to = std::move(next);
      parts.clear();
    };
    for (const std::uint32_t index : pool.accessors)
      if (const auto found = streams_.find(index); found != streams_.end()) {
        if (found->second.stride > 256) return {vertices, {}};
        parts.push_back({found->second.bytes.data(), found->second.stride, found->second.stride});
        if (parts.size() + 1 == kMostParts) join();
      }
    if (!parts.empty()) join();
    return {unique, std::move(to)};  // without streams all vertices are equal (zeros)
  }

  /// Applies the renumbering to index lists and streams.
  void join(const Pool& pool, std::size_t vertices, const Joined& joined, IndexLists& lists) {
    if (joined.to.empty()) return;
    remap(pool, vertices, joined.count, joined.to);
    for (auto& [index, list] : lists)
      for (unsigned& vertex : list) vertex = joined.to[vertex];
  }

  void remap(const Pool& pool, std::size_t before, std::size_t after, const Indices& to) {
    for (const std::uint32_t index : pool.accessors) {
      accessor(index)["count"] = after;
      const auto found = streams_.find(index);
      if (found == streams_.end()) continue;
      Stream& stream = found->second;
      std::vector<std::byte> moved(after * stream.stride);
      meshopt_remapVertexBuffer(moved.data(), stream.bytes.data(), before, stream.stride, to.data());
      stream.bytes = std::move(moved);
      stream.count = after;
      if (has_bounds(accessor(index)))
        set_bounds(accessor(index), stored_values(stream, accessor(index)), component_count(accessor(index)));
    }
  }

  static constexpr std::size_t kMostParts = 16;         // limit of meshoptimizer
  static constexpr std::size_t kBytesOfAccessor = 150;  // estimated JSON of an accessor and its view

  Streams& streams_;
  Draft& draft_;
  bool orders_triangles_;
  std::vector<Pool> pools_;
  std::map<std::set<std::uint32_t>, std::size_t> pool_of_;  ///< key: set of accessors
};

}  // namespace

void reorder_vertices(Streams& streams, Draft& draft) { Reorder(streams, draft, true).run(); }

void join_vertices(Streams& streams, Draft& draft) { Reorder(streams, draft, false).run(); }

void narrow_indices(Streams& streams, Draft& draft) {
  for (auto& [index, stream] : streams) {
    if (stream.use != StreamUse::triangles && stream.use != StreamUse::indices) continue;
    Json& accessor = draft.json["accessors"][index];
    write_indices(read_indices(stream, accessor), stream, accessor);
  }
}

}  // namespace sinew::rewrite
