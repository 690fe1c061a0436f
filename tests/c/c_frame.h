// SPDX-License-Identifier: MIT
#pragma once
#include <gtest/gtest.h>

#include <utility>

#include "runtime/c/handles.h"
#include "runtime/sinew.h"

namespace sinew::test {

/// Fixture with a scene, its plan and a frame that has not run yet, through the C interface.
class CPlan : public testing::Test {
 protected:
  explicit CPlan(Scene scene, const sinew_needs* needs = nullptr) : scene_{std::move(scene)} {
    EXPECT_EQ(sinew_plan_create(&scene_, needs, &plan_), SINEW_OK);
    EXPECT_EQ(sinew_frame_create(plan_, nullptr, &frame_), SINEW_OK);
  }
  ~CPlan() override {
    sinew_frame_destroy(frame_);
    sinew_plan_destroy(plan_);
  }

  sinew_scene scene_;
  sinew_plan* plan_ = nullptr;
  sinew_frame* frame_ = nullptr;
};

/// Same, with the first frame already run.
class CFrame : public CPlan {
 protected:
  explicit CFrame(Scene scene, const sinew_needs* needs = nullptr) : CPlan(std::move(scene), needs) {
    EXPECT_EQ(sinew_run(frame_, nullptr), SINEW_OK);
    result_ = sinew_frame_result(frame_);
  }

  const sinew_result* result_ = nullptr;
};

}  // namespace sinew::test
