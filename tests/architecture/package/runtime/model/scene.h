// SPDX-License-Identifier: MIT
#pragma once
// An engine's own header with the same name as one of sinew's.
namespace engine {
struct Scene {
  int characters = 2;
};
}  // namespace engine
