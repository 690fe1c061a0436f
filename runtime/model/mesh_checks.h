// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "runtime/animation/track.h"
#include "runtime/base/all_finite.h"
#include "runtime/base/index.h"
#include "runtime/base/result.h"
#include "runtime/model/scene.h"

namespace sinew {

/// Collects the results of checks; only the first broken rule is kept.
class Findings {
 public:
  void require(bool holds, ErrorCode otherwise) noexcept {
    if (!holds && code_ == ErrorCode::ok) code_ = otherwise;
  }
  void require_index(std::uint32_t index, std::size_t count) noexcept {
    require(index < count, ErrorCode::index_out_of_range);
  }
  void require_optional_index(std::uint32_t index, std::size_t count) noexcept {
    require(index == kNone || index < count, ErrorCode::index_out_of_range);
  }
  void require_size(std::size_t found, std::size_t expected) noexcept {
    require(found == expected, ErrorCode::size_mismatch);
  }
  void require_size_or_none(std::size_t found, std::size_t expected) noexcept {
    require(found == 0 || found == expected, ErrorCode::size_mismatch);
  }
  void add(ErrorCode code) noexcept { require(code == ErrorCode::ok, code); }
  template <class Element>
  void require_finite(const std::vector<Element>& elements) noexcept {
    require(all_finite(std::span<const Element>(elements)), ErrorCode::not_finite);
  }
  /// Requires unit rotations, since jobs never divide by their length.
  void require_unit(const std::vector<Transform>& transforms) noexcept {
    bool unit = true;
    for (const Transform& t : transforms) unit &= is_unit(t.rotation);
    require(unit, ErrorCode::not_normalised);
  }
  template <class Index>
  void require_indices(const std::vector<Index>& indices, std::size_t count) noexcept {
    require(all_below(indices, count), ErrorCode::index_out_of_range);
  }
  ErrorCode code() const noexcept { return code_; }

 private:
  ErrorCode code_ = ErrorCode::ok;
};

/// The part of check(Scene) for meshes and mesh instances.
void check_meshes(const Scene& scene, Findings& f);

}  // namespace sinew
