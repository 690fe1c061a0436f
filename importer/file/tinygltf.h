// SPDX-License-Identifier: MIT
#pragma once
/// The one place that includes tiny_gltf.h: no image codec, no image writer and no file access of its own, JSON from
/// the system's nlohmann-json. Its namespace has a name of our own: Debian's libdraco carries a copy of another
/// version, and an engine may; classes of one name and two layouts end in the wrong destructor, whichever the linker
/// meets first.
#define tinygltf sinew_tinygltf
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_INCLUDE_JSON
#define TINYGLTF_NO_INCLUDE_STB_IMAGE
#define TINYGLTF_NO_INCLUDE_STB_IMAGE_WRITE
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wconversion"
#include <nlohmann/json.hpp>
// tiny_gltf.h expects it to be there already.
#include <tiny_gltf.h>
#pragma GCC diagnostic pop
