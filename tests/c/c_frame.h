// SPDX-License-Identifier: MIT
#pragma once
#include <gtest/gtest.h>

#include <utility>

#include "runtime/c/handles.h"
#include "runtime/sinew.h"

namespace sinew::test {

/// A scene, its plan, and a first frame of it, through the C interface.
class CFrame : public testing::Test {
 protected:
  explicit CFrame(Scene scene, const sinew_needs* needs = nullptr) : scene_{std::move(scene)} {
    EXPECT_EQ(sinew_plan_create(&scene_, needs, &plan_), SINEW_OK);
    EXPECT_EQ(sinew_frame_create(plan_, nullptr, &frame_), SINEW_OK);
    EXPECT_EQ(sinew_run(frame_, nullptr), SINEW_OK);
    result_ = sinew_frame_result(frame_);
  }
  ~CFrame() override {
    sinew_frame_destroy(frame_);
    sinew_plan_destroy(plan_);
  }

  sinew_scene scene_;
  sinew_plan* plan_ = nullptr;
  sinew_frame* frame_ = nullptr;
  const sinew_result* result_ = nullptr;
};

}  // namespace sinew::test
