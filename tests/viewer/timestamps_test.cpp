// SPDX-License-Identifier: MIT
#include "viewer/device/timestamps.h"

#include <gmock/gmock.h>

#include "tests/viewer/own_driver.h"

namespace sinew::viewer {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;
using testing::IsEmpty;

class timestamps : public OwnDriverTest {
 protected:
  /// Times between three marks with these query results.
  static std::vector<double> read(std::uint32_t bits, std::vector<std::uint64_t> ticks, float period_ns = 1.0f) {
    own_driver().devices[0].queues[0].timestampValidBits = bits;
    own_driver().devices[0].properties.limits.timestampPeriod = period_ns;
    const Device device;
    Timestamps stamps(device, 3);
    own_driver().ticks = std::move(ticks);
    stamps.begin(VK_NULL_HANDLE);
    stamps.mark(VK_NULL_HANDLE);
    stamps.mark(VK_NULL_HANDLE);
    return stamps.milliseconds();
  }
};

TEST_F(timestamps, are_milliseconds_between_marks) {
  EXPECT_THAT(read(64, {1'000'000, 3'000'001, 3'500'001}), ElementsAre(DoubleEq(2.000001), DoubleEq(0.5)));
  EXPECT_THAT(read(63, {1'000'000, 3'000'001, 3'500'001}), ElementsAre(DoubleEq(2.000001), DoubleEq(0.5)));
  EXPECT_THAT(own_driver().marks, ElementsAre(0, 1, 2));
  EXPECT_EQ(own_driver().query_flags, VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT);
  EXPECT_THAT(read(36, {0, 1'000'000, 1'000'000}, 40.0f), ElementsAre(DoubleEq(40.0), DoubleEq(0.0)));
}

TEST_F(timestamps, go_on_where_the_counter_starts_again) {
  EXPECT_THAT(read(36, {(1ull << 36) - 1'000'000, 1'000'000, 3'000'000}), ElementsAre(DoubleEq(2.0), DoubleEq(2.0)));
  EXPECT_THAT(read(64, {~0ull - 999'999, 1'000'000, 3'000'000}), ElementsAre(DoubleEq(2.0), DoubleEq(2.0)));
  EXPECT_THAT(read(63, {(1ull << 63) - 1'000'000, 1'000'000, 3'000'000}), ElementsAre(DoubleEq(2.0), DoubleEq(2.0)));
}

TEST_F(timestamps, of_a_queue_without_them_are_none) {
  EXPECT_THAT(read(0, {1, 2, 3}), IsEmpty());
  EXPECT_THAT(own_driver().marks, IsEmpty());
}

TEST_F(timestamps, begin_again_with_each_picture) {
  const Device device;
  Timestamps stamps(device, 4);
  EXPECT_THAT(stamps.milliseconds(), IsEmpty()) << "nothing was drawn";
  stamps.begin(VK_NULL_HANDLE);
  EXPECT_THAT(stamps.milliseconds(), IsEmpty()) << "one mark has no length";
  EXPECT_EQ(own_driver().query_flags, 0u) << "and none is read";
  stamps.mark(VK_NULL_HANDLE);
  stamps.begin(VK_NULL_HANDLE);
  stamps.mark(VK_NULL_HANDLE);
  EXPECT_EQ(stamps.milliseconds().size(), 1u);
  EXPECT_THAT(own_driver().marks, ElementsAre(0, 1));
}

}  // namespace
}  // namespace sinew::viewer
