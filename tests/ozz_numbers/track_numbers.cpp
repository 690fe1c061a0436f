// SPDX-License-Identifier: MIT
// Curves whose keys hold or go straight, and the edges where they cross a threshold.
#include <array>
#include <vector>

#include "runtime/animation/curve.h"
#include "runtime/playback/curve_edges.h"
#include "tests/ozz_numbers/tally.h"

namespace sinew::ozz {
namespace {

constexpr CurveStep kLine = CurveStep::linear, kHold = CurveStep::hold;

template <class V>
struct At {
  double time;
  V value;
};

template <class V>
void compare_values(const std::vector<CurveKey<V>>& keys, const std::vector<At<V>>& expected, Tally& tally) {
  EXPECT_EQ(check(Curve<V>(keys)), ErrorCode::ok);
  for (const At<V>& at : expected) {
    const V found = sample(Curve<V>(keys), at.time);
    if constexpr (std::is_same_v<V, float>)
      compare(double(found), double(at.value), kTolerance, tally);
    else if constexpr (kIsRotation<V>)
      compare_rotation(found, at.value, tally);
    else
      for (int c = 0; c < V::length(); ++c) compare(double(found[c]), double(at.value[c]), kTolerance, tally);
  }
}

/// The four keys of the tests of vectors: a line to `middle`, held until .7, where twice that goes to 0 at .9.
template <class V>
void compare_ramp(const V& middle, Tally& tally) {
  const V zero(0.0f), twice = middle * 2.0f;
  compare_values<V>({{0, kLine, zero}, {0.5f, kHold, middle}, {0.7f, kLine, twice}, {0.9f, kLine, zero}},
                    {{0.0, zero},
                     {0.25, middle * 0.5f},
                     {0.5, middle},
                     {0.6, middle},
                     {0.7f, twice},
                     {0.8, middle},
                     {0.9f, zero},
                     {1.0, zero}},
                    tally);
}

struct Edge {
  double time_s;
  bool rises;
};

void compare_edges(const std::vector<CurveKey<float>>& keys, float threshold, const std::vector<Edge>& expected,
                   Tally& tally) {
  const CurveEdges edges = find_edges(Curve<float>(keys), threshold, 1.0, true);
  ASSERT_EQ(edges.times_s.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    compare(edges.times_s[i], expected[i].time_s, kTolerance, tally);
    compare(edges.rises[i], expected[i].rises, 0.0, tally);
  }
}

}  // namespace

Tally float_tracks_group() {
  Tally tally;
  compare_values<float>({{0, kLine, 46}}, {{0.5, 46}}, tally);
  compare_values<float>({{0, kLine, 0}, {0.5f, kHold, 46}, {0.7f, kLine, 0}},
                        {{-1e-7, 0}, {0, 0}, {0.5, 46}, {1, 0}, {1 + 1e-7, 0}, {1.5, 0}}, tally);
  compare_ramp(4.6f, tally);
  return tally;
}

Tally vector_tracks_group() {
  Tally tally;
  compare_ramp(glm::vec2(2.3f, 4.6f), tally);
  compare_ramp(glm::vec3(0, 2.3f, 4.6f), tally);
  compare_ramp(glm::vec4(0, 2.3f, 0, 4.6f), tally);
  return tally;
}

Tally rotation_tracks_group() {
  const float h = 0.70710677f;
  const glm::quat x = quat_xyzw(h, 0.0f, 0.0f, h), y = quat_xyzw(0.0f, h, 0.0f, h), one = quat_identity<float>();
  Tally tally;
  compare_values<glm::quat>({{0, kLine, x}, {0.5f, kHold, y}, {0.7f, kLine, x}, {0.9f, kLine, one}},
                            {{0.0, x},
                             {0.4999999, y},
                             {0.5, y},
                             {0.6, y},
                             {0.7f, x},
                             {0.8, quat_xyzw(0.38268333f, 0.0f, 0.0f, 0.92387962f)},
                             {0.9f, one},
                             {1.0, one}},
                            tally);
  return tally;
}

Tally track_edges_group() {
  Tally tally;
  for (const float threshold : {0.0f, 1.0f})
    compare_edges({{0, kHold, 0}, {0.5f, kHold, 2}, {1, kHold, 0}}, threshold, {{0.5, true}, {1, false}}, tally);
  return tally;
}

}  // namespace sinew::ozz
