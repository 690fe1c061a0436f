// SPDX-License-Identifier: MIT
#include "importer/geometry_cache/point_cache.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <utility>

namespace sinew {
namespace {

constexpr char kPc2Magic[12] = "POINTCACHE2";
constexpr std::size_t kPc2Head = 32;

tl::unexpected<ImportError> refuse(const std::string& name, const char* rule, std::string detail) {
  return tl::unexpected(ImportError{name, {Severity::error, rule, "", std::move(detail)}, {}, {}});
}

std::uint32_t swapped(std::uint32_t x) { return x >> 24 | (x >> 8 & 0xff00u) | (x << 8 & 0xff0000u) | x << 24; }

/// Reads 32-bit words in either byte order.
class Words {
 public:
  Words(std::span<const std::byte> bytes, std::size_t at, bool big_endian) : bytes_(bytes), at_(at), big_(big_endian) {}

  std::uint32_t next() {
    std::uint32_t word = 0;
    std::memcpy(&word, bytes_.data() + at_, sizeof(word));
    at_ += sizeof(word);
    return big_ ? swapped(word) : word;
  }
  float number() { return std::bit_cast<float>(next()); }

 private:
  std::span<const std::byte> bytes_;
  std::size_t at_;
  bool big_;
};

/// Reads the frames; the caller has checked the size.
ImportResult<PointCache> read_frames(Words& in, std::size_t frames, std::size_t points, const std::string& name) {
  PointCache out;
  for (std::size_t f = 0; f < frames; ++f) {
    auto& frame = out.frames.emplace_back(points);
    for (std::size_t p = 0; p < points; ++p)
      for (int axis = 0; axis < 3; ++axis) {
        frame[p][axis] = in.number();
        if (!std::isfinite(frame[p][axis]))
          return refuse(name, "points-values",
                        "point " + std::to_string(p) + " of frame " + std::to_string(f) + " is not finite");
      }
  }
  return out;
}

std::string size_text(std::uint64_t frames, std::uint64_t points, std::uint64_t size) {
  return std::to_string(frames) + " frames of " + std::to_string(points) + " points do not take " +
         std::to_string(size) + " bytes";
}

/// True if the file size matches its counts. Overflow-safe: 12 times the product of two 32-bit counts may exceed 64
/// bits.
bool has_size(std::uint64_t size, std::uint64_t head, std::uint64_t frames, std::uint64_t points) {
  return frames > 0 && frames <= size && points <= size && head <= size && frames * points <= size &&
         head + 12 * frames * points == size;
}

/// Sets start and spacing; false if the times are not evenly spaced within float precision.
bool set_times(const std::vector<float>& times, double fps, PointCache& out) {
  if (!std::all_of(times.begin(), times.end(), [](float t) { return std::isfinite(t); })) return false;
  out.start_s = times[0];
  out.frame_s = 1.0 / fps;
  if (times.size() < 2) return true;
  out.frame_s = (double{times.back()} - times[0]) / static_cast<double>(times.size() - 1);
  if (!(out.frame_s > 0.0)) return false;
  for (std::size_t f = 0; f < times.size(); ++f)
    if (std::abs(times[f] - (out.start_s + static_cast<double>(f) * out.frame_s)) > 0.01 * out.frame_s) return false;
  return true;
}

ImportResult<PointCache> read_mdd(std::span<const std::byte> bytes, const std::string& name, double fps) {
  if (bytes.size() < 8) return refuse(name, "points-size", "the file ends inside of its head");
  Words in(bytes, 0, true);
  const std::uint64_t frames = in.next(), points = in.next();
  if (!has_size(bytes.size(), 8 + 4 * frames, frames, points))
    return refuse(name, "points-size", size_text(frames, points, bytes.size()));
  std::vector<float> times(frames);
  for (float& time : times) time = in.number();
  auto out = read_frames(in, frames, points, name);
  if (out && !set_times(times, fps, *out))
    return refuse(name, "points-times", "the times of frames are not finite, or not evenly spaced");
  return out;
}

ImportResult<PointCache> read_pc2(std::span<const std::byte> bytes, const std::string& name, double fps) {
  if (bytes.size() < kPc2Head) return refuse(name, "points-size", "the file ends inside of its head");
  Words in(bytes, sizeof(kPc2Magic), false);
  const std::uint32_t version = in.next(), points = in.next();
  const float start = in.number(), step = in.number();
  const std::uint32_t frames = in.next();
  if (version != 1 || !std::isfinite(start) || !std::isfinite(step) || step <= 0.0f)
    return refuse(name, "points-header", "not version 1, or the frames from one sample to the next are not above 0");
  if (!has_size(bytes.size(), kPc2Head, frames, points))
    return refuse(name, "points-size", size_text(frames, points, bytes.size()));
  auto out = read_frames(in, frames, points, name);
  if (out) {
    out->start_s = start / fps;
    out->frame_s = step / fps;
  }
  return out;
}

/// Largest distance between the first frame and the rest mesh.
double distance(const PointCache& points, std::span<const glm::vec3> rest, UpAxis up) {
  double most = 0.0;
  for (std::size_t p = 0; p < rest.size(); ++p) {
    const glm::dvec3 q = points.frames[0][p];
    most = std::max(most, glm::distance(up == UpAxis::y ? q : glm::dvec3(q.x, q.z, -q.y), glm::dvec3(rest[p])));
  }
  return most;
}

}  // namespace

ImportResult<PointCache> read_point_cache(std::span<const std::byte> bytes, const std::string& name, double fps) {
  if (bytes.size() >= sizeof(kPc2Magic) && std::memcmp(bytes.data(), kPc2Magic, sizeof(kPc2Magic)) == 0)
    return read_pc2(bytes, name, fps);
  return read_mdd(bytes, name, fps);
}

void turn_to_y_up(PointCache& points) {
  for (auto& frame : points.frames)
    for (glm::vec3& p : frame) p = glm::vec3(p.x, p.z, -p.y);
}

ImportResult<UpAxis> find_up_axis(const PointCache& points, std::span<const glm::vec3> rest, const std::string& name) {
  if (points.point_count() != rest.size())
    return refuse(name, "points-count",
                  std::to_string(points.point_count()) + " points, and the mesh has " + std::to_string(rest.size()) +
                      " vertices");
  glm::dvec3 low(rest.empty() ? glm::vec3(0.0f) : rest[0]), high = low;
  for (const glm::vec3& p : rest)
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], double{p[axis]});
      high[axis] = std::max(high[axis], double{p[axis]});
    }
  const double near = 1e-3 * glm::distance(low, high), y = distance(points, rest, UpAxis::y),
               z = distance(points, rest, UpAxis::z);
  if ((y <= near) != (z <= near)) return y <= near ? UpAxis::y : UpAxis::z;
  return refuse(name, "points-axes",
                std::string("the first frame is the mesh at rest with ") +
                    (y <= near ? "y up and with z up as well" : "neither y nor z up") + ": say which it is with --up");
}

}  // namespace sinew
