// SPDX-License-Identifier: MIT
#include "runtime/animation/annotations.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace sinew {
namespace {

using testing::ElementsAre;

Annotations with_curve(CurveBlend blend, CurveKeys keys) {
  Annotations notes;
  notes.curves = {{"curve", blend, std::move(keys)}};
  return notes;
}

TEST(annotations, events_are_kept_in_order_of_time_and_of_adding) {
  Annotations notes;
  notes.add_event(2.0, "c");
  notes.add_event(1.0, "a");
  notes.add_event(1.0, "b");
  EXPECT_THAT(notes.event_times_s, ElementsAre(1.0, 1.0, 2.0));
  EXPECT_THAT(notes.event_names, ElementsAre("a", "b", "c"));
  EXPECT_EQ(check(notes, 2.0), ErrorCode::ok);
}

TEST(annotations, refuses_events_outside_of_the_clip_or_out_of_order) {
  Annotations notes;
  notes.add_event(2.0, "late");
  EXPECT_EQ(check(notes, 1.999), ErrorCode::outside_of_clip);
  notes.event_times_s = {std::numeric_limits<double>::quiet_NaN()};
  EXPECT_EQ(check(notes, 3.0), ErrorCode::outside_of_clip);
  notes.event_times_s = {1.0, 0.5};
  EXPECT_EQ(check(notes, 3.0), ErrorCode::size_mismatch);
  notes.event_names = {"a", "b"};
  EXPECT_EQ(check(notes, 3.0), ErrorCode::times_not_increasing);
}

TEST(annotations, refuses_curves_that_cannot_be_blended_as_they_ask) {
  const std::vector<CurveKey<bool>> flag{{0.0f, CurveStep::hold, true}};
  const std::vector<CurveKey<glm::quat>> aim{{0.0f, CurveStep::linear, glm::quat(1, 0, 0, 0)}};
  EXPECT_EQ(check(with_curve(CurveBlend::mean, flag), 1.0), ErrorCode::ok);
  EXPECT_EQ(check(with_curve(CurveBlend::sum, flag), 1.0), ErrorCode::unsupported);
  EXPECT_EQ(check(with_curve(CurveBlend::sum, aim), 1.0), ErrorCode::unsupported);
  EXPECT_EQ(check(with_curve(static_cast<CurveBlend>(3), aim), 1.0), ErrorCode::unsupported);
  EXPECT_EQ(check(with_curve(CurveBlend::mean, std::vector<CurveKey<float>>{}), 1.0), ErrorCode::too_few_keys);
}

TEST(annotations, finds_curves_by_name_and_type) {
  const Annotations notes = with_curve(CurveBlend::sum, std::vector<CurveKey<float>>{{0.0f, CurveStep::hold, 2.0f}});
  ASSERT_NE(notes.find_curve("curve"), nullptr);
  EXPECT_EQ(notes.find_curve("curv"), nullptr);
  EXPECT_EQ(notes.find_curve("curve")->keys_of<float>().size(), 1u);
  EXPECT_TRUE(notes.find_curve("curve")->keys_of<bool>().empty());
}

}  // namespace
}  // namespace sinew
