// SPDX-License-Identifier: MIT
// A town of 200 characters of three kinds on a job thread. They appear, fade between states, change their level of
// detail with the distance, carry lanterns and disappear. The same town runs in three ways and must give the same bits.
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "runtime/base/bit_hash.h"
#include "runtime/math/axis_angle.h"
#include "runtime/plan/frame_hash.h"
#include "runtime/threads/job_thread.h"
#include "samples/showcase/scene_builder.h"
#include "samples/showcase/shapes.h"

namespace {

using namespace sinew;

constexpr std::size_t kCitizens = 200;
constexpr double kFrameSeconds = 1.0 / 30.0, kFadeSeconds = 0.25;
constexpr std::uint32_t kIdle = 0, kWalk = 1, kFall = 2;

/// A joint that swings about x by `angle_rad` to both sides, once in `duration_s`.
BoneAnimation swing(std::uint32_t joint, float angle_rad, float duration_s) {
  BoneAnimation bone;
  bone.joint = joint;
  bone.rotation.times_s = {0.0f, 0.25f * duration_s, 0.75f * duration_s, duration_s};
  for (const float angle : {0.0f, angle_rad, -angle_rad, 0.0f})
    bone.rotation.values.push_back(quat_from_axis_angle(glm::vec3(1, 0, 0), angle));
  return bone;
}

/// A figure of boxes: a body, a head, and limbs that swing. The last joint is a hand.
Scene make_figure(std::uint32_t limbs, float height_m) {
  showcase::SceneBuilder scene;
  const std::uint32_t mesh = scene.add_mesh({"box", {showcase::box({0, 0, 0}, glm::vec3(0.1f * height_m))}, {}, {}});
  const std::uint32_t body = scene.add_joint("body", kNone, {.translation = {0, 0.6f * height_m, 0}});
  const std::uint32_t head = scene.add_joint("head", body, {.translation = {0, 0.35f * height_m, 0}});
  for (std::uint32_t i = 0; i < limbs; ++i)
    scene.add_joint("limb" + std::to_string(i), body, {.translation = {0.2f * static_cast<float>(i) - 0.3f, 0, 0}});
  const std::uint32_t hand = scene.add_joint("hand", head + limbs, {.translation = {0, -0.3f * height_m, 0}});
  for (std::uint32_t joint = 0; joint <= hand; ++joint) scene.add_instance(joint, mesh);
  const auto clip = [&](const char* name, float duration_s, float angle_rad) {
    Animation animation{name, duration_s, {swing(head, 0.2f * angle_rad, duration_s)}, {}};
    for (std::uint32_t i = 1; i <= limbs; ++i)
      animation.bones.push_back(swing(head + i, i % 2 == 0 ? angle_rad : -angle_rad, duration_s));
    scene.add_animation(animation);
  };
  clip("idle", 1.3f, 0.1f);
  clip("walk", 0.9f, 0.7f);
  clip("fall", 1.1f, 1.5f);
  return scene.finish();
}

Scene make_lantern() {
  showcase::SceneBuilder scene;
  const std::uint32_t handle = scene.add_joint("handle", kNone, {});
  scene.add_instance(handle, scene.add_mesh({"box", {showcase::box({0, -0.1f, 0}, glm::vec3(0.05f))}, {}, {}}));
  return scene.finish();
}

/// Plans of one kind of citizen: one for near citizens, and one for far citizens without details that nobody sees
/// there.
struct Kind {
  explicit Kind(Scene made) : scene(std::make_shared<const Scene>(std::move(made))) {
    Needs of_far_ones;
    of_far_ones.out.normals = of_far_ones.out.tangents = false;
    far_plan = compile_plan(scene, of_far_ones, near_plan);
  }
  std::shared_ptr<const Scene> scene;
  Plan near_plan = compile_plan(scene, Needs{}), far_plan;
  std::uint32_t hand = *scene->skeleton.find("hand");
};

struct Citizen {
  JobThread::Character id = 0;
  std::optional<JobThread::Character> lantern;
  std::uint32_t kind = 0, from = kIdle, to = kIdle;
  bool is_far = false;
  double born_s = 0, dies_s = 0, fade_began_s = -1;
  glm::vec3 place{0};
  std::array<ClipLayer, 2> layers{};
};

class Town {
 public:
  explicit Town(JobThreadOptions options)
      : kinds_{Kind(make_figure(2, 1.7f)), Kind(make_figure(4, 1.2f)), Kind(make_figure(6, 0.6f))},
        lantern_(compile_plan(make_lantern(), Needs{})),
        jobs_(std::move(options)) {}

  /// Runs one frame. Returns false if a call was refused.
  bool step() {
    const double now_s = kFrameSeconds * static_cast<double>(frame_++);
    std::erase_if(citizens_, [&](const Citizen& one) { return now_s >= one.dies_s && leave(one); });
    while (citizens_.size() < kCitizens) citizens_.push_back(appear(now_s));
    inputs_.clear();
    for (std::size_t c = 0; c < citizens_.size(); ++c) {
      Citizen& one = citizens_[c];
      live(one, now_s);
      // Citizens far away get a new input in every second frame, and keep the old one in between.
      if (!one.is_far || (c + frame_) % 2 == 0 || one.born_s == now_s) show(one, now_s);
    }
    const Result<Ticket> ticket = jobs_.submit(inputs_);
    if (!ticket) return false;
    jobs_.wait(*ticket);
    for (const JobThread::Character id : jobs_.characters()) {
      const FrameResult* result = jobs_.latest(id);
      if (result == nullptr) return false;
      const std::uint64_t hashes[] = {hash_pose(*result), hash_vertices(*result)};
      hash_.add(std::span(hashes));
    }
    return jobs_.last_error() == ErrorCode::ok && lanterns_hang();
  }

  std::uint64_t hash() const { return hash_.value(); }
  std::size_t appeared() const { return appeared_; }
  std::size_t replaced() const { return replaced_; }

 private:
  std::uint32_t below(std::uint32_t count) { return static_cast<std::uint32_t>(random_() % count); }

  Citizen appear(double now_s) {
    Citizen one;
    one.kind = below(3);
    one.id = jobs_.add_character(kinds_[one.kind].near_plan);
    one.born_s = now_s;
    one.dies_s = now_s + 1.0 + 0.1 * below(60);
    one.place = {static_cast<float>(below(100)), 0, static_cast<float>(below(100))};
    if (below(3) == 0) {
      one.lantern = jobs_.add_character(lantern_);
      (void)jobs_.follow(*one.lantern, one.id, kinds_[one.kind].hand);
      inputs_of_new_lanterns_.push_back(*one.lantern);
    }
    ++appeared_;
    return one;
  }

  bool leave(const Citizen& one) {
    if (one.lantern) (void)jobs_.remove_character(*one.lantern);
    return jobs_.remove_character(one.id) == ErrorCode::ok;
  }

  /// Moves one citizen: it walks, and changes its state now and then. It gets another plan when the camera, which moves
  /// along x, comes near or goes away.
  void live(Citizen& one, double now_s) {
    if (one.to == kWalk) one.place.z += static_cast<float>(kFrameSeconds);
    const bool is_far = std::abs(one.place.x - 10.0 * now_s) > 40.0;
    if (is_far != one.is_far) {
      const Kind& kind = kinds_[one.kind];
      if (jobs_.replace_plan(one.id, is_far ? kind.far_plan : kind.near_plan) == ErrorCode::ok) ++replaced_;
      one.is_far = is_far;
    }
    if (now_s - one.fade_began_s < kFadeSeconds) return;
    const std::uint32_t state = now_s > one.dies_s - 0.8 ? kFall : below(30) == 0 ? below(2) : one.to;
    if (state == one.to) return;
    one.from = one.to;
    one.to = state;
    one.fade_began_s = now_s;
  }

  void show(Citizen& one, double now_s) {
    const auto faded = static_cast<float>(std::min(1.0, (now_s - one.fade_began_s) / kFadeSeconds));
    const auto time_of = [&](std::uint32_t clip) {
      return std::fmod(now_s - one.born_s, kinds_[one.kind].scene->animations[clip].duration_s);
    };
    one.layers = {ClipLayer{.clip = one.to, .time_s = time_of(one.to), .weight = faded},
                  ClipLayer{.clip = one.from, .time_s = time_of(one.from), .weight = 1.0f - faded}};
    FrameInput input{.layers = std::span(one.layers).first(faded < 1.0f ? 2 : 1)};
    input.root = affine_from_transform(Transform{.translation = one.place});
    inputs_.push_back({one.id, input});
    for (const JobThread::Character lantern : inputs_of_new_lanterns_) inputs_.push_back({lantern, FrameInput{}});
    inputs_of_new_lanterns_.clear();
  }

  /// True if each lantern is where the hand is in the same frame.
  bool lanterns_hang() {
    for (const Citizen& one : citizens_) {
      if (!one.lantern) continue;
      const Affine hand = jobs_.latest(one.id)->model[kinds_[one.kind].hand];
      if (jobs_.latest(*one.lantern)->model[0] != hand) return false;
    }
    return true;
  }

  std::array<Kind, 3> kinds_;
  Plan lantern_;
  JobThread jobs_;
  std::minstd_rand random_{1};
  std::vector<Citizen> citizens_;
  std::vector<JobThread::CharacterInput> inputs_;
  std::vector<JobThread::Character> inputs_of_new_lanterns_;
  std::uint64_t frame_ = 0;
  std::size_t appeared_ = 0, replaced_ = 0;
  BitHash hash_;
};

}  // namespace

int main(int argc, char** argv) {
  int frames = 90;
  if (argc > 1) {
    const char* const end = argv[1] + std::strlen(argv[1]);
    const auto [stop, error] = std::from_chars(argv[1], end, frames);
    if (argc > 2 || error != std::errc{} || stop != end || frames < 1 || frames > 100000) {
      std::fprintf(stderr, "usage: town [frames, above 0]\n");
      return 2;
    }
  }
  struct Way {
    const char* name;
    JobThreadOptions options;
  };
  const Way ways[] = {{"a worker and its executor", {.inline_below_bytes = 0, .part_bytes = 4096}},
                      {"a worker alone", {.inline_below_bytes = std::size_t{1} << 40}},
                      {"polled, two frame buffers", {.own_thread = false, .frame_buffers = 2}}};
  std::optional<std::uint64_t> hash;
  for (const Way& way : ways) {
    Town town(way.options);
    for (int frame = 0; frame < frames; ++frame)
      if (!town.step()) {
        std::fprintf(stderr, "town: frame %d was refused, or a lantern is not in its hand\n", frame);
        return 1;
      }
    std::printf("%-26s %d frames, %zu characters appeared, %zu changed their plan: %016llx\n", way.name, frames,
                town.appeared(), town.replaced(), static_cast<unsigned long long>(town.hash()));
    if (hash.value_or(town.hash()) != town.hash()) {
      std::fprintf(stderr, "town: the bits depend on how it is run\n");
      return 1;
    }
    hash = town.hash();
  }
  return 0;
}
