// SPDX-License-Identifier: MIT
#define TINYGLTF_IMPLEMENTATION
#include "importer/file/tinygltf.h"
