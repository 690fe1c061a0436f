// SPDX-License-Identifier: MIT
#include "importer/rewrite/quantize_streams.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "importer/rewrite/take_decoded.h"
#include "importer/rewrite/weight_bits.h"

namespace sinew::rewrite {
namespace {

constexpr int kBitsOfAims = 16;  // 12 bits turn a camera by 0.03 degrees for each joint above it

std::vector<float> floats_of(const Stream& stream, std::size_t components) {
  std::vector<float> out(stream.count * components);
  for (std::size_t i = 0; i < stream.count; ++i)
    std::memcpy(out.data() + i * components, stream.bytes.data() + i * stream.stride, components * sizeof(float));
  return out;
}

/// Stores integers as T, with `stride` bytes per element.
template <class T>
void store(const std::vector<double>& values, std::size_t components, std::size_t stride, Stream& stream) {
  stream.stride = stride;
  stream.bytes.assign(stream.count * stride, std::byte{0});
  for (std::size_t i = 0; i < stream.count; ++i)
    for (std::size_t c = 0; c < components; ++c) {
      const T value = static_cast<T>(values[i * components + c]);
      std::memcpy(stream.bytes.data() + i * stride + c * sizeof(T), &value, sizeof(T));
    }
}

bool within_unit(const std::vector<float>& values) {
  return std::all_of(values.begin(), values.end(), [](float v) { return v >= 0.0f && v <= 1.0f; });
}

/// Quantizes values of [-1, 1] or [0, 1] to multiples of 1 / `most`.
std::vector<double> scaled(const std::vector<float>& values, double most) {
  std::vector<double> out;
  out.reserve(values.size());
  for (const float v : values) out.push_back(std::round(static_cast<double>(v) * most));
  return out;
}

class Quantizer {
 public:
  Quantizer(const QuantizeBits& bits, bool filters, Draft& draft) : bits_(bits), filters_(filters), draft_(draft) {}

  void vertex(Stream& stream, Json& accessor) {
    const std::size_t n = component_count(accessor);
    const std::string& what = stream.semantic;
    if (what.starts_with("JOINTS_") && accessor["componentType"] == kUnsignedShort) return joints(stream, accessor);
    if (accessor["componentType"] != kFloat) return;
    if ((what == "NORMAL" && n == 3) || (what == "TANGENT" && n == 4)) return directions(stream, accessor, n);
    if (what.starts_with("TEXCOORD_") && n == 2) return texcoords(stream, accessor);
    if (what.starts_with("COLOR_")) return colors(stream, accessor, n);
    if ((what == "target NORMAL" || what == "target TANGENT") && n == 3 && within(stream, 3))
      return small_vectors(stream, accessor);
    if (what == "POSITION" || what.starts_with("target ")) round_floats(stream, accessor, n, bits_.positions);
  }

  void weights(std::uint32_t index, Stream& stream, Json& accessor) {
    if (accessor["componentType"] != kFloat || component_count(accessor) != 4) return;
    const std::vector<float> values = floats_of(stream, 4);
    if (!within_unit(values)) return;
    const bool fine = bits_.fine_weights.contains(index);
    std::vector<double> rounded;
    for (std::size_t v = 0; v < stream.count; ++v) {
      const std::array<float, 4> before{values[4 * v], values[4 * v + 1], values[4 * v + 2], values[4 * v + 3]};
      const std::array<double, 4> after = rounded_weights(before, fine ? 65535.0 : 255.0);
      rounded.insert(rounded.end(), after.begin(), after.end());
      for (std::size_t i = 0; i < 4; ++i)
        if (before[i] > 0.0f && after[i] == 0.0) zeroed_[index].push_back(4 * v + i);
    }
    fine ? store<std::uint16_t>(rounded, 4, 8, stream) : store<std::uint8_t>(rounded, 4, 4, stream);
    set_normalized(accessor, fine ? kUnsignedShort : kUnsignedByte);
  }

  /// For each accessor of weights, the components that became 0. Each vertex has four components.
  const std::map<std::uint32_t, std::vector<std::size_t>>& zeroed() const { return zeroed_; }

  /// in   interpolated   false for CUBICSPLINE, whose tangents are not unit vectors
  ///      aims           the keys turn a node with a camera or a light, or a node above one
  void keys(Stream& stream, Json& accessor, bool rotation, bool interpolated, bool aims) {
    if (accessor["componentType"] != kFloat) return;
    const std::size_t n = component_count(accessor);
    if (n == 3 && interpolated) return round_floats(stream, accessor, 3, bits_.key_vectors);
    if (!rotation || !interpolated || n != 4) return;
    const std::vector<float> values = floats_of(stream, 4);
    const bool unit = std::all_of(values.begin(), values.end(), [](float v) { return std::abs(v) <= 1.0f; });
    if (!unit) return;
    if (filters_) {
      const int bits = aims ? kBitsOfAims : bits_.rotations;
      filter(Filter::quaternion, 8, stream,
             [&] { meshopt_encodeFilterQuat(stream.bytes.data(), stream.count, 8, bits, values.data()); });
    } else {
      store<std::int16_t>(scaled(values, 32767.0), 4, 8, stream);
    }
    set_normalized(accessor, kShort);
  }

 private:
  template <class Encode>
  void filter(Filter kind, std::size_t stride, Stream& stream, Encode encode) {
    stream.stride = stride;
    stream.filter = kind;
    stream.bytes.assign(stream.count * stride, std::byte{0});
    encode();
  }

  void directions(Stream& stream, Json& accessor, std::size_t n) {
    const std::vector<float> values = floats_of(stream, n);
    if (filters_) {
      std::vector<float> four(4 * stream.count, 0.0f);
      for (std::size_t i = 0; i < stream.count; ++i)
        std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(i * n), n,
                    four.begin() + static_cast<std::ptrdiff_t>(4 * i));
      filter(Filter::octahedral, 4, stream,
             [&] { meshopt_encodeFilterOct(stream.bytes.data(), stream.count, 4, bits_.normals, four.data()); });
    } else {
      const bool unit = std::all_of(values.begin(), values.end(), [](float v) { return std::abs(v) <= 1.0f; });
      if (!unit) return;
      store<std::int8_t>(scaled(values, 127.0), n, 4, stream);
    }
    set_normalized(accessor, kByte);
    declare(draft_, "KHR_mesh_quantization", true);
  }

  static bool within(const Stream& stream, std::size_t n) {
    const std::vector<float> values = floats_of(stream, n);
    return std::all_of(values.begin(), values.end(), [](float v) { return std::abs(v) <= 1.0f; });
  }

  /// Quantizes displacements of directions.
  void small_vectors(Stream& stream, Json& accessor) {
    store<std::int8_t>(scaled(floats_of(stream, 3), 127.0), 3, 4, stream);
    set_normalized(accessor, kByte);
    declare(draft_, "KHR_mesh_quantization", true);
  }

  void texcoords(Stream& stream, Json& accessor) {
    const std::vector<float> values = floats_of(stream, 2);
    if (!within_unit(values)) return round_floats(stream, accessor, 2, bits_.positions);
    const double steps = std::exp2(bits_.texcoords) - 1.0;
    std::vector<double> shorts = scaled(values, steps);
    for (double& value : shorts) value = std::round(value / steps * 65535.0);
    store<std::uint16_t>(shorts, 2, 4, stream);
    set_normalized(accessor, kUnsignedShort);
  }

  void colors(Stream& stream, Json& accessor, std::size_t n) {
    const std::vector<float> values = floats_of(stream, n);
    if (!within_unit(values)) return;
    store<std::uint8_t>(scaled(values, 255.0), n, 4, stream);
    set_normalized(accessor, kUnsignedByte);
  }

  void joints(Stream& stream, Json& accessor) {
    std::vector<double> values;
    for (std::size_t i = 0; i < stream.count; ++i)
      for (std::size_t c = 0; c < 4; ++c) values.push_back(stream.at<std::uint16_t>(i, c));
    if (std::any_of(values.begin(), values.end(), [](double joint) { return joint > 255.0; })) return;
    store<std::uint8_t>(values, 4, 4, stream);
    accessor["componentType"] = kUnsignedByte;
  }

  /// Clears low mantissa bits, which only saves bytes after compression. Updates the bounds.
  void round_floats(Stream& stream, Json& accessor, std::size_t n, int bits) {
    if (!filters_) return;
    const std::vector<float> values = floats_of(stream, n);
    filter(Filter::exponential, 4 * n, stream,
           [&] { meshopt_encodeFilterExp(stream.bytes.data(), stream.count, 4 * n, bits, values.data()); });
    if (!has_bounds(accessor)) return;
    Stream decoded = stream;
    meshopt_decodeFilterExp(decoded.bytes.data(), decoded.count, 4 * n);
    const std::vector<float> rounded = floats_of(decoded, n);
    set_bounds(accessor, std::vector<double>(rounded.begin(), rounded.end()), n);
  }

  const QuantizeBits& bits_;
  bool filters_;
  Draft& draft_;
  std::map<std::uint32_t, std::vector<std::size_t>> zeroed_;
};

/// The WEIGHTS_0 accessors of primitives with a single set. The sum over several sets could not be preserved.
std::set<std::uint32_t> single_weights(Draft& draft) {
  std::set<std::uint32_t> single, others;
  for (const Json& mesh : list_of(draft, "meshes"))
    for (const Json& primitive : mesh["primitives"]) {
      const Json& attributes = primitive["attributes"];
      for (const auto& [semantic, accessor] : attributes.items())
        if (semantic.starts_with("WEIGHTS_"))
          (attributes.contains("WEIGHTS_1") ? others : single).insert(index_of(accessor));
    }
  for (const std::uint32_t accessor : others) single.erase(accessor);
  return single;
}

/// Kinds of key values in the outputs of all animation samplers.
struct KeyKinds {
  std::set<std::uint32_t> rotations, others, cubic;
  std::set<std::uint32_t> aims;  ///< outputs that turn nodes with a camera or a light, or nodes above one
};

/// The nodes with a camera or a light, and all nodes above them.
std::set<std::uint32_t> aiming_nodes(Draft& draft) {
  const Json& nodes = list_of(draft, "nodes");
  std::vector<std::uint32_t> parents(nodes.size(), kNone);
  for (std::uint32_t n = 0; n < nodes.size(); ++n)
    for (const Json& child : nodes[n].value("children", Json::array())) parents[index_of(child)] = n;
  std::set<std::uint32_t> out;
  for (std::uint32_t n = 0; n < nodes.size(); ++n) {
    const bool aims =
        nodes[n].contains("camera") || nodes[n].value("extensions", Json::object()).contains("KHR_lights_punctual");
    for (std::uint32_t at = n; aims && at != kNone && out.insert(at).second; at = parents[at]) {
    }
  }
  return out;
}

KeyKinds find_keys(Draft& draft) {
  KeyKinds kinds;
  const std::set<std::uint32_t> aiming = aiming_nodes(draft);
  for (const Json& animation : list_of(draft, "animations")) {
    for (const Json& sampler : animation["samplers"])
      if (sampler.value("interpolation", "") == "CUBICSPLINE") kinds.cubic.insert(index_of(sampler["output"]));
    for (const Json& channel : animation["channels"]) {
      const Json& sampler = animation["samplers"][index_of(channel["sampler"])];
      const bool rotation = channel["target"].value("path", "") == "rotation";
      (rotation ? kinds.rotations : kinds.others).insert(index_of(sampler["output"]));
      if (const auto node = channel["target"].find("node");
          node != channel["target"].end() && aiming.contains(index_of(*node)))
        kinds.aims.insert(index_of(sampler["output"]));
    }
  }
  return kinds;
}

/// Updates min and max to the current elements; removes them for filtered vectors, which do not need them.
void renew_bounds(const Stream& stream, Json& accessor) {
  if (!has_bounds(accessor)) return;
  if (stream.filter == Filter::none) {
    set_bounds(accessor, stored_values(stream, accessor), component_count(accessor));
  } else if (stream.filter != Filter::exponential) {
    for (const char* bound : {"min", "max"}) accessor.erase(bound);
  }
}

/// Lets weights that became 0 name joint 0, as glTF asks. Joints that primitives share with different weights stay.
void clear_joints(const std::map<std::uint32_t, std::vector<std::size_t>>& zeroed, Streams& streams, Draft& draft) {
  // The accessors of weights that are used with each accessor of joints
  std::map<std::uint32_t, std::set<std::uint32_t>> weights_of;
  for (const Json& mesh : list_of(draft, "meshes"))
    for (const Json& primitive : mesh["primitives"]) {
      const Json& attributes = primitive["attributes"];
      for (const auto& [semantic, accessor] : attributes.items())
        if (semantic.starts_with("JOINTS_"))
          weights_of[index_of(accessor)].insert(
              index_of(attributes.value("WEIGHTS_" + semantic.substr(7), Json(kNone))));
    }
  for (const auto& [joints, weights] : weights_of) {
    const auto components = zeroed.find(*weights.begin());
    const auto stream = streams.find(joints);
    if (weights.size() != 1 || components == zeroed.end() || stream == streams.end()) continue;
    const std::size_t bytes = draft.json["accessors"][joints]["componentType"] == kUnsignedByte ? 1 : 2;
    for (const std::size_t component : components->second) {
      const std::size_t at = component / 4 * stream->second.stride + component % 4 * bytes;
      if (at + bytes > stream->second.bytes.size()) continue;
      std::fill_n(stream->second.bytes.begin() + static_cast<std::ptrdiff_t>(at), bytes, std::byte{0});
    }
    renew_bounds(stream->second, draft.json["accessors"][joints]);
  }
}

}  // namespace

void quantize_streams(const QuantizeBits& bits, bool filters, Streams& streams, Draft& draft) {
  Quantizer quantizer(bits, filters, draft);
  const std::set<std::uint32_t> weights = single_weights(draft);
  const KeyKinds keys = find_keys(draft);
  for (auto& [index, stream] : streams) {
    Json& accessor = draft.json["accessors"][index];
    if (weights.contains(index) && stream.semantic == "WEIGHTS_0")
      quantizer.weights(index, stream, accessor);
    else if (stream.use == StreamUse::vertex)
      quantizer.vertex(stream, accessor);
    else if (stream.use == StreamUse::key_values && bits.keys)
      quantizer.keys(stream, accessor, keys.rotations.contains(index) && !keys.others.contains(index),
                     !keys.cubic.contains(index), keys.aims.contains(index));
    renew_bounds(stream, accessor);
  }
  clear_joints(quantizer.zeroed(), streams, draft);
}

}  // namespace sinew::rewrite
