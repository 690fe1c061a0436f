// SPDX-License-Identifier: MIT
#include "samples/showcase/flag_cloth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

#include "runtime/base/contract.h"

namespace sinew::showcase {
namespace {

using Vec = glm::dvec3;

/// The sine of an angle within 1e-7, in operations that have the same bits on every machine.
double sine(double angle_rad) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  const double turns = angle_rad / kTurn, part = turns - std::floor(turns + 0.5);
  const double x = kTurn * (std::abs(part) > 0.25 ? std::copysign(0.5, part) - part : part), x2 = x * x;
  return x * (1.0 - x2 / 6.0 * (1.0 - x2 / 20.0 * (1.0 - x2 / 42.0 * (1.0 - x2 / 72.0 * (1.0 - x2 / 110.0)))));
}

struct Spring {
  std::uint32_t a, b;
  double length_m, stiffness;  // share of the stretch that one sweep removes
};

class Flag {
 public:
  explicit Flag(const FlagOptions& options) : o_(options), x_(o_.columns * o_.rows), v_(x_.size()), before_(x_.size()) {
    for (std::uint32_t r = 0; r < o_.rows; ++r)
      for (std::uint32_t c = 0; c < o_.columns; ++c) {  // a first wave, so that the wind has a surface to push
        const double s = c * o_.spacing_m;
        x_[at(c, r)] = Vec(s, -(r * o_.spacing_m), 0.02 * s * sine(9.0 * s));
      }
    // From the pole outwards, so that one sweep carries the pull to the far end
    for (std::uint32_t c = 0; c < o_.columns; ++c)
      for (std::uint32_t r = 0; r < o_.rows; ++r)
        for (const auto& [dc, dr, stiffness] : kNeighbours) connect(c, r, dc, dr, stiffness);
  }

  void step(double time_s) {
    const double h = 1.0 / (o_.fps * o_.substeps);
    before_ = x_;
    for (std::uint32_t r = 0; r < o_.rows; ++r)
      for (std::uint32_t c = 1; c < o_.columns; ++c) {
        v_[at(c, r)] += h * acceleration(c, r, time_s);
        x_[at(c, r)] += h * v_[at(c, r)];
      }
    for (const Spring& spring : springs_) relax(spring);
    hold_to_pole();
    for (std::size_t i = 0; i < x_.size(); ++i) v_[i] = (x_[i] - before_[i]) / h;
    for (const Spring& s : springs_) rub(s);
  }

  const std::vector<Vec>& positions() const { return x_; }

 private:
  struct Neighbour {
    int columns, rows;
    double stiffness;
  };
  static constexpr double kFriction = 0.1;  // per step
  static constexpr Neighbour kNeighbours[] = {{1, 0, 1.0},  {0, 1, 1.0}, {1, 1, 0.4},
                                              {1, -1, 0.4}, {2, 0, 0.2}, {0, 2, 0.2}};

  std::uint32_t at(std::uint32_t c, std::uint32_t r) const { return r * o_.columns + c; }

  void connect(std::uint32_t c, std::uint32_t r, int dc, int dr, double stiffness) {
    const std::uint32_t c2 = c + dc, r2 = r + dr;  // past an edge these wrap to large numbers
    if (c2 >= o_.columns || r2 >= o_.rows) return;
    springs_.push_back({at(c, r), at(c2, r2), o_.spacing_m * std::sqrt(dc * dc + dr * dr), stiffness});
  }

  Vec acceleration(std::uint32_t c, std::uint32_t r, double time_s) const {
    const FlagWind& w = o_.wind;
    const Vec wind(w.speed + sine(w.gust * time_s), 0.5 * sine(w.lift * time_s),
                   sine(w.swing * time_s) + sine(4.0 * before_[at(c, r)].x - w.wave * time_s));
    const std::uint32_t left = at(c - 1, r), right = at(std::min(c + 1, o_.columns - 1), r);
    const std::uint32_t up = at(c, r > 0 ? r - 1 : 0), down = at(c, std::min(r + 1, o_.rows - 1));
    const Vec normal =
        glm::normalize(glm::cross(before_[right] - before_[left], before_[down] - before_[up]) + Vec(0.0, 0.0, 1e-12));
    return Vec(0.0, -9.81, 0.0) + 4.0 * glm::dot(wind - v_[at(c, r)], normal) * normal - 0.2 * v_[at(c, r)];
  }

  /// Moves the ends of a spring towards its length; the pole does not move.
  void relax(const Spring& s) {
    const double a = s.a % o_.columns == 0 ? 0.0 : 1.0, b = s.b % o_.columns == 0 ? 0.0 : 1.0;
    if (a + b == 0.0) return;
    const Vec d = x_[s.b] - x_[s.a];
    const double length = glm::length(d);
    const Vec pull = s.stiffness * (length - s.length_m) / (length * (a + b)) * d;
    x_[s.a] += a * pull;
    x_[s.b] -= b * pull;
  }

  /// Inner friction: the velocities of the ends of a spring approach each other.
  void rub(const Spring& s) {
    const Vec change = 0.5 * kFriction * s.stiffness * (v_[s.b] - v_[s.a]);
    if (s.a % o_.columns != 0) v_[s.a] += change;
    v_[s.b] -= change;
  }

  /// Keeps each vertex no farther from the pole than its row is long (long range attachments: Kim et al. 2012). Springs
  /// alone would need as many sweeps as there are columns for that.
  void hold_to_pole() {
    for (std::uint32_t r = 0; r < o_.rows; ++r)
      for (std::uint32_t c = 1; c < o_.columns; ++c) {
        const Vec pole = x_[at(0, r)], d = x_[at(c, r)] - pole;
        const double length = glm::length(d), most = c * o_.spacing_m;
        if (length > most) x_[at(c, r)] = pole + most / length * d;
      }
  }

  FlagOptions o_;
  std::vector<Vec> x_, v_, before_;
  std::vector<Spring> springs_;
};

/// Weights of four points of a uniform cubic B-spline; t = position between the second and the third.
std::array<double, 4> spline_weights(double t) {
  const double u = 1.0 - t;
  return {u * u * u / 6.0, (3.0 * t * t * t - 6.0 * t * t + 4.0) / 6.0, (3.0 * u * u * u - 6.0 * u * u + 4.0) / 6.0,
          t * t * t / 6.0};
}

/// Smooths a row of points and divides each interval into `pieces`. Beyond its ends the row continues straight.
std::vector<Vec> refine(const std::vector<Vec>& points, std::uint32_t pieces) {
  const auto point = [&](std::ptrdiff_t i) {
    const auto last = static_cast<std::ptrdiff_t>(points.size()) - 1;
    if (i < 0) return 2.0 * points[0] - points[1];
    return i > last ? 2.0 * points[last] - points[last - 1] : points[i];
  };
  std::vector<Vec> out;
  for (std::ptrdiff_t i = 0; i + 1 < static_cast<std::ptrdiff_t>(points.size()); ++i)
    for (std::uint32_t k = 0; k < pieces; ++k) {
      const std::array<double, 4> w = spline_weights(static_cast<double>(k) / pieces);
      out.push_back(w[0] * point(i - 1) + w[1] * point(i) + w[2] * point(i + 1) + w[3] * point(i + 2));
    }
  out.push_back(points.back());
  return out;
}

std::vector<glm::vec3> refine_grid(const std::vector<Vec>& points, std::uint32_t columns, std::uint32_t pieces) {
  std::vector<std::vector<Vec>> rows;
  for (std::size_t first = 0; first < points.size(); first += columns)
    rows.push_back(refine({points.begin() + first, points.begin() + first + columns}, pieces));
  std::vector<glm::vec3> out((rows.size() * pieces - pieces + 1) * rows[0].size());
  for (std::size_t c = 0; c < rows[0].size(); ++c) {
    std::vector<Vec> column;
    for (const auto& row : rows) column.push_back(row[c]);
    column = refine(column, pieces);
    for (std::size_t r = 0; r < column.size(); ++r) out[r * rows[0].size() + c] = column[r];
  }
  return out;
}

}  // namespace

ClothFrames fly_flag(const FlagOptions& options) {
  ClothFrames out;
  out.columns = (options.columns - 1) * options.pieces + 1;
  out.rows = (options.rows - 1) * options.pieces + 1;
  for (std::uint32_t r = 0; r + 1 < out.rows; ++r)
    for (std::uint32_t c = 0; c + 1 < out.columns; ++c) {
      const std::uint32_t a = r * out.columns + c, b = a + out.columns;
      for (const std::uint32_t corner : {a, b, a + 1, a + 1, b, b + 1}) out.triangles.push_back(corner);
    }
  Flag flag(options);
  for (std::uint32_t f = 0; f < options.frame_count; ++f) {
    out.frames.push_back(refine_grid(flag.positions(), options.columns, options.pieces));
    for (std::uint32_t s = 0; s < options.substeps; ++s)
      flag.step((f + static_cast<double>(s) / options.substeps) / options.fps);
  }
  return out;
}

ClothFrames loop_of(ClothFrames flight, std::uint32_t loop_frames, std::uint32_t blend_frames) {
  CONTRACT(blend_frames > 0 && flight.frames.size() > loop_frames + blend_frames);
  auto& frames = flight.frames;
  const std::size_t last = frames.size() - 1, first = last - loop_frames;
  for (std::uint32_t b = 1; b <= blend_frames; ++b) {
    const std::size_t f = last - blend_frames + b;
    const float weight = glm::smoothstep(0.0f, 1.0f, static_cast<float>(b) / static_cast<float>(blend_frames));
    for (std::size_t v = 0; v < frames[f].size(); ++v)
      frames[f][v] += weight * (frames[f - loop_frames][v] - frames[f][v]);
  }
  frames.back() = frames[first];
  frames.erase(frames.begin(), frames.begin() + static_cast<std::ptrdiff_t>(first));
  return flight;
}

}  // namespace sinew::showcase
