// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "runtime/animation/curve.h"
#include "runtime/base/api.h"

namespace sinew {

/// How the values that several clips give a curve become one (playback/blend_curves.h).
enum class CurveBlend : std::uint8_t {
  mean,     ///< weighted mean; if weights sum to less than 1, the rest value has the remainder
  sum,      ///< the rest value plus each value times its weight
  heaviest  ///< the value of the clip with the largest weight
};

/// Keys of a curve, in one of the types that curves have.
using CurveKeys =
    std::variant<std::vector<CurveKey<float>>, std::vector<CurveKey<glm::vec2>>, std::vector<CurveKey<glm::vec3>>,
                 std::vector<CurveKey<glm::vec4>>, std::vector<CurveKey<glm::quat>>, std::vector<CurveKey<bool>>>;

/// A curve of a clip that an engine reads by name, for example the width of a trail.
struct NamedCurve {
  std::string name;
  CurveBlend blend = CurveBlend::mean;
  CurveKeys keys;

  /// The keys if they have this type; otherwise no keys.
  template <class V>
  Curve<V> keys_of() const noexcept {
    const auto* own = std::get_if<std::vector<CurveKey<V>>>(&keys);
    return own == nullptr ? Curve<V>() : Curve<V>(*own);
  }

  friend bool operator==(const NamedCurve&, const NamedCurve&) = default;
};

/// Events and curves that a clip carries beside its pose. They change no pose: an engine reads them.
///     for (EventCursor crossed(clock.advance(dt), notes.event_times_s); auto i = crossed.next();)
///       fire(notes.event_names[*i]);
struct Annotations {
  std::vector<double> event_times_s;     ///< [E] never decreasing, within the clip
  std::vector<std::string> event_names;  ///< [E] "left foot"; several events may have the same name
  std::vector<NamedCurve> curves;        ///< if several have one name, the first counts

  bool empty() const noexcept { return event_times_s.empty() && curves.empty(); }

  /// Adds an event behind all events at the same time or earlier.     cost O(E)
  SINEW_API void add_event(double time_s, std::string name);

  /// Null if no curve has this name.     cost O(curves)
  SINEW_API const NamedCurve* find_curve(std::string_view name) const noexcept;

  friend bool operator==(const Annotations&, const Annotations&) = default;
};

/// err  size_mismatch (not one name for each event), times_not_increasing, outside_of_clip (an event), unsupported (an
///      unknown CurveBlend; a flag or rotation that sums), and those of check(Curve)
/// cost O(events + keys)
SINEW_API ErrorCode check(const Annotations& annotations, double duration_s) noexcept;

}  // namespace sinew
