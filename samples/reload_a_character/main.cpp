// SPDX-License-Identifier: MIT
// Hot reload in an engine: a playing character switches to reloaded assets between two frames and keeps its state. The
// loop never waits. The old assets are drawn until the first frame of the new ones is ready; they are freed when no
// drawn frame refers to them.
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <future>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "runtime/base/same_bits.h"
#include "runtime/playback/playback_clock.h"
#include "runtime/threads/job_thread.h"
#include "samples/showcase/scene_builder.h"

namespace {

using namespace sinew;

constexpr double kFrame_s = 1.0 / 60.0;
constexpr double kSpeed_rad_s = 0.003;  ///< angular speed of the arm in the clip "turn"

/// The content of the file after `saves` saves. Each save inserts a clip before "turn" and appends a joint.
Scene read_file(int saves) {
  showcase::SceneBuilder file;
  const std::uint32_t arm = file.add_joint("arm", kNone, {});
  for (int i = 0; i <= saves; ++i) file.add_joint("finger", arm, {.translation = {static_cast<float>(i), 1.0f, 0.0f}});
  BoneAnimation turn;
  turn.joint = arm;
  turn.rotation.times_s = {0.0f, 1000.0f};
  turn.rotation.values = {quat_xyzw(0.0f, 0.0f, 0.0f, 1.0f),
                          quat_xyzw(0.0f, 0.0f, std::sin(500.0f * static_cast<float>(kSpeed_rad_s)),
                                    std::cos(500.0f * static_cast<float>(kSpeed_rad_s)))};
  BoneAnimation still = turn;
  still.rotation.values[1] = still.rotation.values[0];
  for (int i = 0; i < saves; ++i) file.add_animation({"still", 1000.0, {still}, {}});
  file.add_animation({"turn", 1000.0, {turn}, {}});
  return file.finish();
}

/// One loaded version of the assets, with the plan and job thread that play it.
class Version {
 public:
  Version(Scene read, const std::string& clip) : plan_(compile_plan(std::move(read), Needs{})) {
    clip_ = find_clip(plan_.scene(), clip).value_or(0);
    character_ = jobs_.add_character(plan_);
  }

  double duration_s() const { return plan_.scene().animations[clip_].duration_s; }

  /// Requests the frame of a time. Does nothing while the worker is busy: the loop requests again in its next frame.
  void ask(double time_s) {
    const ClipLayer layer{.clip = clip_, .time_s = time_s};
    const FrameInput input{.layers = {&layer, 1}};
    if (jobs_.submit({&input, 1})) asked_s_.push_back(time_s);
  }

  /// The newest finished frame; null before the first.
  const FrameResult* newest() { return jobs_.latest(character_); }
  double time_of(const FrameResult& frame) const { return asked_s_[frame.frame - 1]; }

  /// True if a frame is bit-identical to one evaluated on this thread.
  bool has_right_bits(const FrameResult& frame) const {
    FrameBuffer buffer(plan_);
    const ClipLayer layer{.clip = clip_, .time_s = time_of(frame)};
    return run_plan(plan_, {.layers = {&layer, 1}}, buffer) == ErrorCode::ok &&
           same_bits<Affine>(frame.model, buffer.result().model);
  }

 private:
  Plan plan_;
  JobThread jobs_;  // declared last, because it must end before the plan it runs
  JobThread::Character character_ = 0;
  std::uint32_t clip_ = 0;
  std::vector<double> asked_s_;  // [ticket - 1] clip time of each requested frame
};

/// A frame to draw. It keeps the version alive that it points into.
struct Frame {
  std::shared_ptr<const Version> version;
  const FrameResult* result = nullptr;
};

/// A character that keeps playing while its assets are replaced.
class Character {
 public:
  explicit Character(std::shared_ptr<Version> version) : clock_(version->duration_s()), shown_(std::move(version)) {}

  /// Sets the next version, which is shown as soon as it has a frame. Drops an earlier one that has no frame yet.
  void replace_with(std::shared_ptr<Version> version) { coming_ = std::move(version); }
  bool goes_over() const { return coming_ != nullptr; }

  /// Advances the clock and returns the frame to draw. Once the new version has a frame, the old version gets no more
  /// requests. The new version is shown when its frame is not older than the drawn one.
  Frame frame() {
    clock_.advance(kFrame_s);
    const FrameResult* const first = coming_ ? coming_->newest() : nullptr;
    if (first != nullptr && !is_older(*first)) {
      const double time_s = clock_.time_s();
      clock_ = PlaybackClock(coming_->duration_s());
      clock_.seek(time_s);
      shown_ = std::move(coming_);
    }
    if (coming_) coming_->ask(clock_.time_s());
    if (!coming_ || first == nullptr) shown_->ask(clock_.time_s());
    return {shown_, shown_->newest()};
  }

 private:
  bool is_older(const FrameResult& frame) const {
    const FrameResult* const drawn = shown_->newest();
    return drawn != nullptr && coming_->time_of(frame) < shown_->time_of(*drawn);
  }

  PlaybackClock clock_;
  std::shared_ptr<Version> shown_, coming_;
};

/// True if the arm has the angle that all versions have at that time.
bool is_turned(const FrameResult& frame, double time_s) {
  return std::abs(static_cast<double>(frame.model[0].row[1].x) - std::sin(kSpeed_rad_s * time_s)) < 1e-6;
}

/// Draws frames; counts all frames and wrong ones.
struct Screen {
  void draw(const Frame& frame) {
    shown = frame;  // releases the previous frame, and with a version's last frame also its assets
    if (frame.result == nullptr) {
      if (drawn > 0) ++wrong;  // the picture would be empty
      return;
    }
    ++drawn;
    const double time_s = frame.version->time_of(*frame.result);
    const bool right = is_turned(*frame.result, time_s) && frame.version->has_right_bits(*frame.result);
    if (time_s < last_s || !right) ++wrong;
    last_s = time_s;
  }

  Frame shown;
  double last_s = 0.0;
  int drawn = 0, wrong = 0;
};

/// One round of the loop of the engine.
void draw_next(Character& character, Screen& screen) {
  screen.draw(character.frame());
  std::this_thread::sleep_for(std::chrono::milliseconds(1));  // stands for the rest of the engine's work
}

/// Reloads the file on another thread while the character plays, then switches to it. Returns true if the old version
/// was freed.
bool reload(int saves, Character& character, Screen& screen) {
  const std::weak_ptr<const Version> old = screen.shown.version;
  auto read = std::async(std::launch::async, [saves] { return std::make_shared<Version>(read_file(saves), "turn"); });
  bool taken = false;
  while (!taken || character.goes_over()) {
    if (!taken && read.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
      character.replace_with(read.get());
      taken = true;
    }
    draw_next(character, screen);
  }
  return old.expired();
}

}  // namespace

int main(int argc, char** argv) {
  int reloads = 20;
  if (argc > 1) {
    const char* const end = argv[1] + std::strlen(argv[1]);
    const auto [stop, error] = std::from_chars(argv[1], end, reloads);
    if (argc > 2 || error != std::errc{} || stop != end || reloads < 1 || reloads > 1000) {
      std::fprintf(stderr, "usage: reload_a_character [reloads, 1 to 1000]\n");
      return 2;
    }
  }
  Character character(std::make_shared<Version>(read_file(0), "turn"));
  Screen screen;
  while (screen.drawn < 3) draw_next(character, screen);
  for (int saves = 1; saves <= reloads; ++saves)
    if (!reload(saves, character, screen)) {
      std::fprintf(stderr, "reload %d: the version before is still there\n", saves);
      return 1;
    }
  if (screen.wrong > 0) {
    std::fprintf(stderr, "%d of %d frames are empty, late or wrong\n", screen.wrong, screen.drawn);
    return 1;
  }
  std::printf("%d reloads in %d frames, up to %.2f s: every frame has the bits of its version and its time\n", reloads,
              screen.drawn, screen.last_s);
  return 0;
}
