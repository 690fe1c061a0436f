// SPDX-License-Identifier: MIT
#include "importer/read/check_accessors.h"

#include <string>

#include "importer/file/json_pointer.h"
#include "importer/read/accessor.h"

namespace sinew {
namespace {

using gltf::Accessor;
using gltf::ComponentType;
using gltf::Document;

constexpr std::uint64_t kMaxCount = std::uint64_t{1} << 32;

/// Sparse indices looked at in all: many accessors may name one list.
constexpr std::uint64_t kMaxSparse = std::uint64_t{1} << 28;

/// True when `count` elements of `size` bytes, `stride` apart, fit behind `offset` into `available` bytes. Offset is
/// below 2^53 and stride below 2^32 by the shape of the JSON, count is bounded here, so nothing wraps.
bool fits(std::uint64_t offset, std::uint64_t stride, std::uint64_t count, std::uint64_t size, std::uint64_t available) {
  if (count == 0) return offset <= available;
  if (count > kMaxCount || offset > available || size > available - offset) return false;
  return count == 1 || (available - offset - size) / stride >= count - 1;
}

class AccessorCheck {
 public:
  AccessorCheck(const Document& document, std::size_t index, std::uint64_t& sparse_total, IssueLog& log)
      : document_(document), accessor_(document.accessors[index]), layout_(element_layout(accessor_)),
        place_(pointer("accessors", index)), sparse_total_(sparse_total), log_(log) {}

  void run() {
    if (accessor_.count == 0) log_.report(Rule::accessor_empty, place_, "has no elements; what uses it is left out");
    if (accessor_.count > kMaxCount)
      return log_.report(Rule::accessor_fit, pointer(place_, "count"), std::to_string(accessor_.count) + " elements");
    const bool integer = accessor_.component_type != ComponentType::f32 && accessor_.component_type != ComponentType::u32;
    if (accessor_.normalized && !integer)
      log_.report(Rule::accessor_normalized, pointer(place_, "normalized"), "only 8- and 16-bit integers are normalised; ignored");
    if (accessor_.buffer_view != kNone) check_base();
    if (accessor_.sparse.count > 0) check_sparse();
  }

 private:
  void check_base() {
    const auto& view = document_.buffer_views[accessor_.buffer_view];
    const std::uint64_t stride = element_stride(document_, accessor_);
    if (stride < layout_.element_bytes)
      return log_.report(Rule::accessor_stride, pointer("bufferViews", accessor_.buffer_view, "byteStride"),
                         std::to_string(stride) + " bytes, one element of " + place_ + " has " + std::to_string(layout_.element_bytes));
    if (!fits(accessor_.byte_offset, stride, accessor_.count, layout_.element_bytes, view.bytes.size()))
      return log_.report(Rule::accessor_fit, place_, std::to_string(accessor_.count) + " elements of " +
                             std::to_string(layout_.element_bytes) + " bytes, " + std::to_string(stride) + " apart, from byte " +
                             std::to_string(accessor_.byte_offset) + " do not fit into the " + std::to_string(view.bytes.size()) +
                             " bytes of " + pointer("bufferViews", accessor_.buffer_view));
    if ((view.byte_offset + accessor_.byte_offset) % layout_.component_bytes != 0)
      log_.report(Rule::accessor_alignment, pointer(place_, "byteOffset"),
                  "elements are not aligned to " + std::to_string(layout_.component_bytes) + " bytes; read byte by byte");
  }

  void check_sparse() {
    const auto& sparse = accessor_.sparse;
    const std::string place = pointer(place_, "sparse");
    if (sparse.count > accessor_.count)
      return log_.report(Rule::accessor_sparse, pointer(place, "count"), std::to_string(sparse.count) + " replacements of " +
                                                                             std::to_string(accessor_.count) + " elements");
    const std::uint32_t index_bytes = component_bytes(sparse.index_type);
    const auto &indices = document_.buffer_views[sparse.indices_view].bytes, &values = document_.buffer_views[sparse.values_view].bytes;
    if (!fits(sparse.indices_offset, index_bytes, sparse.count, index_bytes, indices.size()))
      return log_.report(Rule::accessor_fit, pointer(place, "indices"), "do not fit into their buffer view");
    if (!fits(sparse.values_offset, layout_.element_bytes, sparse.count, layout_.element_bytes, values.size()))
      return log_.report(Rule::accessor_fit, pointer(place, "values"), "do not fit into their buffer view");
    sparse_total_ += sparse.count;
    if (sparse_total_ > kMaxSparse)
      return log_.report(Rule::memory_budget, place, "more sparse replacements in all than the importer allows");
    check_sparse_order(place);
  }

  void check_sparse_order(const std::string& place) {
    const auto& sparse = accessor_.sparse;
    const std::uint32_t size = component_bytes(sparse.index_type);
    const std::byte* at = document_.buffer_views[sparse.indices_view].bytes.data() + sparse.indices_offset;
    std::uint64_t previous = 0;
    bool ordered = true;
    for (std::uint64_t i = 0; i < sparse.count; ++i, at += size) {
      std::uint64_t index = 0;
      for (std::uint32_t byte = size; byte-- > 0;) index = index << 8 | std::to_integer<std::uint64_t>(at[byte]);
      if (index >= accessor_.count)
        return log_.report(Rule::accessor_sparse, pointer(place, "indices"), "index " + std::to_string(index) + " of " +
                                                                                 std::to_string(accessor_.count) + " elements");
      ordered = ordered && (i == 0 || index > previous);
      previous = index;
    }
    if (!ordered)
      log_.report(Rule::accessor_sparse_order, pointer(place, "indices"), "do not strictly increase; applied in their order");
  }

  const Document& document_;
  const Accessor& accessor_;
  ElementLayout layout_;
  std::string place_;
  std::uint64_t& sparse_total_;
  IssueLog& log_;
};

}  // namespace

void check_accessors(const Document& document, IssueLog& log) {
  for (std::size_t i = 0; i < document.buffer_views.size(); ++i) {
    const std::uint32_t stride = document.buffer_views[i].byte_stride;
    if (stride != 0 && (stride % 4 != 0 || stride > 252))
      log.report(Rule::buffer_view_stride, pointer("bufferViews", i, "byteStride"),
                 std::to_string(stride) + " is not a multiple of 4 up to 252; used as it is");
  }
  std::uint64_t sparse_total = 0;
  for (std::size_t i = 0; i < document.accessors.size() && sparse_total <= kMaxSparse; ++i)
    AccessorCheck(document, i, sparse_total, log).run();
}

}  // namespace sinew
