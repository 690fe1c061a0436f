// SPDX-License-Identifier: MIT
#include "runtime/animation/annotations.h"

#include <algorithm>
#include <type_traits>
#include <utility>

namespace sinew {

void Annotations::add_event(double time_s, std::string name) {
  const auto place = std::upper_bound(event_times_s.begin(), event_times_s.end(), time_s) - event_times_s.begin();
  event_times_s.insert(event_times_s.begin() + place, time_s);
  event_names.insert(event_names.begin() + place, std::move(name));
}

const NamedCurve* Annotations::find_curve(std::string_view name) const noexcept {
  const auto found = std::find_if(curves.begin(), curves.end(), [&](const NamedCurve& c) { return c.name == name; });
  return found == curves.end() ? nullptr : &*found;
}

ErrorCode check(const Annotations& annotations, double duration_s) noexcept {
  const std::vector<double>& times = annotations.event_times_s;
  if (times.size() != annotations.event_names.size()) return ErrorCode::size_mismatch;
  for (const double time_s : times)
    if (!(time_s >= 0.0 && time_s <= duration_s)) return ErrorCode::outside_of_clip;
  if (!std::is_sorted(times.begin(), times.end())) return ErrorCode::times_not_increasing;
  for (const NamedCurve& curve : annotations.curves) {
    if (curve.blend > CurveBlend::heaviest) return ErrorCode::unsupported;
    const ErrorCode fault = std::visit(
        [&](const auto& keys) {
          using V = decltype(keys.front().value);
          constexpr bool sums = !kIsRotation<V> && !std::is_same_v<V, bool>;
          if (!sums && curve.blend == CurveBlend::sum) return ErrorCode::unsupported;
          return check(Curve<V>(keys));
        },
        curve.keys);
    if (fault != ErrorCode::ok) return fault;
  }
  return ErrorCode::ok;
}

}  // namespace sinew
