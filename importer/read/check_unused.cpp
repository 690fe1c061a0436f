// SPDX-License-Identifier: MIT
#include "importer/read/check_unused.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "importer/file/json_pointer.h"
#include "importer/read/accessor.h"
#include "importer/read/mesh_copies.h"
#include "importer/read/vertex_formats.h"

namespace sinew {
namespace {

/// Limit of checked components: many accessors may share bytes.
constexpr std::uint64_t kMaxUnusedElements = std::uint64_t{1} << 28;

class Uses {
 public:
  explicit Uses(const gltf::Document& document) : used_(document.accessors.size(), false) {
    for (const auto& mesh : document.meshes)
      for (const auto& primitive : mesh.primitives) {
        mark(primitive.indices);
        mark_attributes(primitive.attributes);
        for (const auto& target : primitive.targets) mark_attributes(target);
      }
    for (const auto& skin : document.skins) mark(skin.inverseBindMatrices);
    for (const auto& animation : document.animations)
      for (const auto& sampler : animation.samplers) {
        mark(sampler.input);
        mark(sampler.output);
      }
    IssueLog discarded_log;
    for (std::uint32_t n = 0; n < document.nodes.size(); ++n)
      for (const auto& [name, accessor] : copy_attributes(document, n, discarded_log)) mark(accessor);
  }

  bool is_used(std::size_t accessor) const { return used_[accessor]; }

 private:
  void mark(std::uint32_t accessor) {
    if (accessor < used_.size()) used_[accessor] = true;
  }

  /// Marks the attributes that the import reads; application-specific ones are not read.
  void mark_attributes(const std::map<std::string, int>& attributes) {
    for (const auto& [name, accessor] : attributes)
      if (parse_semantic(name)) mark(accessor);
  }

  std::vector<bool> used_;
};

}  // namespace

void check_unused_accessors(const gltf::Document& document, IssueLog& log) {
  const Uses uses(document);
  std::uint64_t total = 0;
  for (std::uint32_t i = 0; i < document.accessors.size(); ++i) {
    const gltf::Accessor& accessor = document.accessors[i];
    const bool has_bytes = accessor.buffer_view != kNone || accessor.sparse.count > 0;
    if (uses.is_used(i) || !has_bytes || accessor.component_type != gltf::ComponentType::f32) continue;
    const std::uint64_t components = element_layout(accessor).components();
    total += accessor.count * components;
    if (total > kMaxUnusedElements) return;
    const std::vector<float> values = read_floats(document, i);
    const auto bad = std::find_if(values.begin(), values.end(), [](float f) { return !std::isfinite(f); });
    if (bad == values.end()) continue;
    const auto element = static_cast<std::uint64_t>(bad - values.begin()) / components;
    log.report_as_warning(Rule::not_finite, pointer("accessors", i),
                          "element " + std::to_string(element) + " holds NaN or infinity; nothing uses the accessor");
  }
}

namespace {

/// One sampler that no channel uses.
class SamplerCheck {
 public:
  SamplerCheck(const gltf::Document& document, std::string place, IssueLog& log)
      : document_(document), place_(std::move(place)), log_(log) {}

  void run(const gltf::AnimationSampler& sampler) {
    const gltf::Accessor &input = document_.accessors[sampler.input], &output = document_.accessors[sampler.output];
    if (input.type != gltf::ElementType::scalar || input.component_type != gltf::ComponentType::f32)
      return warn(Rule::animation_input, "input", "key times are not scalar floats");
    if (input.count == 0) return warn(Rule::animation_no_keys, "input", "no keys");
    const std::vector<float> times = read_floats(document_, sampler.input);
    if (!std::all_of(times.begin(), times.end(), [](float t) { return std::isfinite(t) && t >= 0.0f; }) ||
        !std::is_sorted(times.begin(), times.end()))
      return warn(Rule::animation_times, "input", "key times are negative, decreasing or not finite");
    const std::uint64_t per_key = sampler.interpolation == "CUBICSPLINE" ? 3 : 1;
    if (output.count == 0 || output.count % (input.count * per_key) != 0)
      return warn(Rule::animation_output, "output",
                  std::to_string(output.count) + " values for " + std::to_string(input.count) + " keys");
    const std::vector<float> values = read_floats(document_, sampler.output);
    if (!std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); }))
      warn(Rule::animation_values, "output", "holds NaN or infinity");
  }

 private:
  void warn(Rule rule, const char* part, const std::string& detail) {
    log_.report_as_warning(rule, pointer(place_, part), detail + "; no channel uses the sampler");
  }

  const gltf::Document& document_;
  std::string place_;
  IssueLog& log_;
};

}  // namespace

void check_unused_samplers(const gltf::Document& document, IssueLog& log) {
  std::uint64_t total = 0;
  for (std::size_t a = 0; a < document.animations.size(); ++a) {
    const auto& [name, samplers, channels, extras] = document.animations[a];
    std::vector<bool> used(samplers.size(), false);
    for (const auto& channel : channels)
      if (channel.sampler < used.size()) used[channel.sampler] = true;
    for (std::size_t s = 0; s < samplers.size(); ++s) {
      const gltf::AnimationSampler& sampler = samplers[s];
      if (used[s] || sampler.input == kNone || sampler.output == kNone) continue;
      total += document.accessors[sampler.input].count + 16 * document.accessors[sampler.output].count;
      if (total > kMaxUnusedElements) return;
      SamplerCheck(document, pointer("animations", a, "samplers", s), log).run(sampler);
    }
  }
}

void check_position_bounds(const gltf::Document& document, IssueLog& log) {
  for (std::size_t m = 0; m < document.meshes.size(); ++m)
    for (std::size_t p = 0; p < document.meshes[m].primitives.size(); ++p) {
      const auto& attributes = document.meshes[m].primitives[p].attributes;
      const auto position = attributes.find("POSITION");
      if (position == attributes.end()) continue;
      const gltf::Accessor& accessor = document.accessors[position->second];
      if (accessor.min.empty() || accessor.max.empty())
        log.report(Rule::mesh_position_bounds, pointer("meshes", m, "primitives", p, "attributes", "POSITION"),
                   "positions without min and max; taken from the data");
    }
}

}  // namespace sinew
