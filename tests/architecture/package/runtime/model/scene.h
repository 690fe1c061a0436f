// SPDX-License-Identifier: MIT
#pragma once
// An engine's own header, of the same name as one of ours.
namespace engine {
struct Scene {
  int characters = 2;
};
}  // namespace engine
