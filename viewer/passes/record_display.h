// SPDX-License-Identifier: MIT
#pragma once
#include "viewer/passes/record_passes.h"

namespace sinew::viewer {

// The passes that turn the drawn scene into the displayed picture, in the order in which they run.

void record_exposure(const PassContext& context);
void record_backdrop(const PassContext& context);
void record_tonemap(const PassContext& context);
void record_show(const PassContext& context);
void record_overlay(const PassContext& context);

/// Fills the target with the plain background. For pictures without a backdrop.
void clear_target(const PassContext& context);

/// Covers the current area with one triangle.
void draw_screen(const PassContext& context, VkPipeline pipeline, VkDescriptorSet set);

}  // namespace sinew::viewer
