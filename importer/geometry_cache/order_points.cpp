// SPDX-License-Identifier: MIT
#include "importer/geometry_cache/order_points.h"

#include <algorithm>
#include <array>
#include <deque>

#include "importer/topology/adjacency.h"
#include "runtime/geometry_cache/block_motion.h"

namespace sinew {
namespace {

/// Number of frames used to find points that are close and move alike.
constexpr std::size_t kFramesLookedAt = 5;

class Splitter {
 public:
  Splitter(std::span<const std::vector<glm::vec3>> frames, std::vector<std::uint32_t>& points) : points_(points) {
    for (std::size_t k = 0; k < kFramesLookedAt && !frames.empty(); ++k)
      frames_.push_back(&frames[k * (frames.size() - 1) / (kFramesLookedAt - 1)]);
  }

  void split(std::size_t first, std::size_t last) {
    if (last - first <= kBlockPoints) return;
    const std::size_t blocks = (last - first + kBlockPoints - 1) / kBlockPoints;
    const std::size_t middle = first + blocks / 2 * kBlockPoints;
    const auto [frame, axis] = widest(first, last);
    const auto at = [&](std::size_t i) { return points_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(first), at(middle), at(last), [&, f = frame, a = axis](std::uint32_t p, std::uint32_t q) {
      const float x = (*f)[p][a], y = (*f)[q][a];
      return x < y || (x == y && p < q);
    });
    split(first, middle);
    split(middle, last);
  }

 private:
  struct Axis {
    const std::vector<glm::vec3>* frame;
    int axis;
  };

  Axis widest(std::size_t first, std::size_t last) const {
    Axis best{frames_[0], 0};
    double most = -1.0;
    for (const auto* frame : frames_)
      for (int axis = 0; axis < 3; ++axis) {
        double sum = 0.0, squares = 0.0;
        for (std::size_t i = first; i < last; ++i) {
          const double x = (*frame)[points_[i]][axis];
          sum += x;
          squares += x * x;
        }
        const double n = static_cast<double>(last - first), variance = squares / n - (sum / n) * (sum / n);
        if (variance > most) {
          most = variance;
          best = {frame, axis};
        }
      }
    return best;
  }

  std::vector<const std::vector<glm::vec3>*> frames_;
  std::vector<std::uint32_t>& points_;
};

/// Connectivity of the points: triangles around a point, and the point across an edge.
class Surface {
 public:
  Surface(std::span<const std::uint32_t> triangles, std::size_t point_count)
      : adjacency_(make_adjacency(triangles, point_count)), first_(point_count + 1, 0) {
    for (std::size_t c = 0; c < triangles.size(); ++c)
      if (adjacency_.corner_vertex[c] != kNone) ++first_[triangles[c] + 1];
    for (std::size_t p = 0; p < point_count; ++p) first_[p + 1] += first_[p];
    corners_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t c = 0; c < triangles.size(); ++c)
      if (adjacency_.corner_vertex[c] != kNone) corners_[next[triangles[c]]++] = static_cast<std::uint32_t>(c);
  }

  std::span<const std::uint32_t> corners_of(std::uint32_t point) const {
    return std::span(corners_).subspan(first_[point], first_[point + 1] - first_[point]);
  }
  std::uint32_t point(std::size_t corner) const { return adjacency_.source[adjacency_.corner_vertex[corner]]; }

  /// The point across the edge that starts at a corner; kNone at a border.
  std::uint32_t across(std::size_t corner) const {
    const std::uint32_t face = adjacency_.neighbour[corner];
    if (face == kNone) return kNone;
    const std::uint32_t a = point(corner), b = point(next_corner(corner));
    std::size_t c = 3 * std::size_t{face};  // terminates: a face has three different points
    while (point(c) == a || point(c) == b) ++c;
    return point(c);
  }

 private:
  Adjacency adjacency_;
  std::vector<std::uint32_t> first_, corners_;
};

/// Orders the points within one block by walking over the surface.
class BlockWalk {
 public:
  BlockWalk(const Surface& surface, std::vector<std::uint8_t>& place, std::span<std::uint32_t> block)
      : surface_(surface), place_(place), block_(block.begin(), block.end()), out_(block) {
    for (const std::uint32_t p : block) place_[p] = kWaiting;
  }
  ~BlockWalk() {
    for (const std::uint32_t p : block_) place_[p] = kElsewhere;
  }
  BlockWalk(const BlockWalk&) = delete;
  BlockWalk& operator=(const BlockWalk&) = delete;

  /// Markers in `place`: point of another block; point of this block not visited yet.
  static constexpr std::uint8_t kElsewhere = 255, kWaiting = 254;

  void walk(std::span<std::uint8_t> corners) {
    std::fill(corners.begin(), corners.end(), kNoCorner);
    std::size_t first_waiting = 0;
    while (count_ < block_.size()) {
      Step step;
      if (!take(parallelograms_, step) && !take(neighbours_, step)) {
        while (place_[block_[first_waiting]] != kWaiting) ++first_waiting;
        step = {block_[first_waiting], {last_place(), kNoCorner, kNoCorner}};
      }
      std::copy(step.from.begin(), step.from.end(), corners.begin() + static_cast<std::ptrdiff_t>(3 * count_));
      visit(step.point);
    }
  }

 private:
  struct Step {
    std::uint32_t point = 0;
    std::array<std::uint8_t, 3> from{};
  };

  std::uint8_t last_place() const { return count_ == 0 ? kNoCorner : static_cast<std::uint8_t>(count_ - 1); }
  bool is_done(std::uint32_t point) const { return place_[point] < kBlockPoints; }

  bool take(std::deque<Step>& steps, Step& out) {
    while (!steps.empty()) {
      out = steps.front();
      steps.pop_front();
      if (place_[out.point] == kWaiting) return true;
    }
    return false;
  }

  void visit(std::uint32_t point) {
    place_[point] = static_cast<std::uint8_t>(count_);
    out_[count_++] = point;
    for (const std::uint32_t corner : surface_.corners_of(point)) {
      const std::size_t c[3] = {corner, next_corner(corner), next_corner(next_corner(corner))};
      const std::uint32_t p[3] = {point, surface_.point(c[1]), surface_.point(c[2])};
      for (int k = 1; k < 3; ++k)
        if (place_[p[k]] == kWaiting) neighbours_.push_back({p[k], {place_[point], kNoCorner, kNoCorner}});
      if (!is_done(p[1]) || !is_done(p[2])) continue;
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t across = surface_.across(c[k]);
        if (across != kNone && place_[across] == kWaiting)
          parallelograms_.push_back({across, {place_[p[k]], place_[p[(k + 1) % 3]], place_[p[(k + 2) % 3]]}});
      }
    }
  }

  const Surface& surface_;
  std::vector<std::uint8_t>& place_;
  std::vector<std::uint32_t> block_;
  std::span<std::uint32_t> out_;
  std::deque<Step> parallelograms_, neighbours_;
  std::size_t count_ = 0;
};

}  // namespace

PointOrder order_points(std::span<const std::vector<glm::vec3>> frames, std::span<const std::uint32_t> triangles) {
  PointOrder out;
  const std::size_t count = frames.empty() ? 0 : frames[0].size();
  for (std::uint32_t p = 0; p < count; ++p) out.points.push_back(p);
  if (count == 0) return out;
  Splitter(frames, out.points).split(0, count);
  const Surface surface(triangles, count);
  const std::size_t blocks = (count + kBlockPoints - 1) / kBlockPoints;
  out.corners.assign(blocks * kBlockNumbers, kNoCorner);
  std::vector<std::uint8_t> place(count, BlockWalk::kElsewhere);
  for (std::size_t b = 0; b < blocks; ++b) {
    const std::size_t first = b * kBlockPoints, size = std::min(kBlockPoints, count - first);
    BlockWalk(surface, place, std::span(out.points).subspan(first, size))
        .walk(std::span(out.corners).subspan(3 * first, 3 * size));
  }
  return out;
}

}  // namespace sinew
