// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "importer/rewrite/draft.h"
#include "runtime/animation/property_track.h"
#include "runtime/animation/track.h"

namespace sinew::rewrite {

/// Keys as glTF stores them.
struct Keys {
  Interpolation interpolation = Interpolation::linear;
  std::vector<float> times_s, values;
  std::size_t components = 1;  ///< components of an accessor element
  bool flags = false;          ///< values are 0 or 1 and are stored as bytes

  friend bool operator==(const Keys&, const Keys&) = default;
};

/// Converts a track. Empty for a track without keys, and for squad, which glTF does not have.
std::optional<Keys> keys_of(const Vec3Track& track);
std::optional<Keys> keys_of(const QuatTrack& track);
std::optional<Keys> keys_of(const WeightTrack& track);
std::optional<Keys> keys_of(const PropertyTrack& track);

/// Values of keys as an accessor of integers stores them, one after another.
struct StoredValues {
  int component_type = 0;
  std::vector<std::byte> bytes;
};

/// Writes keys of animations. Equal key times, and equal values of a few numbers, are written once.
class KeyWriter {
 public:
  explicit KeyWriter(Draft& draft) : draft_(draft) {}

  /// Sets input, output and interpolation of a sampler.
  /// in   stored   the values of the keys as normalised integers; without it floats are written
  void write(const Keys& keys, Json& sampler, const StoredValues* stored = nullptr);
  /// Stores the collected data in a buffer view.
  void finish();

 private:
  static constexpr std::size_t kFewNumbers = 16;

  std::uint32_t add(const std::vector<float>& values, std::size_t components);
  std::uint32_t add_shared(const std::vector<float>& values, std::size_t components);
  std::uint32_t add_integers(const StoredValues& stored, std::size_t count, std::size_t components);
  std::uint32_t add_flags(const std::vector<float>& values);
  std::uint32_t add_accessor(Json accessor);

  Draft& draft_;
  std::vector<float> floats_;
  std::vector<std::byte> integers_;
  std::vector<std::uint32_t> accessors_, integer_accessors_;
  std::map<std::vector<float>, std::uint32_t> times_;
  /// Accessors that were written, by number of components and values
  std::map<std::pair<std::size_t, std::vector<float>>, std::uint32_t> values_;
};

}  // namespace sinew::rewrite
