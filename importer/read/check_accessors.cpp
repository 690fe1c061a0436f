// SPDX-License-Identifier: MIT
#include "importer/read/check_accessors.h"

#include <string>
#include <utility>
#include <vector>

#include "importer/file/json_pointer.h"
#include "importer/read/accessor.h"

namespace sinew {
namespace {

using gltf::Accessor;
using gltf::ComponentType;
using gltf::Document;

constexpr std::uint64_t kMaxCount = std::uint64_t{1} << 32;

/// Limit of sparse indices over all accessors: many accessors may share one list.
constexpr std::uint64_t kMaxSparse = std::uint64_t{1} << 28;

/// True if `count` elements of `size` bytes, `stride` bytes apart, fit into `available` bytes from `offset`. Cannot
/// overflow: check_shape() limits offset to 2^53 and stride to 2^32, and count is limited here.
bool fits(std::uint64_t offset, std::uint64_t stride, std::uint64_t count, std::uint64_t size,
          std::uint64_t available) {
  if (count == 0) return offset <= available;
  if (count > kMaxCount || offset > available || size > available - offset) return false;
  return count == 1 || (available - offset - size) / stride >= count - 1;
}

/// Checks one accessor. `available` returns the length of a view: the declared one, or that of its bytes.
class AccessorCheck {
 public:
  AccessorCheck(const Document& document, std::size_t index, IssueLog& log)
      : document_(document),
        accessor_(document.accessors[index]),
        layout_(element_layout(accessor_)),
        index_(index),
        log_(log) {}

  /// Warns about violations that do not prevent reading.
  void warn() {
    const bool integer =
        accessor_.component_type != ComponentType::f32 && accessor_.component_type != ComponentType::u32;
    if (accessor_.normalized && !integer)
      log_.report(Rule::accessor_normalized, place("normalized"),
                  "only 8- and 16-bit integers are normalised; ignored");
    if (accessor_.buffer_view != kNone) warn_alignment();
    if (accessor_.sparse.count == 0) return;
    warn_stride(accessor_.sparse.indices_view, "indices");
    warn_stride(accessor_.sparse.values_view, "values");
  }

  /// Returns false after an error.
  template <class Available>
  bool fits_views(Available available) {
    if (accessor_.count > kMaxCount)
      return fail(Rule::accessor_fit, place("count"), std::to_string(accessor_.count) + " elements");
    if (accessor_.buffer_view != kNone && !fits_base(available(document_.buffer_views[accessor_.buffer_view])))
      return false;
    return accessor_.sparse.count == 0 || fits_sparse(available(document_.buffer_views[accessor_.sparse.indices_view]),
                                                      available(document_.buffer_views[accessor_.sparse.values_view]));
  }

  /// in   fits_views() returned true
  void check_sparse_indices(std::uint64_t& sparse_total) {
    const auto& sparse = accessor_.sparse;
    if (sparse.count == 0) return;
    const auto sparse_place = [&](auto... part) { return place("sparse", part...); };
    sparse_total += sparse.count;
    if (sparse_total > kMaxSparse)
      return log_.report(Rule::memory_budget, sparse_place(),
                         "more sparse replacements in all than the importer allows");
    const std::uint32_t size = component_bytes(sparse.index_type);
    const std::byte* at = document_.buffer_views[sparse.indices_view].bytes.data() + sparse.indices_offset;
    std::uint64_t previous = 0;
    bool ordered = true;
    for (std::uint64_t i = 0; i < sparse.count; ++i, at += size) {
      std::uint64_t index = 0;
      for (std::uint32_t byte = size; byte-- > 0;) index = index << 8 | std::to_integer<std::uint64_t>(at[byte]);
      if (index >= accessor_.count)
        return log_.report(Rule::accessor_sparse, sparse_place(),
                           "index " + std::to_string(index) + " of " + std::to_string(accessor_.count) + " elements");
      ordered = ordered && (i == 0 || index > previous);
      previous = index;
    }
    if (!ordered)
      log_.report(Rule::accessor_sparse_order, sparse_place(),
                  "indices do not strictly increase; applied in their order");
  }

 private:
  template <class... Part>
  std::string place(const Part&... part) const {
    return pointer("accessors", index_, part...);
  }

  bool fail(Rule rule, std::string place, std::string detail) {
    log_.report(rule, std::move(place), std::move(detail));
    return false;
  }

  void warn_alignment() {
    const auto& view = document_.buffer_views[accessor_.buffer_view];
    const bool own_offset = accessor_.byte_offset % layout_.component_bytes != 0;
    if (own_offset || (view.byte_offset + accessor_.byte_offset) % layout_.component_bytes != 0)
      log_.report(
          Rule::accessor_alignment, own_offset ? place("byteOffset") : place(),
          "elements are not aligned to " + std::to_string(layout_.component_bytes) + " bytes; read byte by byte");
  }

  void warn_stride(std::uint32_t view, const char* part) {
    if (document_.buffer_views[view].byte_stride != 0)
      log_.report(Rule::accessor_sparse_stride, place("sparse", part, "bufferView"),
                  "has a byteStride, which is ignored");
  }

  bool fits_base(std::uint64_t available) {
    const std::uint64_t stride = element_stride(document_, accessor_);
    const auto view = [&] { return pointer("bufferViews", accessor_.buffer_view); };
    if (stride < layout_.element_bytes)
      return fail(Rule::accessor_stride, place(),
                  "byteStride of " + view() + " is " + std::to_string(stride) + " bytes, one element has " +
                      std::to_string(layout_.element_bytes));
    if (fits(accessor_.byte_offset, stride, accessor_.count, layout_.element_bytes, available)) return true;
    return fail(Rule::accessor_fit, accessor_.byte_offset > available ? place("byteOffset") : place(),
                std::to_string(accessor_.count) + " elements of " + std::to_string(layout_.element_bytes) + " bytes, " +
                    std::to_string(stride) + " apart, from byte " + std::to_string(accessor_.byte_offset) +
                    " do not fit into the " + std::to_string(available) + " bytes of " + view());
  }

  bool fits_sparse(std::uint64_t index_space, std::uint64_t value_space) {
    const auto& sparse = accessor_.sparse;
    const auto sparse_place = [&](auto... part) { return place("sparse", part...); };
    if (sparse.count > accessor_.count)
      return fail(Rule::accessor_sparse, sparse_place("count"),
                  std::to_string(sparse.count) + " replacements of " + std::to_string(accessor_.count) + " elements");
    const std::uint32_t index_bytes = component_bytes(sparse.index_type);
    if (!fits(sparse.indices_offset, index_bytes, sparse.count, index_bytes, index_space))
      return fail(Rule::accessor_fit, sparse_place("indices"), "do not fit into their buffer view");
    if (!fits(sparse.values_offset, layout_.element_bytes, sparse.count, layout_.element_bytes, value_space))
      return fail(Rule::accessor_fit, sparse_place("values"), "do not fit into their buffer view");
    return true;
  }

  const Document& document_;
  const Accessor& accessor_;
  ElementLayout layout_;
  std::size_t index_;
  IssueLog& log_;
};

/// Accessors that a Draco stream fills; their own views are ignored.
std::vector<bool> filled_by_draco(const Document& document) {
  std::vector<bool> filled(document.accessors.size(), false);
  for (const auto& mesh : document.meshes)
    for (const auto& primitive : mesh.primitives) {
      if (!primitive.extensions.is_object() || !primitive.extensions.contains("KHR_draco_mesh_compression")) continue;
      for (const auto& [name, accessor] : primitive.attributes) filled[accessor] = true;
      if (primitive.indices != gltf::kAbsent) filled[primitive.indices] = true;
    }
  return filled;
}

}  // namespace

void check_accessor_layout(const Document& document, IssueLog& log) {
  for (std::size_t i = 0; i < document.buffer_views.size(); ++i) {
    const std::uint32_t stride = document.buffer_views[i].byte_stride;
    if (stride != 0 && (stride % 4 != 0 || stride > 252))
      log.report(Rule::buffer_view_stride, pointer("bufferViews", i, "byteStride"),
                 std::to_string(stride) + " is not a multiple of 4 up to 252; used as it is");
  }
  const auto skipped = filled_by_draco(document);
  for (std::size_t i = 0; i < document.accessors.size(); ++i) {
    if (skipped[i]) continue;
    AccessorCheck accessor(document, i, log);
    accessor.warn();
    accessor.fits_views([](const gltf::BufferView& view) { return view.byte_length; });
  }
}

void check_accessors(const Document& document, IssueLog& log) {
  std::uint64_t sparse_total = 0;
  for (std::size_t i = 0; i < document.accessors.size() && sparse_total <= kMaxSparse; ++i) {
    AccessorCheck accessor(document, i, log);
    if (accessor.fits_views([](const gltf::BufferView& view) { return std::uint64_t{view.bytes.size()}; }))
      accessor.check_sparse_indices(sparse_total);
  }
}

}  // namespace sinew
