// SPDX-License-Identifier: MIT
#include "importer/rewrite/key_writer.h"

#include <cstring>
#include <utility>

#include "importer/rewrite/take_decoded.h"

namespace sinew::rewrite {
namespace {

template <class Track>
std::optional<Keys> without_values(const Track& track, std::size_t components) {
  if (track.empty() || track.interpolation == Interpolation::squad) return std::nullopt;
  return Keys{track.interpolation, track.times_s, {}, components};
}

}  // namespace

std::optional<Keys> keys_of(const Vec3Track& track) {
  auto keys = without_values(track, 3);
  for (std::size_t i = 0; keys && i < track.values.size(); ++i) {
    const glm::vec3& v = track.values[i];
    keys->values.insert(keys->values.end(), {v.x, v.y, v.z});
  }
  return keys;
}

std::optional<Keys> keys_of(const QuatTrack& track) {
  auto keys = without_values(track, 4);
  for (std::size_t i = 0; keys && i < track.values.size(); ++i) {
    const glm::quat& q = track.values[i];
    keys->values.insert(keys->values.end(), {q.x, q.y, q.z, q.w});
  }
  return keys;
}

std::optional<Keys> keys_of(const WeightTrack& track) {
  auto keys = without_values(track, 1);
  if (keys) keys->values = track.values;
  return keys;
}

std::optional<Keys> keys_of(const PropertyTrack& track) {
  auto keys = keys_of(track.values);
  if (!keys) return keys;
  keys->components = track.values.target_count;
  keys->flags = is_flag(track.target.kind);
  return keys;
}

void KeyWriter::write(const Keys& keys, Json& sampler, const StoredValues* stored) {
  static const char* const kNames[] = {"STEP", "LINEAR", "CUBICSPLINE"};
  auto [times, is_new] = times_.try_emplace(keys.times_s, 0);
  if (is_new) {
    times->second = add(keys.times_s, 1);
    Json& accessor = draft_.json["accessors"][times->second];
    set_bounds(accessor, std::vector<double>(keys.times_s.begin(), keys.times_s.end()), 1);
  }
  sampler["input"] = times->second;
  if (stored != nullptr)
    sampler["output"] = add_integers(*stored, keys.values.size() / keys.components, keys.components);
  else
    sampler["output"] = keys.flags ? add_flags(keys.values) : add_shared(keys.values, keys.components);
  sampler.erase("interpolation");  // LINEAR is the default
  if (keys.interpolation != Interpolation::linear)
    sampler["interpolation"] = kNames[static_cast<std::size_t>(keys.interpolation)];
}

void KeyWriter::finish() {
  if (!integer_accessors_.empty()) {
    const std::uint32_t view = draft_.add_view(std::move(integers_));
    for (const std::uint32_t accessor : integer_accessors_) draft_.json["accessors"][accessor]["bufferView"] = view;
  }
  if (accessors_.empty()) return;
  std::vector<std::byte> bytes(floats_.size() * sizeof(float));
  std::memcpy(bytes.data(), floats_.data(), bytes.size());
  const std::uint32_t view = draft_.add_view(std::move(bytes));
  for (const std::uint32_t accessor : accessors_) draft_.json["accessors"][accessor]["bufferView"] = view;
}

std::uint32_t KeyWriter::add_shared(const std::vector<float>& values, std::size_t components) {
  if (values.size() > kFewNumbers) return add(values, components);
  const auto [known, is_new] = values_.try_emplace({components, values}, 0);
  if (is_new) known->second = add(values, components);
  return known->second;
}

std::uint32_t KeyWriter::add_integers(const StoredValues& stored, std::size_t count, std::size_t components) {
  static const char* const kTypes[] = {"SCALAR", "SCALAR", "VEC2", "VEC3", "VEC4"};
  Json accessor{
      {"componentType", stored.component_type}, {"normalized", true}, {"count", count}, {"type", kTypes[components]}};
  if (!integers_.empty()) accessor["byteOffset"] = integers_.size();
  integers_.insert(integers_.end(), stored.bytes.begin(), stored.bytes.end());
  integers_.resize((integers_.size() + 3) / 4 * 4);
  integer_accessors_.push_back(add_accessor(std::move(accessor)));
  return integer_accessors_.back();
}

std::uint32_t KeyWriter::add(const std::vector<float>& values, std::size_t components) {
  static const char* const kTypes[] = {"SCALAR", "SCALAR", "VEC2", "VEC3", "VEC4"};
  Json accessor{{"componentType", 5126}, {"count", values.size() / components}, {"type", kTypes[components]}};
  if (!floats_.empty()) accessor["byteOffset"] = floats_.size() * sizeof(float);
  floats_.insert(floats_.end(), values.begin(), values.end());
  accessors_.push_back(add_accessor(std::move(accessor)));
  return accessors_.back();
}

/// Adds flags as bytes, in a separate view.
std::uint32_t KeyWriter::add_flags(const std::vector<float>& values) {
  std::vector<std::byte> flags;
  for (const float value : values) flags.push_back(static_cast<std::byte>(value >= 0.5f));
  Json accessor{{"componentType", 5121}, {"count", flags.size()}, {"type", "SCALAR"}};
  accessor["bufferView"] = draft_.add_view(std::move(flags));
  return add_accessor(std::move(accessor));
}

std::uint32_t KeyWriter::add_accessor(Json accessor) {
  Json& accessors = draft_.json["accessors"];
  accessors.push_back(std::move(accessor));
  return static_cast<std::uint32_t>(accessors.size() - 1);
}

}  // namespace sinew::rewrite
