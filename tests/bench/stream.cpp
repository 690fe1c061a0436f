// SPDX-License-Identifier: MIT
#include "tests/bench/stream.h"

#include <benchmark/benchmark.h>
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/bench/stream.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace sinew::bench::HWY_NAMESPACE {
namespace {
namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, 16>;

/// Streams between two buffers. Returns the sum of everything read, so that the compiler cannot remove the reads.
float stream(const float* in, std::size_t in_count, float* out, std::size_t out_count, bool past_caches) {
  const Floats d;
  const std::size_t lanes = hn::Lanes(d), steps = out_count / lanes;
  auto sum = hn::Zero(d);
  std::size_t read = 0;
  for (std::size_t i = 0; i < steps; ++i) {
    for (const std::size_t end = in_count / lanes * (i + 1) / steps * lanes; read < end; read += lanes)
      sum = hn::Add(sum, hn::Load(d, in + read));
    if (past_caches)
      hn::Stream(sum, d, out + i * lanes);
    else
      hn::Store(sum, d, out + i * lanes);
  }
  return hn::GetLane(hn::SumOfLanes(d, sum));
}

}  // namespace
}  // namespace sinew::bench::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew::bench {
namespace {
HWY_EXPORT(stream);
constexpr std::size_t kCaches = std::size_t{8} << 20;
}  // namespace

StreamTraffic::StreamTraffic(std::size_t bytes_in, std::size_t bytes_out)
    : in_(bytes_in / sizeof(Line) + 1), out_(bytes_out / sizeof(Line) + 1) {}

void StreamTraffic::run() {
  const std::size_t floats = sizeof(Line) / sizeof(float);
  float sum = HWY_DYNAMIC_DISPATCH(stream)(in_[0].floats, in_.size() * floats, out_[0].floats, out_.size() * floats,
                                           out_.size() * sizeof(Line) > kCaches);
  benchmark::DoNotOptimize(sum);
}

}  // namespace sinew::bench
#endif
