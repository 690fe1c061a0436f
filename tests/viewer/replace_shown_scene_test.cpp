// SPDX-License-Identifier: MIT
// Replacing the shown scene by its changed file: kept state, pictures, and device memory.
#include "viewer/app/reload/replace_shown_scene.h"
#include "viewer/app/open/open_files.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>

#include "importer/export_glb.h"
#include "samples/showcase/showcase.h"
#include "tests/viewer/device_fixture.h"
#include "viewer/app/scene_choice.h"
#include "viewer/app/settings.h"
#include "viewer/device/buffer.h"
#include "viewer/device/image.h"

namespace sinew::viewer {
namespace {

namespace fs = std::filesystem;

constexpr VkExtent2D kExtent{160, 100};
constexpr VkFormat kFormat = VK_FORMAT_R8G8B8A8_UNORM;
constexpr std::uint32_t kSlots = 2;

/// Draws as the window does: frames are submitted and not waited for, until a slot is used again.
class Frames {
 public:
  explicit Frames(Device& device) : device_(device), renderer_(device, kFormat, kSlots) {
    for (std::uint32_t i = 0; i < kSlots; ++i) slots_.push_back(std::make_unique<Slot>(device));
  }
  ~Frames() { vkDeviceWaitIdle(device_.handle()); }

  void draw(ShownScene& shown) {
    Slot& slot = *slots_[next_];
    must(vkWaitForFences(device_.handle(), 1, &slot.done, VK_TRUE, ~std::uint64_t{0}), "waiting");
    must(vkResetFences(device_.handle(), 1, &slot.done), "resetting");
    must(vkResetCommandPool(device_.handle(), slot.pool, 0), "resetting");
    const DrawnScene drawn = shown.upload(next_, kNone);
    FrameInputs inputs;
    inputs.slot = next_;
    inputs.scenes = {&drawn, 1};
    inputs.view = look_at({0.0, 2.0, 9.0}, {0.0, 1.0, 0.0}, 0.8, 0.05);
    inputs.options = render_options(Settings(), nullptr, shown.bounds(), {0.0, 2.0, 9.0});
    const VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    must(vkBeginCommandBuffer(slot.commands, &begin), "beginning");
    renderer_.record(slot.commands,
                     {slot.image.handle(), slot.image.view(), kExtent, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL}, inputs);
    read_back(slot.commands, slot.image.handle(), kExtent, slot.pixels.handle());
    must(vkEndCommandBuffer(slot.commands), "ending");
    VkSubmitInfo submit{VK_STRUCTURE_TYPE_SUBMIT_INFO};
    submit.commandBufferCount = 1;
    submit.pCommandBuffers = &slot.commands;
    must(vkQueueSubmit(device_.queue(), 1, &submit, slot.done), "submitting");
    last_ = next_;
    next_ = (next_ + 1) % kSlots;
  }

  std::vector<std::uint8_t> last_picture() {
    const Slot& slot = *slots_[last_];
    must(vkWaitForFences(device_.handle(), 1, &slot.done, VK_TRUE, ~std::uint64_t{0}), "waiting");
    std::vector<std::uint8_t> rgba(slot.pixels.size());
    std::memcpy(rgba.data(), slot.pixels.mapped(), rgba.size());
    return rgba;
  }

 private:
  struct Slot {
    explicit Slot(Device& device)
        : device_(device.handle()),
          image(device, {kFormat, kExtent, 1, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT}),
          pixels(device, VkDeviceSize{4} * kExtent.width * kExtent.height, VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                 MemoryUse::read_back) {
      VkCommandPoolCreateInfo made{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
      made.queueFamilyIndex = device.queue_family();
      must(vkCreateCommandPool(device_, &made, nullptr, &pool), "making a pool");
      VkCommandBufferAllocateInfo one{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
      one.commandPool = pool;
      one.commandBufferCount = 1;
      must(vkAllocateCommandBuffers(device_, &one, &commands), "making a command buffer");
      VkFenceCreateInfo fence{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
      fence.flags = VK_FENCE_CREATE_SIGNALED_BIT;
      must(vkCreateFence(device_, &fence, nullptr, &done), "making a fence");
    }
    ~Slot() {
      vkDestroyFence(device_, done, nullptr);
      vkDestroyCommandPool(device_, pool, nullptr);
    }

    VkDevice device_;
    GpuImage image;
    Buffer pixels;
    VkCommandPool pool = VK_NULL_HANDLE;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    VkFence done = VK_NULL_HANDLE;
  };

  Device& device_;
  FrameRenderer renderer_;
  std::vector<std::unique_ptr<Slot>> slots_;
  std::uint32_t next_ = 0, last_ = 0;
};

/// Twisted arms with the clips "twist" and "slow".
LoadedScene first_state() {
  LoadedScene loaded;
  loaded.name = "arms";
  loaded.scene = showcase::twisted_arms().scene;
  loaded.scene.animations.push_back(loaded.scene.animations[0]);
  loaded.scene.animations[1].name = "slow";
  finish_scene(loaded.scene);
  return loaded;
}

/// Changed: the arms are green, there is a new first clip, and "slow" moves other joints.
LoadedScene changed_state() {
  LoadedScene loaded = first_state();
  loaded.note = "changed";
  loaded.scene.materials[0].base_color = {0.1f, 0.8f, 0.1f, 1.0f};
  auto& clips = loaded.scene.animations;
  clips.insert(clips.begin(), clips[0]);
  clips[0].name = "new";
  clips[2].bones.pop_back();
  finish_scene(loaded.scene);
  return loaded;
}

class replace_with : public DeviceTest {
 protected:
  void SetUp() override {
    DeviceTest::SetUp();
    if (IsSkipped()) return;
    shown_ = make_(loaded_, {});
    shown_->playback().choose(1);
    shown_->playback().set_speed(0.5);
    shown_->playback().seek(2.5);
    shown_->catch_up();
    frames_ = std::make_unique<Frames>(*test_device());
  }
  void TearDown() override {
    frames_.reset();
    shown_.reset();
    DeviceTest::TearDown();
  }

  // The picture of a viewer that starts with the changed file.
  std::vector<std::uint8_t> fresh_picture(const LoadedScene& loaded, std::uint32_t clip, double time_s) {
    Frames frames(*test_device());
    const auto fresh = make_(loaded, {});
    fresh->playback().choose(clip);
    fresh->playback().seek(time_s);
    fresh->catch_up();
    frames.draw(*fresh);
    return frames.last_picture();
  }

  tl::expected<void, std::string> change_to(LoadedScene changed) {
    return replace_shown_scene(*test_device(), std::move(changed), loaded_, shown_, make_);
  }

  LoadedScene loaded_ = first_state();
  MakeShown make_ = [](const LoadedScene& loaded, const Evaluation& evaluation) {
    return std::make_unique<ShownScene>(*test_device(), loaded, evaluation, kSlots, TextureFilter{});
  };
  std::unique_ptr<ShownScene> shown_;
  std::unique_ptr<Frames> frames_;
};

TEST_F(replace_with, a_changed_file_shows_the_picture_of_a_fresh_start) {
  frames_->draw(*shown_);
  frames_->draw(*shown_);
  const auto old_picture = frames_->last_picture();
  frames_->draw(*shown_);  // two frames are with the device while the scene changes
  frames_->draw(*shown_);
  ASSERT_TRUE(change_to(changed_state()));
  EXPECT_EQ(loaded_.note, "changed");
  for (int i = 0; i < 3; ++i) {
    frames_->draw(*shown_);
    EXPECT_EQ(frames_->last_picture(), fresh_picture(changed_state(), 2, 2.5)) << i;
  }
  EXPECT_NE(frames_->last_picture(), old_picture);
  ASSERT_TRUE(change_to(first_state()));
  frames_->draw(*shown_);
  EXPECT_EQ(frames_->last_picture(), old_picture) << "and back";
}

TEST_F(replace_with, a_changed_file_keeps_clip_time_speed_looping_and_pause) {
  shown_->playback().set_mode(PlayMode::ping_pong);
  shown_->playback().pause();
  ASSERT_TRUE(change_to(changed_state()));
  const Playback& playback = shown_->playback();
  EXPECT_EQ(playback.clip(), 2u);
  EXPECT_EQ(playback.time_s(), 2.5);
  EXPECT_EQ(playback.speed(), 0.5);
  EXPECT_EQ(playback.mode(), PlayMode::ping_pong);
  EXPECT_FALSE(playback.playing());
  EXPECT_TRUE(shown_->settled()) << "the next picture shows it";
  EXPECT_EQ(shown_->last_error(), ErrorCode::ok);
}

TEST_F(replace_with, a_file_without_the_clip_plays_its_first_one) {
  LoadedScene changed = first_state();
  changed.scene.animations.pop_back();
  finish_scene(changed.scene);
  ASSERT_TRUE(change_to(std::move(changed)));
  EXPECT_EQ(shown_->playback().clip(), 0u);
  EXPECT_EQ(shown_->playback().time_s(), 0.0);
  EXPECT_EQ(shown_->playback().speed(), 0.5);
}

TEST_F(replace_with, a_file_without_clips_and_back_shows_its_rest_pose_and_then_plays) {
  LoadedScene changed = first_state();
  changed.scene.animations.clear();
  finish_scene(changed.scene);
  ASSERT_TRUE(change_to(std::move(changed)));
  EXPECT_EQ(shown_->playback().clip(), kNone);
  ASSERT_TRUE(change_to(first_state()));
  EXPECT_EQ(shown_->playback().clip(), 0u);
}

TEST_F(replace_with, a_file_that_shows_its_rest_pose_goes_on_with_it) {
  shown_->playback().choose(kNone);
  ASSERT_TRUE(change_to(changed_state()));
  EXPECT_EQ(shown_->playback().clip(), kNone);
}

TEST_F(replace_with, a_file_that_the_device_cannot_hold_shows_the_old_one_again) {
  frames_->draw(*shown_);
  const auto old_picture = frames_->last_picture();
  bool full = true;
  const auto make = [&](const LoadedScene& loaded, const Evaluation& evaluation) {
    if (std::exchange(full, false)) throw DeviceError("the device is full");
    return make_(loaded, evaluation);
  };
  const auto done = replace_shown_scene(*test_device(), changed_state(), loaded_, shown_, make);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error(), "the device is full");
  EXPECT_EQ(loaded_.note, "");
  frames_->draw(*shown_);
  EXPECT_EQ(frames_->last_picture(), old_picture);
}

TEST_F(replace_with, a_changed_file_has_the_centers_that_its_skinning_needs) {
  shown_.reset();
  const auto with = [](std::size_t count) {
    LoadedScene loaded = first_state();
    loaded.scene.animations.resize(count);
    finish_scene(loaded.scene);
    return loaded;
  };
  loaded_ = with(1);
  add_missing_centers(loaded_, Skinning::center_of_rotation);
  shown_ = make_(loaded_, {.skinning = Skinning::center_of_rotation});
  ASSERT_TRUE(change_to(with(2)));
  EXPECT_EQ(shown_->evaluation().skinning, Skinning::center_of_rotation);
  LoadedScene expected = with(2);
  add_missing_centers(expected, Skinning::center_of_rotation);
  EXPECT_EQ(loaded_.scene.meshes.back().primitives[0].centers_of_rotation,
            expected.scene.meshes.back().primitives[0].centers_of_rotation);
  EXPECT_FALSE(loaded_.scene.meshes.back().primitives[0].centers_of_rotation.empty());
}

/// A triangle with these clips, each a move of one second along y.
std::string triangle_file(const std::vector<std::string>& clips) {
  std::string animations;
  for (const std::string& clip : clips)
    animations +=
        (animations.empty() ? "" : ",") + (R"({"name":")" + clip) +
        R"(","samplers":[{"input":1,"output":2}],"channels":[{"sampler":0,"target":{"node":0,"path":"translation"}}]})";
  return R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[
    {"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
    {"bufferView":1,"componentType":5126,"count":2,"type":"SCALAR","min":[0],"max":[1]},
    {"bufferView":2,"componentType":5126,"count":2,"type":"VEC3"}],"bufferViews":[{"buffer":0,"byteLength":36},
    {"buffer":0,"byteOffset":36,"byteLength":8},{"buffer":0,"byteOffset":44,"byteLength":24}],"buffers":[{"byteLength":68,
    "uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAAAAAACAPwAAAAA="}],
    "animations":[)" +
         animations + "]}";
}

/// Files on the disk, read as the window reads them.
class reading_again : public DeviceTest {
 protected:
  void SetUp() override {
    DeviceTest::SetUp();
    if (IsSkipped()) return;
    fs::create_directories(folder_);
    options_.file = (folder_ / "thing.glb").string();
    options_.environment = "none";
  }
  void TearDown() override {
    fs::remove_all(folder_);
    DeviceTest::TearDown();
  }
  LoadedScene load() {
    auto loaded_scenes = load_scenes(options_, log_line_, {});
    EXPECT_TRUE(loaded_scenes) << loaded_scenes.error().message;
    return loaded_scenes ? std::move(loaded_scenes->front()) : LoadedScene();
  }

  fs::path folder_ = fs::temp_directory_path() / ("reading_again" + std::to_string(::getpid()));
  Options options_;
  std::vector<std::string> messages_;
  std::function<void(const std::string&)> log_line_ = [this](const std::string& line) { messages_.push_back(line); };
};

TEST_F(reading_again, makes_the_centers_that_the_kind_of_skinning_needs) {
  ASSERT_TRUE(export_glb(first_state().scene, options_.file));
  LoadedScene loaded = load();
  add_missing_centers(loaded, Skinning::center_of_rotation);
  ShownScene shown(*test_device(), loaded, {.skinning = Skinning::center_of_rotation}, kSlots, TextureFilter{});
  ASSERT_TRUE(export_glb(changed_state().scene, options_.file));
  const auto read = make_reload_job(options_, loaded, shown);
  const auto changed = read(log_line_);
  ASSERT_TRUE(changed) << changed.error().message;
  EXPECT_EQ(clip_names(changed->scene), (std::vector<std::string>{"new", "twist", "slow"}));
  EXPECT_FALSE(changed->scene.meshes.back().primitives[0].centers_of_rotation.empty());
  EXPECT_EQ(changed->visibility, nullptr);
  EXPECT_THAT(messages_, testing::IsEmpty());
  fs::remove(options_.file);
  EXPECT_FALSE(read(log_line_));
}

TEST_F(reading_again, keeps_the_light_that_is_there) {
  ASSERT_TRUE(export_glb(first_state().scene, options_.file));
  LoadedScene loaded = load();
  ASSERT_EQ(loaded.environment, nullptr);
  loaded.environment = std::make_shared<const Environment>();
  ShownScene shown(*test_device(), loaded, {}, kSlots, TextureFilter{});
  const auto changed = make_reload_job(options_, loaded, shown)(log_line_);
  ASSERT_TRUE(changed) << changed.error().message;
  EXPECT_EQ(changed->environment, loaded.environment);
}

TEST_F(reading_again, casts_the_rays_of_the_clip_that_plays) {
  options_.occlusion_method = OcclusionMethod::rays;
  options_.key_poses = 2;
  std::ofstream(options_.file) << triangle_file({"up", "on"});
  const LoadedScene loaded = load();
  ShownScene shown(*test_device(), loaded, {}, kSlots, TextureFilter{});
  shown.playback().choose(1);
  for (const auto& [clips, expected] :
       {std::pair(std::vector<std::string>{"new", "up", "on"}, 2u), std::pair(std::vector<std::string>{"up"}, 0u)}) {
    std::ofstream(options_.file) << triangle_file(clips);
    messages_.clear();
    const auto changed = make_reload_job(options_, loaded, shown)(log_line_);
    ASSERT_TRUE(changed) << changed.error().message;
    ASSERT_EQ(messages_.size(), 1u);
    if (changed->visibility == nullptr) GTEST_SKIP() << messages_[0];
    EXPECT_EQ(changed->visibility->clip, expected);
  }
}

}  // namespace
}  // namespace sinew::viewer
