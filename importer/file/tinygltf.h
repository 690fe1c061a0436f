// SPDX-License-Identifier: MIT
#pragma once
/// The only place that includes tiny_gltf.h. It is configured without image codecs and file access, and with the
/// system's nlohmann-json. The namespace is renamed: Debian's libdraco contains another version of tinygltf, and so may
/// an engine. With equal names and different layouts, the linker would mix them.
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
// tiny_gltf.h expects nlohmann-json to be included before it.
#include <tiny_gltf.h>
#pragma GCC diagnostic pop
