// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "runtime/base/same_bits.h"
#include "runtime/clip/clip_layout.h"
#include "runtime/clip/unpack_clip.h"
#include "runtime/pose/blend_poses.h"
#include "runtime/pose/local_to_model.h"
#include "runtime/pose/sample_clip.h"
#include "runtime/threads/default_executor.h"
#include "tests/bench/clip_characters.h"
#include "tests/bench/glm_pose.h"
#include "tests/bench/instance_lanes.h"
#include "tests/bench/measure.h"
#include "tests/bench/pose_truth.h"
#include "tests/support/tiny_assets.h"

namespace sinew::bench {
namespace {

using Shared = std::shared_ptr<const Character>;

/// Memory of one pose and its matrices, for both implementations.
struct Room {
  Shared of;
  test::PoseBuffer pose;
  std::vector<glm_pose::Joint> glm_joints;
  std::vector<Affine> model;
  std::vector<glm::mat4> glm_model;

  explicit Room(const Shared& c)
      : of(c),
        pose(c->joint_count()),
        glm_joints(c->joint_count()),
        model(c->joint_count()),
        glm_model(c->joint_count()) {}

  void sample(double time_s) { sample(of->clip, time_s); }
  void sample(const Clip& clip, double time_s) {
    run_unchecked(SampleClipJob{.clip = &clip, .time_s = time_s, .pose = pose.span(), .weights = {}});
  }
  void sample_glm(double time_s) {
    glm_pose::sample(of->animation, of->skeleton.rest, static_cast<float>(time_s), glm_joints);
  }
  Transform joint(std::size_t j) { return pose.span().get(j); }
  Transform glm_joint(std::size_t j) const {
    return {glm_joints[j].translation, glm_joints[j].rotation, glm_joints[j].scale};
  }
};

/// Times of steady play at 60 Hz, or of jumps to anywhere in the clip.
struct Times {
  bool forward;
  double duration_s, now_s = 0.0;

  double next() noexcept {
    now_s += forward ? 1.0 / 60.0 : 0.61803398874989485 * duration_s;
    if (now_s >= duration_s) now_s = std::fmod(now_s, duration_s);
    return now_s;
  }
};

/// `layer_count` layers of equal weight.
struct Layers {
  std::vector<test::PoseBuffer> poses;
  std::vector<BlendLayer> layers;
  std::vector<std::vector<glm_pose::Joint>> glm_layers;
  std::vector<float> weights;
  test::PoseBuffer rest, out;
  std::vector<glm_pose::Joint> glm_out;

  Layers(const Shared& c, std::size_t layer_count)
      : rest(c->joint_count()), out(c->joint_count()), glm_out(c->joint_count()) {
    weights.assign(layer_count, 1.0f / static_cast<float>(layer_count));
    Room room(c);
    for (std::size_t l = 0; l < layer_count; ++l) {
      const double time_s = std::fmod(0.3 + 0.37 * static_cast<double>(l), c->animation.duration_s);
      room.sample(time_s);
      room.sample_glm(time_s);
      poses.push_back(room.pose);
      glm_layers.push_back(room.glm_joints);
    }
    for (std::size_t l = 0; l < layer_count; ++l) layers.push_back({poses[l].span(), weights[l], {}});
  }
  void blend() { run_unchecked(BlendPosesJob{layers, rest.span(), out.span()}); }
};

constexpr std::size_t kCrowd = 1024;

/// Many characters that play one clip, each at its own time. Their poses together are larger than the nearest
/// caches.
struct Crowd {
  std::vector<std::unique_ptr<Room>> rooms;
  double time_s = 0.0;

  explicit Crowd(const Shared& c) {
    for (std::size_t i = 0; i < kCrowd; ++i) rooms.push_back(std::make_unique<Room>(c));
  }
  template <class Step>
  void each(const Step& step) {
    time_s += 1.0 / 60.0;
    const double duration_s = rooms[0]->of->animation.duration_s;
    for (std::size_t i = 0; i < kCrowd; ++i)
      step(*rooms[i], std::fmod(time_s + 0.618 * static_cast<double>(i), duration_s));
  }
};

/// Many characters that play many clips, each at its own time. The clips together are larger than the caches: each one
/// has tracks of its own.
struct ClipCrowd {
  static constexpr std::size_t kClips = 128;
  Crowd crowd;
  std::vector<Clip> clips;

  ClipCrowd(const Shared& c, const Clip& clip) : crowd(c) {
    for (std::size_t i = 0; i < kClips; ++i) clips.push_back(clip_of(ClipLayout(clip.layout())));
  }
  void sample() {
    std::size_t next = 0;
    crowd.each([&](Room& room, double t) { room.sample(clips[next++ % kClips], t); });
  }
};

/// One character of a crowd, per frame: two sampled poses, their blend, model matrices.
struct Walker {
  Room from, to, mean;
  std::vector<std::vector<glm_pose::Joint>> glm_layers;

  explicit Walker(const Shared& c) : from(c), to(c), mean(c), glm_layers(2, from.glm_joints) {}

  void step(double time_s, double later_s) {
    from.sample(time_s);
    to.sample(later_s);
    const BlendLayer layers[] = {{from.pose.span(), 0.7f, {}}, {to.pose.span(), 0.3f, {}}};
    run_unchecked(BlendPosesJob{layers, from.pose.span(), mean.pose.span()});
    run_unchecked(LocalToModelJob{&mean.of->skeleton, mean.pose.span(), {}, mean.model});
  }
  void step_glm(double time_s, double later_s) {
    const float weights[] = {0.7f, 0.3f};
    glm_pose::sample(from.of->animation, from.of->skeleton.rest, static_cast<float>(time_s), glm_layers[0]);
    glm_pose::sample(from.of->animation, from.of->skeleton.rest, static_cast<float>(later_s), glm_layers[1]);
    glm_pose::blend(glm_layers, weights, mean.glm_joints);
    glm_pose::local_to_model(mean.of->skeleton, mean.glm_joints, mean.glm_model);
  }
};

/// Walkers that play one clip, each at its own time, split into one range per thread.
struct Walkers {
  std::vector<std::unique_ptr<Walker>> all;
  double time_s = 0.0, duration_s;

  Walkers(const Shared& c, std::size_t count) : duration_s(c->animation.duration_s) {
    for (std::size_t i = 0; i < count; ++i) all.push_back(std::make_unique<Walker>(c));
  }
  template <class Step>
  void each(std::size_t threads, const Step& step) {
    time_s += 1.0 / 60.0;
    const auto range = [&](std::size_t t) {
      for (std::size_t i = all.size() * t / threads; i < all.size() * (t + 1) / threads; ++i) {
        const double now_s = std::fmod(time_s + 0.618 * static_cast<double>(i), duration_s);
        step(*all[i], now_s, std::fmod(now_s + 0.4, duration_s));
      }
    };
    if (threads == 1)
      range(0);
    else
      run_in_parallel(threads, range);
  }
};

/// Poses of many instances of one skeleton, one after the other in memory, and their matrices.
struct Instances {
  static constexpr std::size_t kCount = 64;
  Shared of;
  test::PoseBuffer poses;
  std::vector<Affine> model, expected;
  std::vector<std::unique_ptr<Room>> rooms;
  InstanceLanes lanes;

  explicit Instances(const Shared& c)
      : of(c),
        poses(kCount * PoseSpan::stride_for(c->joint_count())),
        model(kCount * c->joint_count()),
        lanes(c->skeleton, kCount) {
    for (std::size_t i = 0; i < kCount; ++i) {
      rooms.push_back(std::make_unique<Room>(c));
      const double time_s = std::fmod(0.11 * static_cast<double>(i), c->animation.duration_s);
      run_unchecked(SampleClipJob{.clip = &c->clip, .time_s = time_s, .pose = pose(i), .weights = {}});
      rooms[i]->sample_glm(time_s);
    }
    one_by_one();
    expected = model;
    in_lanes();
    if (!same_bits<Affine>(model, expected)) std::abort();
  }
  std::size_t pitch() const { return PoseSpan::floats_for(of->joint_count()); }
  PoseSpan pose(std::size_t i) {
    return {poses.span().planes + i * pitch(), of->joint_count(), PoseSpan::stride_for(of->joint_count())};
  }
  void one_by_one() {
    const std::size_t joints = of->joint_count();
    for (std::size_t i = 0; i < kCount; ++i)
      run_unchecked(LocalToModelJob{.skeleton = &of->skeleton,
                                    .local = pose(i),
                                    .root = {},
                                    .model = std::span(model).subspan(i * joints, joints)});
  }
  void in_lanes() { lanes.local_to_model(poses.span().planes, pitch(), model.data()); }
  void glm() {
    for (const auto& room : rooms) glm_pose::local_to_model(of->skeleton, room->glm_joints, room->glm_model);
  }
};

}  // namespace

void add_sample() {
  for (const Shared& c : characters()) {
    const auto room = std::make_shared<Room>(c);
    const auto sampled = [&](double t) {
      room->sample(t);
      return [r = room.get()](std::size_t j) { return r->joint(j); };
    };
    const auto glm_sampled = [&](double t) {
      room->sample_glm(t);
      return [r = room.get()](std::size_t j) { return r->glm_joint(j); };
    };
    const Facts ours{sampling_error_rad(*c, sampled), 0}, plain{sampling_error_rad(*c, glm_sampled), 0};
    for (const bool forward : {true, false}) {
      const std::string tail = c->name + (forward ? "/forward" : "/seek");
      Times times{forward, c->animation.duration_s};
      add(
          "sample/sinew/" + tail, c->joint_count(), [room, times]() mutable { room->sample(times.next()); }, ours);
      add(
          "sample/glm/" + tail, c->joint_count(), [room, times]() mutable { room->sample_glm(times.next()); }, plain);
      if (!c->packed) continue;
      const auto full = std::make_shared<Clip>(unpacked(*c->packed));
      const auto error = [&](const Clip& clip) {
        return Facts{sampling_error_rad(*c,
                                        [&](double t) {
                                          room->sample(clip, t);
                                          return [r = room.get()](std::size_t j) { return r->joint(j); };
                                        }),
                     0};
      };
      add(
          "sample/packed/" + tail, c->joint_count(),
          [room, times]() mutable { room->sample(*room->of->packed, times.next()); }, error(*c->packed));
      add(
          "sample/unpacked/" + tail, c->joint_count(),
          [room, full, times]() mutable { room->sample(*full, times.next()); }, error(*full));
    }
  }
}

void add_blend() {
  for (const Shared& c : characters())
    for (const std::size_t count : {std::size_t{2}, std::size_t{4}}) {
      const auto layers = std::make_shared<Layers>(c, count);
      layers->blend();
      glm_pose::blend(layers->glm_layers, layers->weights, layers->glm_out);
      const auto inputs = [&](std::size_t l, std::size_t j) { return layers->poses[l].span().get(j); };
      const Facts ours{
          blending_error_rad(*c, count, inputs, [&](std::size_t j) { return layers->out.span().get(j).rotation; }), 0};
      const Facts plain{
          blending_error_rad(*c, count, inputs, [&](std::size_t j) { return layers->glm_out[j].rotation; }), 0};
      const std::string tail = c->name + "/" + std::to_string(count);
      add(
          "blend/sinew/" + tail, c->joint_count(), [layers] { layers->blend(); }, ours);
      add(
          "blend/glm/" + tail, c->joint_count(),
          [layers] { glm_pose::blend(layers->glm_layers, layers->weights, layers->glm_out); }, plain);
    }
}

void add_local_to_model() {
  for (const Shared& c : characters()) {
    const auto room = std::make_shared<Room>(c);
    room->sample(0.4 * c->animation.duration_s);
    room->sample_glm(0.4 * c->animation.duration_s);
    const auto ours = [room] {
      run_unchecked(LocalToModelJob{&room->of->skeleton, room->pose.span(), {}, room->model});
    };
    const auto plain = [room] { glm_pose::local_to_model(room->of->skeleton, room->glm_joints, room->glm_model); };
    ours();
    plain();
    const double error = model_error(
        *c, [&](std::size_t j) { return room->joint(j); },
        [&](std::size_t j) { return translation_of(room->model[j]); });
    const double glm_error = model_error(
        *c, [&](std::size_t j) { return room->glm_joint(j); },
        [&](std::size_t j) { return glm::vec3(room->glm_model[j][3]); });
    add("local_to_model/sinew/" + c->name, c->joint_count(), ours, {error, 0});
    add("local_to_model/glm/" + c->name, c->joint_count(), plain, {glm_error, 0});
  }
}

void add_instances() {
  const auto instances = std::make_shared<Instances>(characters().front());
  const std::string tail = characters().front()->name + "/64instances";
  const std::size_t joints = Instances::kCount * characters().front()->joint_count();
  add("local_to_model/sinew/" + tail, joints, [instances] { instances->one_by_one(); });
  add("local_to_model/instance_lanes/" + tail, joints, [instances] { instances->in_lanes(); });
  add("local_to_model/glm/" + tail, joints, [instances] { instances->glm(); });
}

void add_crowd() {
  const auto crowd = std::make_shared<Crowd>(characters().front());
  const std::size_t joints = kCrowd * characters().front()->joint_count();
  add("sample/sinew/crowd1024/cold", joints, [crowd] { crowd->each([](Room& room, double t) { room.sample(t); }); });
  add("sample/glm/crowd1024/cold", joints, [crowd] { crowd->each([](Room& room, double t) { room.sample_glm(t); }); });
  const Shared& biped = characters().front();
  const auto of_floats = std::make_shared<ClipCrowd>(biped, biped->clip),
             of_bits = std::make_shared<ClipCrowd>(biped, *biped->packed);
  add("sample/sinew/crowd1024/128clips", joints, [of_floats] { of_floats->sample(); });
  add("sample/packed/crowd1024/128clips", joints, [of_bits] { of_bits->sample(); });
  add("sample/glm/crowd1024/128clips", joints,
      [crowd] { crowd->each([](Room& room, double t) { room.sample_glm(t); }); });
  const auto fewer_joints = [](const Shared& a, const Shared& b) { return a->joint_count() < b->joint_count(); };
  for (const Shared& c :
       {characters().front(), *std::min_element(characters().begin(), characters().end(), fewer_joints)})
    for (const std::size_t count : {std::size_t{64}, kCrowd}) {
      const auto walkers = std::make_shared<Walkers>(c, count);
      for (const std::size_t threads : thread_counts()) {
        const std::string tail = c->name + "/" + std::to_string(count) + "/" + std::to_string(threads) + "threads";
        const std::size_t all_joints = count * c->joint_count();
        Facts facts;
        facts.wall_time = true;  // work of the other threads counts
        add(
            "crowd/sinew/" + tail, all_joints,
            [walkers, threads] { walkers->each(threads, [](Walker& w, double a, double b) { w.step(a, b); }); }, facts);
        add(
            "crowd/glm/" + tail, all_joints,
            [walkers, threads] { walkers->each(threads, [](Walker& w, double a, double b) { w.step_glm(a, b); }); },
            facts);
      }
    }
}

}  // namespace sinew::bench
