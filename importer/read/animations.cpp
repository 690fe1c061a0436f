// SPDX-License-Identifier: MIT
#include "importer/read/animations.h"

#include <cmath>

#include "importer/file/json_pointer.h"
#include "importer/read/accessor.h"
#include "importer/read/cut_times.h"
#include "importer/read/property_pointer.h"
#include "runtime/base/all_finite.h"

namespace sinew {
namespace {

using gltf::ComponentType;
using gltf::ElementType;

std::optional<AnimatedProperty> property_of(std::string_view path) {
  if (path == "translation") return AnimatedProperty::translation;
  if (path == "rotation") return AnimatedProperty::rotation;
  if (path == "scale") return AnimatedProperty::scale;
  if (path == "weights") return AnimatedProperty::weights;
  return std::nullopt;
}

/// Reads a KHR_animation_pointer target. A pointer to a node property is equivalent to a plain channel.
std::optional<ChannelTarget> read_pointer(const gltf::Document& document, const gltf::AnimationChannel& channel,
                                          const std::string& place, IssueLog& log) {
  PointerFault fault;
  const auto pointed = read_property_pointer(document, channel.pointer, fault);
  if (!pointed) {
    const Rule rule = fault.past_end ? Rule::reference : Rule::animation_pointer;
    const std::string detail = in_quotes(channel.pointer) + " " + fault.text;
    if (fault.past_end)
      log.report_survived(rule, place, detail + "; the channel is left out");
    else
      log.report(rule, place, detail + "; the channel is ignored");
    return std::nullopt;
  }
  if (pointed->list == PointedProperty::List::meshes)
    return ChannelTarget{AnimatedProperty::mesh_weights, pointed->index, pointed->element};
  if (const auto property = property_of(pointed->node_path))
    return ChannelTarget{*property, pointed->index, pointed->element};
  return ChannelTarget{AnimatedProperty::pointed, kNone, kNone, pointed->target};
}

ElementType element_type_of(const ChannelTarget& target) {
  constexpr ElementType kOfCount[] = {ElementType::scalar, ElementType::scalar, ElementType::vec2, ElementType::vec3,
                                      ElementType::vec4};
  switch (target.property) {
    case AnimatedProperty::translation:
    case AnimatedProperty::scale: return ElementType::vec3;
    case AnimatedProperty::rotation: return ElementType::vec4;
    case AnimatedProperty::weights:
    case AnimatedProperty::mesh_weights: return ElementType::scalar;
    case AnimatedProperty::pointed: break;
  }
  return kOfCount[component_count(target.pointed.kind)];
}

/// Allowed formats: floats for translations and scales; also normalised integers for rotations and weights; any
/// integers for pointed properties; bytes for flags.
bool output_format_fits(const gltf::Accessor& output, const ChannelTarget& target) {
  if (output.type != element_type_of(target)) return false;
  if (target.property == AnimatedProperty::pointed && is_flag(target.pointed.kind))
    return output.component_type == ComponentType::u8 && !output.normalized;
  if (output.component_type == ComponentType::f32) return true;
  const bool vector = target.property == AnimatedProperty::translation || target.property == AnimatedProperty::scale;
  return !vector && output.component_type != ComponentType::u32;
}

class SamplerReader {
 public:
  SamplerReader(const gltf::Document& document, std::uint32_t animation, std::uint32_t sampler, IssueLog& log)
      : document_(document),
        sampler_(document.animations[animation].samplers[sampler]),
        animation_index_(animation),
        sampler_index_(sampler),
        log_(log) {}

  std::optional<SamplerData> read(const ChannelTarget& target, std::uint32_t components) {
    SamplerData data;
    data.interpolation = read_interpolation();
    const bool flag = target.property == AnimatedProperty::pointed && is_flag(target.pointed.kind);
    if (flag && data.interpolation != Interpolation::step && !step_instead(data.interpolation)) return std::nullopt;
    if (!check_shape(target, components, data.interpolation)) return std::nullopt;
    warn_stride(sampler_.input, "input");
    warn_stride(sampler_.output, "output");
    data.times_s = read_floats(document_, sampler_.input);
    if (!check_times(data.times_s)) return std::nullopt;
    data.values = read_floats(document_, sampler_.output);
    if (all_finite(data.values)) cut_times(data, target.property == AnimatedProperty::rotation);
    if (!all_finite(data.values)) {
      leave_out(Rule::animation_values, "output", "holds NaN or infinity");
      return std::nullopt;
    }
    if (data.interpolation == Interpolation::cubic_spline && data.times_s.size() == 1) hold_single_key(data);
    if (flag)
      for (float& value : data.values) value = value != 0.0f ? 1.0f : 0.0f;
    return data;
  }

 private:
  std::string place_of(const char* part) const {
    return pointer("animations", animation_index_, "samplers", sampler_index_, part);
  }

  Interpolation read_interpolation() {
    const std::string& word = sampler_.interpolation;
    if (word == "STEP") return Interpolation::step;
    if (word == "CUBICSPLINE") return Interpolation::cubic_spline;
    if (word != "LINEAR")
      log_.report(Rule::animation_interpolation, place_of("interpolation"),
                  in_quotes(word) + " is unknown; LINEAR is used");
    return Interpolation::linear;
  }

  /// Reports a fault that concerns only the channels with this sampler.
  bool leave_out(Rule rule, const char* part, const std::string& detail) {
    log_.report_survived(rule, place_of(part), detail + "; channels that use it are left out");
    return false;
  }

  void cut_times(SamplerData& data, bool rotation) {
    if (const std::size_t keys = cut_before_zero(data, rotation); keys > 0)
      log_.report_survived(Rule::animation_times, place_of("input"),
                           std::to_string(keys) + (keys == 1 ? " key lies" : " keys lie") +
                               " before time 0, where no clip is played; channels that use it are cut there and played "
                               "from time 0 on");
  }

  /// Flags cannot be interpolated, so LINEAR becomes STEP. CUBICSPLINE keys cannot be read as flags.
  bool step_instead(Interpolation& interpolation) {
    const bool usable = interpolation == Interpolation::linear;
    log_.report(
        Rule::animation_flag, place_of("interpolation"),
        in_quotes(sampler_.interpolation) + (usable ? "; STEP is used" : "; channels that use it are left out"));
    interpolation = Interpolation::step;
    return usable;
  }

  /// Replaces a cubic spline of one key by a step: its value holds at all times, and tangents have no effect.
  void hold_single_key(SamplerData& data) {
    log_.report(Rule::animation_cubic_keys, place_of("input"), "one key for CUBICSPLINE; its value is a constant");
    const auto third = static_cast<std::ptrdiff_t>(data.values.size() / 3);
    data.values = {data.values.begin() + third, data.values.begin() + 2 * third};
    data.interpolation = Interpolation::step;
  }

  bool check_shape(const ChannelTarget& target, std::uint32_t components, Interpolation interpolation) {
    const gltf::Accessor &input = document_.accessors[sampler_.input], &output = document_.accessors[sampler_.output];
    if (input.type != ElementType::scalar || input.component_type != ComponentType::f32)
      return leave_out(Rule::animation_input, "input", "key times are not scalar floats");
    if (!output_format_fits(output, target))
      return leave_out(Rule::animation_output, "output", "does not have the type that the animated property needs");
    if (input.count == 0) {
      log_.report(Rule::animation_no_keys, place_of("input"), "no keys; channels that use it are left out");
      return false;
    }
    const bool cubic = interpolation == Interpolation::cubic_spline;
    const std::uint64_t per_key = std::uint64_t{cubic ? 3u : 1u} * (target.moves_weights() ? components : 1u);
    if (output.count == input.count * per_key) return true;
    return leave_out(Rule::animation_output, "output",
                     std::to_string(output.count) + " values for " + std::to_string(input.count) + " keys that need " +
                         std::to_string(per_key) + " each");
  }

  void warn_stride(std::uint32_t accessor, const char* name) {
    const auto view = document_.accessors[accessor].buffer_view;
    if (view != kNone && document_.buffer_views[view].byte_stride != 0)
      log_.report(Rule::animation_stride, place_of(name), "its buffer view has a byteStride, which is used");
    const auto& bounds = document_.accessors[accessor];
    if (std::string_view(name) == "input" && (bounds.min.empty() || bounds.max.empty()))
      log_.report(Rule::animation_bounds, place_of(name), "key times without min and max; taken from the data");
  }

  bool check_times(const std::vector<float>& times) {
    bool repeated = false;
    for (std::size_t k = 0; k < times.size(); ++k) {
      const bool good = std::isfinite(times[k]) && (k == 0 || times[k] >= times[k - 1]);
      if (!good)
        return leave_out(Rule::animation_times, "input",
                         "time of key " + std::to_string(k) + " is before that of the key before it, or not finite");
      repeated = repeated || (k > 0 && times[k] == times[k - 1]);
    }
    if (repeated)
      log_.report(Rule::animation_time_repeated, place_of("input"),
                  "two keys at one time are a jump: the later value holds from there");
    return true;
  }

  const gltf::Document& document_;
  const gltf::AnimationSampler& sampler_;
  std::uint32_t animation_index_, sampler_index_;
  IssueLog& log_;
};

}  // namespace

std::optional<ChannelTarget> read_channel_target(const gltf::Document& document, std::uint32_t animation,
                                                 std::uint32_t index, IssueLog& log) {
  const gltf::AnimationChannel& channel = document.animations[animation].channels[index];
  const auto place = [&] { return pointer("animations", animation, "channels", index, "target"); };
  if (channel.path == "pointer") return read_pointer(document, channel, place(), log);
  const auto property = property_of(channel.path);
  if (!property) {
    log.report(Rule::animation_path, pointer(place(), "path"),
               in_quotes(channel.path) + " is unknown; the channel is ignored");
    return std::nullopt;
  }
  if (channel.node == kNone) {
    log.report(Rule::animation_no_target, place(), "names no node; the channel is ignored");
    return std::nullopt;
  }
  return ChannelTarget{*property, channel.node};
}

std::optional<SamplerData> read_sampler(const gltf::Document& document, std::uint32_t animation, std::uint32_t sampler,
                                        const ChannelTarget& target, std::uint32_t components, IssueLog& log) {
  return SamplerReader(document, animation, sampler, log).read(target, components);
}

}  // namespace sinew
