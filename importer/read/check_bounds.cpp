// SPDX-License-Identifier: MIT
#include "importer/read/check_bounds.h"

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "importer/file/json_pointer.h"
#include "importer/read/accessor.h"

namespace sinew {
namespace {

/// Limits of compared components: in total, and for one accessor without bytes. Many accessors may share bytes or have
/// none.
constexpr std::uint64_t kMaxTotal = std::uint64_t{1} << 28, kMaxWithoutBytes = std::uint64_t{1} << 20;

std::string text(double number) { return gltf::Json(number).dump(); }

class BoundsCheck {
 public:
  BoundsCheck(const gltf::Accessor& accessor, std::size_t index, std::vector<double> elements, IssueLog& log)
      : accessor_(accessor),
        elements_(std::move(elements)),
        components_(element_layout(accessor).components()),
        place_(pointer("accessors", index)),
        log_(log) {}

  void run() {
    compare(accessor_.min, "min", std::less<>());
    compare(accessor_.max, "max", std::greater<>());
  }

 private:
  /// `better(a, b)` is true if a replaces b as the bound.
  template <class Better>
  void compare(const std::vector<double>& declared, const char* name, Better better) {
    if (declared.empty()) return;
    if (declared.size() != components_)
      return log_.report(
          Rule::accessor_bounds, pointer(place_, name),
          std::to_string(declared.size()) + " entries for " + std::to_string(components_) + " components");
    for (std::size_t c = 0; c < components_; ++c) {
      double bound = elements_[c];
      for (std::size_t i = c; i < elements_.size(); i += components_)
        if (better(elements_[i], bound)) bound = elements_[i];
      if (stored(declared[c]) != bound)
        log_.report(Rule::accessor_bounds, pointer(place_, name, c),
                    "is " + text(declared[c]) + ", the elements have " + text(bound) + "; they are used");
    }
  }

  /// Converts a declared bound for comparison: JSON numbers are doubles, so bounds of float elements are rounded to
  /// float.
  double stored(double number) const {
    return accessor_.component_type == gltf::ComponentType::f32 ? static_cast<double>(static_cast<float>(number))
                                                                : number;
  }

  const gltf::Accessor& accessor_;
  std::vector<double> elements_;
  std::size_t components_;
  std::string place_;
  IssueLog& log_;
};

}  // namespace

void check_bounds(const gltf::Document& document, IssueLog& log) {
  std::uint64_t total = 0;
  for (std::size_t i = 0; i < document.accessors.size() && total < kMaxTotal; ++i) {
    const auto& accessor = document.accessors[i];
    if (accessor.count == 0 || (accessor.min.empty() && accessor.max.empty())) continue;
    const std::uint64_t components = accessor.count * element_layout(accessor).components();
    if (accessor.buffer_view == kNone && components > kMaxWithoutBytes) continue;
    total += components;
    BoundsCheck(accessor, i, read_stored(document, static_cast<std::uint32_t>(i)), log).run();
  }
}

}  // namespace sinew
