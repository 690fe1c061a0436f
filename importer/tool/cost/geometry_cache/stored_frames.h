// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace sinew::cost {

using PointFrames = std::vector<std::vector<glm::vec3>>;  ///< [frames][points]

/// Frames of points in one of the storage formats that geometry caches are compared with.
class StoredFrames {
 public:
  virtual ~StoredFrames() = default;
  virtual std::size_t bytes() const = 0;

  /// Writes the points of a frame. A format that stores differences to earlier frames is decoded in the order of
  /// frames.
  virtual void decode(std::size_t frame, std::span<glm::vec3> out) = 0;
};

struct NamedFrames {
  std::string name, note;
  std::unique_ptr<StoredFrames> frames;
};

/// Frames as floats, as halves, and as multiples of a step. The multiples are packed by zstd at level 19 and by
/// meshoptimizer: whole frames, or differences from a prediction by the velocity of the frame before.
/// in   frames  at least one;   step  metres
std::vector<NamedFrames> stored_ways(const PointFrames& frames, double step);

}  // namespace sinew::cost
