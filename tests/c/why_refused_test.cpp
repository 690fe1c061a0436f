// SPDX-License-Identifier: MIT
// sinew_why_refused names field, index and rule, exactly where sinew_run refuses.
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "runtime/sinew.h"
#include "tests/c/c_frame.h"
#include "tests/scenes/random_scene.h"

namespace sinew::test {
namespace {

sinew_needs between_updates() {
  sinew_needs needs = sinew_default_needs();
  needs.flags |= SINEW_NEED_BETWEEN_UPDATES;
  return needs;
}
const sinew_needs kBetweenUpdates = between_updates();

class CWhyRefused : public CPlan {
 protected:
  explicit CWhyRefused(const sinew_needs* needs = &kBetweenUpdates) : CPlan(random_scene(4), needs) {
    input_.layers = layers_;
    input_.layer_count = 2;
  }

  /// The line; empty where there is none.
  std::string why(const sinew_frame_input* input) {
    sinew_messages* messages = nullptr;
    EXPECT_EQ(sinew_why_refused(frame_, input, &messages), SINEW_OK);
    EXPECT_EQ(sinew_message_count(messages), messages == nullptr ? 0u : 1u);
    const std::string line = sinew_message(messages, 0);
    sinew_messages_destroy(messages);
    EXPECT_EQ(line.empty(), sinew_run(frame_, input) == SINEW_OK) << line;
    return line;
  }
  std::string why() { return why(&input_); }

  sinew_layer layers_[5] = {{0.4, 0, SINEW_NONE, 0.5f, 0}, {0.6, 1, SINEW_NONE, 0.5f, 0}};
  sinew_frame_input input_ = sinew_default_input();
};

TEST_F(CWhyRefused, an_input_that_runs_has_no_reason) {
  EXPECT_EQ(why(nullptr), "");
  EXPECT_EQ(why(), "");
  sinew_messages other;
  sinew_messages* messages = &other;
  EXPECT_EQ(sinew_why_refused(frame_, &input_, &messages), SINEW_OK);
  EXPECT_EQ(messages, nullptr);
}

TEST_F(CWhyRefused, reasons_of_the_runtime_are_those_of_cpp) {
  layers_[1].weight = -1.0f;
  EXPECT_EQ(why(), "layers[1].weight: a weight is below 0, and only additive layers subtract");
  layers_[1].weight = 0.5f;
  layers_[1].clip = 99;
  EXPECT_EQ(why(), "layers[1].clip: the plan was compiled for fewer clips");
  layers_[1] = layers_[0];
  layers_[1].kind = SINEW_LAYER_MIRRORED;
  EXPECT_EQ(why(), "layers[1].mirrored: the needs have no mirror");
  layers_[1].kind = SINEW_LAYER_BLEND;
  input_.root.row[1][3] = std::numeric_limits<float>::infinity();
  EXPECT_EQ(why(), "root: a number is NaN or infinite");
}

TEST_F(CWhyRefused, layers_that_cannot_be_read) {
  layers_[1].kind = SINEW_LAYER_ADD_TO_START + 1;
  EXPECT_EQ(why(), "layers[1].kind: there is no such kind of layer");
  input_.layer_count = 5;
  EXPECT_EQ(why(), "layers: there are more layers than the plan's needs have room for");
  input_.layer_count = 1;
  input_.next_layer_count = 2;
  EXPECT_EQ(why(), "") << "not looked at while the factor is 0";
  input_.interpolation_factor = 0.5f;
  EXPECT_EQ(why(), "next_layers: a pointer that must not be null is");
  input_.next_layers = layers_;
  EXPECT_EQ(why(), "next_layers[1].kind: there is no such kind of layer");
  input_.layers = nullptr;
  EXPECT_EQ(why(), "layers: a pointer that must not be null is");
}

TEST_F(CWhyRefused, arrays_of_another_length) {
  const std::vector<float> weights(scene_.scene.weight_count() + 1);
  const std::string of_weights = "weights: not one for each morph weight of the scene";
  input_.weights = {weights.data(), weights.size()};
  EXPECT_EQ(why(), of_weights) << "too many";
  input_.weights.count -= 2;
  EXPECT_EQ(why(), of_weights) << "too few";
  input_.weights.data = nullptr;
  EXPECT_EQ(why(), "weights: a pointer that must not be null is");
  input_.weights = {nullptr, 0};
  input_.geometry_count = 1;
  EXPECT_EQ(why(), "geometry: a pointer that must not be null is");
  const sinew_geometry_input plays{};
  input_.geometry = &plays;
  EXPECT_EQ(why(), "geometry: not one for each of the needs' cached instances");
}

TEST_F(CWhyRefused, structs_of_no_version) {
  input_.struct_size = 3;
  EXPECT_EQ(why(), std::string("struct_size: ") + sinew_describe(SINEW_WRONG_STRUCT_SIZE));
}

TEST_F(CWhyRefused, asking_is_no_run) {
  ASSERT_EQ(sinew_run(frame_, &input_), SINEW_OK);
  sinew_frame_input other = input_;
  layers_[2] = {0.1, 0, SINEW_NONE, 1.0f, 0};
  other.layers = &layers_[2];
  other.layer_count = 1;
  sinew_messages* messages = nullptr;
  ASSERT_EQ(sinew_why_refused(frame_, &other, &messages), SINEW_OK);
  sinew_result_info before{.struct_size = sizeof(before)}, after = before;
  ASSERT_EQ(sinew_get_result(sinew_frame_result(frame_), &before), SINEW_OK);
  ASSERT_EQ(sinew_run(frame_, &input_), SINEW_OK);
  ASSERT_EQ(sinew_get_result(sinew_frame_result(frame_), &after), SINEW_OK);
  EXPECT_EQ(before.frame, 1u);
  EXPECT_EQ(after.since_frame, 1u);
}

class CWhyRefusedByDefaultNeeds : public CWhyRefused {
 protected:
  CWhyRefusedByDefaultNeeds() : CWhyRefused(nullptr) {}
};

TEST_F(CWhyRefusedByDefaultNeeds, frames_between_updates) {
  input_.interpolation_factor = 0.5f;
  EXPECT_EQ(why(), "interpolation_factor: the needs declare no frames between updates");
}

}  // namespace
}  // namespace sinew::test
