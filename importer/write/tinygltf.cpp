// SPDX-License-Identifier: MIT
#define TINYGLTF_IMPLEMENTATION
#include "importer/write/tinygltf.h"
