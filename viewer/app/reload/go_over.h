// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <memory>
#include <string>

#include <tl/expected.hpp>

#include "viewer/app/exhibit.h"
#include "viewer/app/reload/background_read.h"
#include "viewer/app/shown_scene.h"

namespace sinew::viewer {

/// The read of a file that has changed, ready to be shown as `shown` is: with the centers of rotation and the ambient
/// access that it needs. It takes nothing of `shown` and `exhibit` along but copies.
/// in   options  must outlive the read
BackgroundRead::Read reading(const Options& options, const Exhibit& exhibit, ShownScene& shown);

/// Puts an exhibit on the device.
using MakeShown = std::function<std::unique_ptr<ShownScene>(const Exhibit& exhibit, const Evaluation& evaluation)>;

/// Shows `changed` in place of the exhibit, between two pictures. The clip stays by its name, with time, speed and
/// looping, and so does the kind of evaluation. The pose of that time is there for the next picture.
/// io   exhibit, shown  what is shown. Before the old scene is freed, the device has drawn all that was submitted.
/// err  a sentence of the device, which cannot hold it: then the old scene is shown again
/// cost waits for the device and for one pose; uploads the scene
tl::expected<void, std::string> go_over(const Device& device, Exhibit changed, Exhibit& exhibit,
                                        std::unique_ptr<ShownScene>& shown, const MakeShown& make);

}  // namespace sinew::viewer
