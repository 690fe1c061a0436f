// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/model/scene.h"

namespace sinew::viewer {

/// The clip that `text` names: "none" is the rest pose (kNone), digits are an index, everything else is a name. If no
/// index fits, digits are tried as a name. "Walk#2" is the second clip called "Walk". A clip named "none" is found by
/// its index or as "none#1".
/// err  empty if the scene has no such clip
std::optional<std::uint32_t> choose_clip(const Scene& scene, std::string_view text);

/// The camera of the scene that `text` names, by index or name.
/// err  empty if there is no such camera, or no node uses it
std::optional<std::uint32_t> choose_camera(const Scene& scene, std::string_view text);

/// The material variant that `text` names, by index or name.
std::optional<std::uint32_t> choose_variant(const Scene& scene, std::string_view text);

/// The joint that `text` names, by index or name.
std::optional<std::uint32_t> choose_joint(const Scene& scene, std::string_view text);

/// The names of the clips as in the file; some may be empty.
std::vector<std::string> clip_names(const Scene& scene);

/// After a reload, finds the clip, camera, joint or variant of `now` that has the name of entry `index` of the earlier
/// scene. The second entry of a name corresponds to the second again. Cameras that no node uses are skipped.
/// in   index  kNone = none was chosen, returns kNone;   clips_before  clip_names() of the earlier scene
/// err  empty if there is no such entry any more
std::optional<std::uint32_t> same_clip(const std::vector<std::string>& clips_before, std::uint32_t index,
                                       const Scene& now);
std::optional<std::uint32_t> same_camera(const Scene& before, std::uint32_t index, const Scene& now);
std::optional<std::uint32_t> same_joint(const Scene& before, std::uint32_t index, const Scene& now);
std::optional<std::uint32_t> same_variant(const Scene& before, std::uint32_t index, const Scene& now);

/// "--clip Fly: no such clip; the scene has 0 \"Survey\", 1 \"Walk\""; only cameras on nodes are listed.
std::string describe_missing_clip(const Scene& scene, std::string_view text);
std::string describe_missing_camera(const Scene& scene, std::string_view text);
std::string describe_missing_joint(const Scene& scene, std::string_view text);
std::string describe_missing_variant(const Scene& scene, std::string_view text);

/// Names for menus; never empty.
std::string clip_label(const Scene& scene, std::uint32_t clip);
std::string camera_label(const Scene& scene, std::uint32_t camera);
std::string variant_label(const Scene& scene, std::uint32_t variant);

}  // namespace sinew::viewer
