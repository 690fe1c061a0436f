// SPDX-License-Identifier: MIT
#include "runtime/clip/annotation_bytes.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace sinew {
namespace {

void write_text(const std::string& text, ByteWriter& out) { out.add(std::span<const char>(text)); }

std::string read_text(ByteReader& in) {
  const std::vector<char> text = in.numbers<char>();
  return {text.begin(), text.end()};
}

template <class V>
void write_value(const V& value, ByteWriter& out) {
  if constexpr (std::is_arithmetic_v<V>)
    out.add(static_cast<std::conditional_t<std::is_same_v<V, bool>, std::uint8_t, V>>(value));
  else
    for (int c = 0; c < value.length(); ++c) out.add(value[c]);
}

template <class V>
V read_value(ByteReader& in) {
  V value{};
  if constexpr (std::is_same_v<V, bool>)
    return in.number<std::uint8_t>() != 0;
  else if constexpr (std::is_arithmetic_v<V>)
    return in.number<V>();
  else
    for (int c = 0; c < value.length(); ++c) value[c] = in.number<float>();
  return value;
}

/// Tangents are written for cubic keys and for keys that follow one.
template <class V>
void write_keys(const std::vector<CurveKey<V>>& keys, ByteWriter& out) {
  out.add(static_cast<std::uint32_t>(keys.size()));
  const CurveKey<V>* before = nullptr;
  for (const CurveKey<V>& key : keys) {
    out.add(key.time_s);
    out.add(static_cast<std::uint8_t>(key.step));
    write_value(key.value, out);
    if (before != nullptr && before->step == CurveStep::cubic) write_value(key.in_tangent, out);
    if (key.step == CurveStep::cubic) write_value(key.out_tangent, out);
    before = &key;
  }
}

template <class V>
std::vector<CurveKey<V>> read_keys(ByteReader& in) {
  std::vector<CurveKey<V>> keys;
  for (auto left = in.number<std::uint32_t>(); left > 0 && !in.ended(); --left) {
    CurveKey<V> key;
    key.time_s = in.number<float>();
    key.step = static_cast<CurveStep>(in.number<std::uint8_t>());
    key.value = read_value<V>(in);
    if (!keys.empty() && keys.back().step == CurveStep::cubic) key.in_tangent = read_value<V>(in);
    if (key.step == CurveStep::cubic) key.out_tangent = read_value<V>(in);
    keys.push_back(key);
  }
  return keys;
}

/// Keys of the type with this index in CurveKeys; an unknown index gives no keys.
template <std::size_t... kType>
CurveKeys read_keys_of(std::size_t type, ByteReader& in, std::index_sequence<kType...>) {
  CurveKeys keys;
  const auto read = [&]<std::size_t kIndex>() {
    using V = decltype(std::variant_alternative_t<kIndex, CurveKeys>::value_type::value);
    if (type == kIndex) keys = read_keys<V>(in);
  };
  (read.template operator()<kType>(), ...);
  return keys;
}

}  // namespace

void write_annotations(const Annotations& annotations, ByteWriter& out) {
  out.add(std::span<const double>(annotations.event_times_s));
  for (const std::string& name : annotations.event_names) write_text(name, out);
  out.add(static_cast<std::uint32_t>(annotations.curves.size()));
  for (const NamedCurve& curve : annotations.curves) {
    write_text(curve.name, out);
    out.add(static_cast<std::uint8_t>(curve.blend));
    out.add(static_cast<std::uint8_t>(curve.keys.index()));
    std::visit([&](const auto& keys) { write_keys(keys, out); }, curve.keys);
  }
}

Annotations read_annotations(ByteReader& in) {
  Annotations annotations;
  annotations.event_times_s = in.numbers<double>();
  for (std::size_t e = 0; e < annotations.event_times_s.size() && !in.ended(); ++e)
    annotations.event_names.push_back(read_text(in));
  for (auto left = in.number<std::uint32_t>(); left > 0 && !in.ended(); --left) {
    NamedCurve curve;
    curve.name = read_text(in);
    curve.blend = static_cast<CurveBlend>(in.number<std::uint8_t>());
    const std::size_t type = in.number<std::uint8_t>();
    curve.keys = read_keys_of(type, in, std::make_index_sequence<std::variant_size_v<CurveKeys>>());
    annotations.curves.push_back(std::move(curve));
  }
  return annotations;
}

}  // namespace sinew
