// SPDX-License-Identifier: MIT
// Vertices of a frame in the buffers of an engine.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include "tests/c/c_frame.h"
#include "tests/scenes/random_scene.h"

namespace sinew::test {
namespace {

class CWriteShape : public CFrame {
 protected:
  static constexpr std::size_t kStride = 44;
  static inline const sinew_needs kAllAttributes = [] {
    sinew_needs needs = sinew_default_needs();
    needs.flags = SINEW_NEED_POSITIONS | SINEW_NEED_NORMALS | SINEW_NEED_TANGENTS | SINEW_NEED_TANGENTS_OF_ALL;
    return needs;
  }();

  CWriteShape() : CFrame(random_scene(3), &kAllAttributes) {
    shape_.struct_size = sizeof(shape_);
    while (sinew_get_shape(result_, index_, &shape_) == SINEW_OK && shape_.tangents.count == 0) ++index_;
    EXPECT_GT(shape_.tangents.count, 0u);
    bytes_.resize(shape_.positions.count * kStride);
  }
  sinew_vertex_buffer buffer(std::uint32_t format) {
    return {.struct_size = sizeof(sinew_vertex_buffer),
            .format = format,
            .vertex_count = shape_.positions.count,
            .positions = bytes_.data(),
            .position_stride = kStride,
            .normals = bytes_.data() + 12,
            .normal_stride = kStride,
            .tangents = bytes_.data() + 24,
            .tangent_stride = kStride,
            .box = {{-100, -100, -100}, {100, 100, 100}}};
  }
  template <class T>
  T at(std::size_t vertex, std::size_t offset) const {
    T value;
    std::memcpy(&value, bytes_.data() + vertex * kStride + offset, sizeof value);
    return value;
  }

  std::uint32_t index_ = 0;
  sinew_shape shape_{};
  std::vector<unsigned char> bytes_;
};

TEST_F(CWriteShape, interleaves_floats) {
  const sinew_vertex_buffer to = buffer(SINEW_VERTEX_FLOAT);
  ASSERT_EQ(sinew_write_shape(result_, index_, &to), SINEW_OK);
  for (std::size_t v = 0; v < shape_.positions.count; ++v) {
    EXPECT_EQ(std::memcmp(&bytes_[v * kStride], &shape_.positions.data[v], 12), 0) << v;
    EXPECT_EQ(std::memcmp(&bytes_[v * kStride + 12], &shape_.normals.data[v], 12), 0) << v;
    EXPECT_EQ(std::memcmp(&bytes_[v * kStride + 24], &shape_.tangents.data[v], 16), 0) << v;
  }
}

TEST_F(CWriteShape, writes_16_bit_integers_of_the_box) {
  const sinew_vertex_buffer to = buffer(SINEW_VERTEX_16_BIT);
  ASSERT_EQ(sinew_write_shape(result_, index_, &to), SINEW_OK);
  for (std::size_t v = 0; v < shape_.positions.count; ++v) {
    const auto q = at<std::array<std::uint16_t, 3>>(v, 0);
    const sinew_vec3 p = shape_.positions.data[v];
    EXPECT_NEAR(q[0] * 200.0 / 65535 - 100, p.x, 2e-3) << v;
    EXPECT_NEAR(q[1] * 200.0 / 65535 - 100, p.y, 2e-3) << v;
    EXPECT_NEAR(q[2] * 200.0 / 65535 - 100, p.z, 2e-3) << v;
    const sinew_vec3 n = shape_.normals.data[v];
    const double sum = std::abs(n.x) + std::abs(n.y) + std::abs(n.z);
    const double lower_half = n.z < 0 ? 2.0 : 0.0;  // folded: nothing to compare but the range
    EXPECT_NEAR((at<std::array<std::int16_t, 2>>(v, 12)[0]) / 32767.0, n.x / sum, lower_half + 2e-5) << v;
    EXPECT_EQ((at<std::array<std::int16_t, 3>>(v, 24)[2]), shape_.tangents.data[v].w < 0 ? -32767 : 32767) << v;
  }
}

TEST_F(CWriteShape, refuses_what_does_not_fit) {
  sinew_vertex_buffer to = buffer(SINEW_VERTEX_FLOAT);
  to.struct_size = 8;
  EXPECT_EQ(sinew_write_shape(result_, index_, &to), SINEW_WRONG_STRUCT_SIZE);
  to = buffer(2);
  EXPECT_EQ(sinew_write_shape(result_, index_, &to), SINEW_UNSUPPORTED);
  to = buffer(SINEW_VERTEX_FLOAT);
  --to.vertex_count;
  EXPECT_EQ(sinew_write_shape(result_, index_, &to), SINEW_SIZE_MISMATCH);
  to = buffer(SINEW_VERTEX_FLOAT);
  to.tangent_stride = 15;
  EXPECT_EQ(sinew_write_shape(result_, index_, &to), SINEW_SIZE_MISMATCH);
  to = buffer(SINEW_VERTEX_16_BIT);
  to.box.upper.y = -101;
  EXPECT_EQ(sinew_write_shape(result_, index_, &to), SINEW_NOT_FINITE);
}

TEST_F(CWriteShape, refuses_attributes_that_the_shape_does_not_have) {
  sinew_needs needs = sinew_default_needs();
  needs.flags = SINEW_NEED_POSITIONS;
  sinew_plan* plan = nullptr;
  sinew_frame* frame = nullptr;
  ASSERT_EQ(sinew_plan_create(&scene_, &needs, &plan), SINEW_OK);
  ASSERT_EQ(sinew_frame_create(plan, nullptr, &frame), SINEW_OK);
  ASSERT_EQ(sinew_run(frame, nullptr), SINEW_OK);
  sinew_vertex_buffer to = buffer(SINEW_VERTEX_FLOAT);
  EXPECT_EQ(sinew_write_shape(sinew_frame_result(frame), index_, &to), SINEW_UNSUPPORTED);
  to.normals = nullptr;
  EXPECT_EQ(sinew_write_shape(sinew_frame_result(frame), index_, &to), SINEW_UNSUPPORTED);
  to.tangents = nullptr;
  EXPECT_EQ(sinew_write_shape(sinew_frame_result(frame), index_, &to), SINEW_OK);
  sinew_frame_destroy(frame);
  sinew_plan_destroy(plan);
}

}  // namespace
}  // namespace sinew::test
