// SPDX-License-Identifier: MIT
#include "importer/tool/cost/geometry_cache/stored_frames.h"

#include <meshoptimizer.h>
#include <zstd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <type_traits>
#include <utility>

#include "runtime/base/contract.h"

namespace sinew::cost {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Numbers = std::vector<std::int32_t>;  // x, y, z of each point

class Floats : public StoredFrames {
 public:
  explicit Floats(const PointFrames& frames) : frames_(frames) {}
  std::size_t bytes() const override { return frames_.size() * frames_[0].size() * sizeof(glm::vec3); }
  void decode(std::size_t frame, std::span<glm::vec3> out) override {
    std::copy(frames_[frame].begin(), frames_[frame].end(), out.begin());
  }

 private:
  PointFrames frames_;
};

/// A half-precision number as a float: exact for all finite numbers.
float float_of(std::uint16_t half) {
  const std::uint32_t sign = std::uint32_t{half} << 16 & 0x80000000u, rest = (half & 0x7fffu) << 13;
  return std::bit_cast<float>(std::bit_cast<std::uint32_t>(std::bit_cast<float>(rest) * 0x1p112f) | sign);
}

class Halves : public StoredFrames {
 public:
  explicit Halves(const PointFrames& frames) {
    for (const auto& frame : frames)
      for (auto& out = frames_.emplace_back(); const glm::vec3& p : frame)
        for (int axis = 0; axis < 3; ++axis) out.push_back(glm::packHalf1x16(p[axis]));
  }
  std::size_t bytes() const override { return frames_.size() * frames_[0].size() * sizeof(std::uint16_t); }
  void decode(std::size_t frame, std::span<glm::vec3> out) override {
    const std::uint16_t* from = frames_[frame].data();
    float* to = &out[0].x;
    for (std::size_t i = 0; i < 3 * out.size(); ++i) to[i] = float_of(from[i]);
  }

 private:
  std::vector<std::vector<std::uint16_t>> frames_;
};

/// Packs the bytes of integers by zstd at level 19.
struct ByZstd {
  static Bytes pack(const Bytes& plain, std::size_t) {
    Bytes out(ZSTD_compressBound(plain.size()));
    out.resize(ZSTD_compress(out.data(), out.size(), plain.data(), plain.size(), 19));
    return out;
  }
  static void unpack(const Bytes& packed, std::size_t, Bytes& out) {
    CONTRACT(ZSTD_decompress(out.data(), out.size(), packed.data(), packed.size()) == out.size());
  }
};

/// Packs integers by meshoptimizer's vertex codec, `stride` bytes a vertex.
struct ByMeshopt {
  static Bytes pack(const Bytes& plain, std::size_t stride) {
    const std::size_t count = plain.size() / stride;
    Bytes out(meshopt_encodeVertexBufferBound(count, stride));
    out.resize(meshopt_encodeVertexBuffer(out.data(), out.size(), plain.data(), count, stride));
    return out;
  }
  static void unpack(const Bytes& packed, std::size_t stride, Bytes& out) {
    CONTRACT(meshopt_decodeVertexBuffer(out.data(), out.size() / stride, stride, packed.data(), packed.size()) == 0);
  }
};

/// Coordinates as multiples of a step, packed frame by frame. With kResiduals a frame stores its differences from the
/// prediction 2 x1 - x2, where x1 and x2 are the two frames before it. A point takes kStride bytes before packing.
template <class Codec, class Number, std::size_t kStride, bool kResiduals>
class Quantised : public StoredFrames {
 public:
  Quantised(const std::vector<Numbers>& frames, double step) : step_(static_cast<float>(step)) {
    const std::size_t points = frames[0].size() / 3;
    plain_.resize(points * kStride);
    for (std::size_t f = 0; f < frames.size(); ++f) {
      for (std::size_t i = 0; i < 3 * points; ++i) put(i, frames[f][i] - predicted(frames, f, i));
      frames_.push_back(Codec::pack(plain_, kStride));
    }
    x1_.resize(3 * points);
    x2_ = x1_;
  }
  std::size_t bytes() const override {
    std::size_t sum = 0;
    for (const Bytes& frame : frames_) sum += frame.size();
    return sum;
  }
  void decode(std::size_t frame, std::span<glm::vec3> out) override {
    Codec::unpack(frames_[frame], kStride, plain_);
    float* to = &out[0].x;
    for (std::size_t p = 0; p < out.size(); ++p)
      for (std::size_t a = 0; a < 3; ++a) {
        const std::size_t i = 3 * p + a;
        Number number;
        std::memcpy(&number, plain_.data() + p * kStride + a * sizeof(Number), sizeof(number));
        std::int32_t x = number;
        if constexpr (kResiduals) {
          if (frame > 0) x += frame > 1 ? 2 * x1_[i] - x2_[i] : x1_[i];
          x2_[i] = x;
        }
        to[i] = static_cast<float>(x) * step_;
      }
    std::swap(x1_, x2_);
  }

 private:
  static std::int32_t predicted(const std::vector<Numbers>& frames, std::size_t f, std::size_t i) {
    if (!kResiduals || f == 0) return 0;
    return f > 1 ? 2 * frames[f - 1][i] - frames[f - 2][i] : frames[f - 1][i];
  }
  void put(std::size_t i, std::int32_t number) {
    const auto stored = static_cast<Number>(number);
    std::memcpy(plain_.data() + i / 3 * kStride + i % 3 * sizeof(Number), &stored, sizeof(stored));
  }

  float step_;
  Bytes plain_;
  std::vector<Bytes> frames_;
  Numbers x1_, x2_;
};

/// The largest absolute value of all numbers.
std::int64_t largest(const std::vector<Numbers>& frames) {
  std::int64_t most = 0;
  for (const Numbers& frame : frames)
    for (const std::int32_t x : frame) most = std::max(most, std::abs(std::int64_t{x}));
  return most;
}

/// Stores numbers in 16 bits if all fit, else in 32. A vertex of meshoptimizer takes a multiple of four bytes.
template <class Codec, bool kResiduals>
std::unique_ptr<StoredFrames> quantised(const std::vector<Numbers>& frames, double step) {
  constexpr bool kPadded = std::is_same_v<Codec, ByMeshopt>;
  if (4 * largest(frames) < 32768)  // a residual is at most four times a number
    return std::make_unique<Quantised<Codec, std::int16_t, kPadded ? 8 : 6, kResiduals>>(frames, step);
  return std::make_unique<Quantised<Codec, std::int32_t, 12, kResiduals>>(frames, step);
}

}  // namespace

std::vector<NamedFrames> stored_ways(const PointFrames& frames, double step) {
  std::vector<Numbers> numbers;
  for (const auto& frame : frames)
    for (auto& out = numbers.emplace_back(); const glm::vec3& p : frame)
      for (int axis = 0; axis < 3; ++axis)
        out.push_back(static_cast<std::int32_t>(std::lround(static_cast<double>(p[axis]) / step)));
  std::vector<NamedFrames> out;
  const auto add = [&](const char* name, const char* note, std::unique_ptr<StoredFrames> stored) {
    out.push_back({name, note, std::move(stored)});
  };
  add("floats", "a copy", std::make_unique<Floats>(frames));
  add("halves", "16-bit floats", std::make_unique<Halves>(frames));
  const char* whole = "whole frames of the numbers that the cache has";
  const char* residuals = "residuals of these numbers from the velocity of the frame before";
  add("zstd -19", whole, quantised<ByZstd, false>(numbers, step));
  add("meshopt", whole, quantised<ByMeshopt, false>(numbers, step));
  add("zstd -19, residuals", residuals, quantised<ByZstd, true>(numbers, step));
  add("meshopt, residuals", residuals, quantised<ByMeshopt, true>(numbers, step));
  return out;
}

}  // namespace sinew::cost
