// SPDX-License-Identifier: MIT
// The arithmetic of viewer/shaders/quaternion_normal.glsl on the device: numeric cases of Hast's interpolation, and
// comparisons with double precision.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <optional>

#include <glm/geometric.hpp>

#include "tests/reference/quaternion_normal.h"
#include "tests/support/fixed_random.h"
#include "tests/support/numeric_corpus.h"
#include "tests/viewer/device_fixture.h"
#include "tests/viewer/shader_run.h"

namespace sinew::viewer {
namespace {

constexpr std::uint32_t kCode[] =
#include "quaternion_normal.comp.inc"
    ;

struct Given {
  glm::vec4 n0, n1, along0{1, 0, 0, 0}, along1{1, 0, 0, 0};
};

struct Answer {
  glm::vec4 h0, h1, n, q0;
  std::array<glm::vec4, 3> frame;
};

class quaternion_shader : public DeviceTest {
 protected:
  Answer answer_to(const Given& given) {
    if (!shader_) shader_.emplace(*test_device(), kCode, sizeof(Given), sizeof(Answer));
    return shader_->answer_to<Answer>(given);
  }

 private:
  std::optional<ShaderRun> shader_;
};

glm::vec4 vector_of(const test::Json& v, float w = 0.0f) {
  return {v[0].get<float>(), v[1].get<float>(), v[2].get<float>(), w};
}

std::vector<double> numbers(const glm::vec4& v) { return {v.x, v.y, v.z}; }

TEST_F(quaternion_shader, holds_the_numerical_cases) {
  const auto cases = test::numeric_cases("hast");
  ASSERT_FALSE(cases.empty());
  const test::NumericReport report = test::run_numeric(
      cases, {"on the device", [&](const test::Json& in) -> test::Outcome {
                const Answer got = answer_to({vector_of(in["n0"], in["t"].get<float>()), vector_of(in["n1"])});
                return {{"n", numbers(got.n)}, {"q0", numbers(got.h0)}, {"q1", numbers(got.h1)}};
              }});
  std::printf("  %d cases, worst %.3f of the tolerance (%s)\n", report.run, report.worst, report.worst_case.c_str());
  EXPECT_EQ(report.run, static_cast<int>(cases.size()));
  EXPECT_EQ(report.failed, 0) << report.failures;
}

TEST_F(quaternion_shader, normals_between_are_those_of_double_precision_and_of_unit_length) {
  test::FixedRandom random(3);
  for (int i = 0; i < 60; ++i) {
    const glm::vec3 a = random.direction(), b = random.direction();
    const float t = static_cast<float>(random.in(0.0, 1.0));
    const Answer got = answer_to({glm::vec4(a, t), glm::vec4(b, 0.0f)});
    const auto ha = reference::half_way_from_normal(glm::dvec3(a)), hb = reference::half_way_from_normal(glm::dvec3(b));
    EXPECT_LT(glm::length(glm::dvec3(got.h0) - ha), 1e-6);
    if (glm::length(ha * (1.0 - t) + hb * double{t}) < 0.1) continue;  // nearly opposite: rounding is enlarged
    EXPECT_LT(glm::length(glm::dvec3(got.n) - reference::normal_between(ha, hb, double{t})), 1e-5) << i;
    EXPECT_NEAR(glm::length(glm::dvec3(got.n)), 1.0, 2e-6);
  }
}

TEST_F(quaternion_shader, N35_at_and_near_the_pole_a_normal_has_a_half_way_vector_and_comes_back_from_it) {
  for (const float x : {0.0f, 1e-30f, 1e-20f, 1e-10f, 1e-4f, 0.01f})
    for (const glm::vec2& side : {glm::vec2(1.0f, 0.0f), glm::vec2(-0.6f, 0.8f)}) {
      const glm::vec4 n(x * side, -std::sqrt(1.0f - x * x), 0.5f);
      const Answer got = answer_to({n, n});
      EXPECT_NEAR(glm::length(glm::vec3(got.h0)), 1.0f, 1e-6f) << x;
      EXPECT_LT(glm::length(glm::vec3(got.n) - glm::vec3(n)), 1e-6f) << x;
      EXPECT_TRUE(x == 0.0f || glm::length(glm::vec3(got.h0) - glm::vec3(side, 0.0f)) < 0.6f * x + 1e-6f) << x;
    }
}

TEST_F(quaternion_shader, N35_frames_are_orthonormal_and_have_their_normal_and_tangent) {
  test::FixedRandom random(5);
  for (int i = 0; i < 80; ++i) {
    glm::vec3 n = random.direction();
    if (i % 8 == 0) n = {0.0f, 0.0f, -1.0f};
    if (i % 8 == 1) n = glm::normalize(glm::vec3(1e-4f, -2e-4f, -1.0f));
    const glm::vec3 along = 3.0f * random.direction();
    const Answer got =
        answer_to({glm::vec4(n, 0.5f), glm::vec4(n, 0.0f), glm::vec4(along, 0.0f), glm::vec4(along, 0.0f)});
    const glm::dvec3 normal(n),
        tangent = glm::normalize(glm::dvec3(along) - normal * glm::dot(normal, glm::dvec3(along)));
    const std::array<glm::dvec3, 3> expected = {tangent, glm::cross(normal, tangent), normal};
    for (std::size_t axis = 0; axis < 3; ++axis)
      EXPECT_LT(glm::length(glm::dvec3(got.frame[axis]) - expected[axis]), 2e-5) << i << ", axis " << axis;
    EXPECT_NEAR(glm::length(got.q0), 1.0f, 1e-5f);
  }
}

TEST_F(quaternion_shader, a_tangent_nearly_parallel_to_the_normal_gives_no_frame) {
  const glm::vec3 n = glm::normalize(glm::vec3(0.3f, -0.5f, 0.6f)),
                  aside = glm::normalize(glm::cross(n, glm::vec3(1, 0, 0)));
  for (const float length : {1e-6f, 1.0f, 1e6f}) {
    const auto q_of = [&](float sine) {
      const glm::vec4 along(length * (n + sine * aside), 0.0f);
      return answer_to({glm::vec4(n, 0.0f), glm::vec4(n, 0.0f), along, along}).q0;
    };
    for (const float sine : {0.0f, 1e-7f, 5e-4f}) EXPECT_EQ(q_of(sine), glm::vec4(0.0f)) << sine << ' ' << length;
    EXPECT_NEAR(glm::length(q_of(0.01f)), 1.0f, 1e-5f);
  }
}

}  // namespace
}  // namespace sinew::viewer
