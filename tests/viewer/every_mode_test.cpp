// SPDX-License-Identifier: MIT
// Draws with every value of every rendering option, in a picture of one pixel and in a very wide one, without
// validation messages.
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "samples/showcase/shapes.h"
#include "tests/viewer/device_fixture.h"
#include "viewer/app/load_environment.h"
#include "viewer/app/settings.h"
#include "viewer/device/image.h"
#include "viewer/passes/frame_renderer.h"

namespace sinew::viewer {
namespace {

class every_mode : public DeviceTest {};

constexpr std::uint32_t kWide = 4000;

constexpr char kDefaults[] =
    "--ao gtao --show color --normals interpolated --transparency sorted --smoothing on --tone aces "
    "--backdrop blurred --shading physical --ground shadows --environment studio --exposure 0";

const char* const kModes[] = {
    kDefaults,
    "--ao ssao",
    "--ao rays",
    "--no-ao",
    "--show ao",
    "--show ao --ao rays",
    "--show ao --no-ao",
    "--show normals",
    "--show normals --normals quaternion",
    "--show depth",
    "--show level",
    "--normals quaternion",
    "--transparency weighted",
    "--transparency weighted --smoothing off",
    "--smoothing off",
    "--tone neutral",
    "--tone none",
    "--backdrop plain",
    "--backdrop sharp",
    "--shading gooch",
    "--shading gooch --ground grid --backdrop sharp --smoothing off",
    "--ground none",
    "--ground grid",
    "--no-shadows",
    "--no-shadows --ground none --no-ao --environment none",
    "--environment studio --environment-turn 90",
    "--environment sunset",
    "--environment overcast",
    "--environment plain --environment-intensity 2",
    "--environment none",
    "--exposure 1",
    "--exposure auto",
    "--exposure auto --smoothing off --transparent",
    "--transparent",
};

const char* const kFilters[] = {
    "--filter nearest",       "--filter bilinear", "--filter trilinear",
    "--filter anisotropic=4", "--filter ripmap",   "--filter ripmap --show level",
};

Options parsed(const std::string& words) {
  std::vector<std::string> list = {"sinew-viewer", "--headless", "a.png"};
  for (std::size_t at = 0; at < words.size();) {
    const std::size_t end = std::min(words.find(' ', at), words.size());
    list.push_back(words.substr(at, end - at));
    at = end + 1;
  }
  std::vector<const char*> argv;
  for (const std::string& word : list) argv.push_back(word.c_str());
  const auto result = parse_options(static_cast<int>(argv.size()), argv.data());
  EXPECT_TRUE(std::holds_alternative<Options>(result)) << words;
  return std::get<Options>(result);
}

/// Two balls on a textured floor: of lacquer, and of rough glass; a pane that blends, a mask, unlit lines, two lights.
BuiltScene all_kinds() {
  BuiltScene built;
  built.scene.images.push_back(
      {"squares", 2, 2, {200, 90, 80, 255, 80, 120, 200, 40, 90, 200, 90, 255, 220, 220, 90, 40}, ""});
  built.scene.textures.push_back({0, {}});
  Material floor = matte({0.7f, 0.7f, 0.7f}), lacquer = matte({0.5f, 0.1f, 0.1f}), glass = matte({0.8f, 0.9f, 1.0f}),
           pane = matte({0.3f, 0.8f, 0.4f}), mask = floor, line = matte({1.0f, 0.5f, 0.0f});
  floor.base_color_texture.texture = floor.normal_texture.texture = 0;
  lacquer.clearcoat.factor = 1.0f;
  glass.transmission.factor = 0.8f;
  pane.base_color.a = 0.5f;
  pane.alpha_mode = AlphaMode::blend;
  mask.base_color_texture.texture = 0;
  mask.alpha_mode = AlphaMode::mask;
  line.unlit = true;
  Affine upright = translation({0.0f, 0.5f, 1.0f});
  upright.row[1] = {0.0f, 0.0f, -1.0f, 0.5f};
  upright.row[2] = {0.0f, 1.0f, 0.0f, 1.0f};
  Affine behind = upright;
  behind.row[2].w = -1.0f;
  built.add(square(4.0f), built.add_material(floor));
  built.add(showcase::sphere({0, 0, 0}, 0.6f), built.add_material(lacquer), translation({-0.9f, 0.6f, 0.0f}));
  built.add(showcase::sphere({0, 0, 0}, 0.6f), built.add_material(glass), translation({0.9f, 0.6f, 0.0f}));
  built.add(square(0.5f), built.add_material(pane), upright);
  built.add(square(2.0f), built.add_material(mask), behind);
  Primitive lines;
  lines.topology = Topology::lines;
  lines.positions = {{-2.0f, 1.0f, 0.5f}, {2.0f, 0.2f, 0.5f}};
  lines.indices = {0, 1};
  built.add(lines, built.add_material(line));
  Affine from_above = translation({0.0f, 3.0f, 1.0f});
  from_above.row[1] = {0.0f, 0.0f, 1.0f, 3.0f};
  from_above.row[2] = {0.0f, -1.0f, 0.0f, 1.0f};
  built.add_light({.name = "sun", .kind = Light::Kind::directional, .intensity = 2.0f}, from_above);
  built.add_light({.name = "spot", .kind = Light::Kind::spot, .intensity = 20.0f}, from_above);
  return built;
}

VertexVisibility half_visibility(const Scene& scene) {
  VertexVisibility visibility;
  for (const Mesh& mesh : scene.meshes)
    visibility.values.push_back({std::vector<float>(mesh.primitives[0].vertex_count(), 0.5f)});
  return visibility;
}

/// A view of one row of pixels through the middle of the balls, 60 degrees wide.
View view_of(std::uint32_t width) {
  return look_at({0.3, 1.2, 5.0}, {0.0, 0.6, 0.0}, 2.0 * std::atan(std::tan(0.52) / width), 0.05);
}

/// One row of pixels.
class Row {
 public:
  explicit Row(std::uint32_t width)
      : image_(*test_device(), {kFormat, {width, 1}, 1, kUsage}),
        pixels_(*test_device(), VkDeviceSize{4} * width, VK_BUFFER_USAGE_TRANSFER_DST_BIT, MemoryUse::read_back),
        extent_{width, 1} {}

  static constexpr VkFormat kFormat = VK_FORMAT_R8G8B8A8_UNORM;
  std::uint32_t width() const { return extent_.width; }

  std::span<const std::uint32_t> draw(FrameRenderer& renderer, const FrameInputs& inputs) {
    test_device()->run_now([&](VkCommandBuffer commands) {
      renderer.record(commands, {image_.handle(), image_.view(), extent_, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL},
                      inputs);
      read_back(commands, image_.handle(), extent_, pixels_.handle());
    });
    return {reinterpret_cast<const std::uint32_t*>(pixels_.mapped()), extent_.width};
  }

 private:
  static constexpr VkImageUsageFlags kUsage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  GpuImage image_;
  Buffer pixels_;
  VkExtent2D extent_;
};

/// The smallest and the widest picture, drawn by one renderer, so that each pipeline is made once.
class Pictures {
 public:
  Pictures() { extent_.reached = extent_.largest = bounds_of(built_.scene, built_.frame()); }

  void draw(const std::string& words) {
    SCOPED_TRACE(words);
    const Options options = parsed(words);
    if (!scene_ || scene_->filter() != options.filter)
      scene_ = std::make_unique<SceneUpload>(*test_device(), built_.scene, 1, &visibility_, options.filter);
    const std::uint64_t before = test_device()->validation_messages();
    draw(one_, options);
    const auto pixels = draw(wide_, options);
    const bool white = options.show == Show::ao && !options.ambient_occlusion;
    EXPECT_EQ(std::ranges::all_of(pixels, [&](std::uint32_t pixel) { return pixel == pixels[0]; }), white)
        << "something is seen";
    EXPECT_EQ(test_device()->validation_messages(), before);
  }

 private:
  std::span<const std::uint32_t> draw(Row& row, const Options& options) {
    auto& environment = environments_[options.environment];
    if (!environment) environment = load_environment(options.environment).value();
    frame_.update(0, built_.frame(), ++pictures_);
    scene_->update(0, frame_.look(0));
    const DrawnScene drawn{scene_.get(), &frame_};
    FrameInputs inputs;
    inputs.scenes = {&drawn, 1};
    inputs.view = view_of(row.width());
    inputs.options = render_options(settings_from(options, built_.scene), environment, extent_, eye_of(inputs.view));
    inputs.options.transparent_background = options.transparent;
    return row.draw(renderer_, inputs);
  }

  BuiltScene built_ = all_kinds();
  VertexVisibility visibility_ = half_visibility(built_.scene);
  ClipExtent extent_;
  std::map<std::string, std::shared_ptr<const Environment>> environments_;
  std::unique_ptr<SceneUpload> scene_;
  FrameUpload frame_{*test_device(), built_.scene, 1};
  FrameRenderer renderer_{*test_device(), Row::kFormat, 1};
  Row one_{1}, wide_{kWide};
  std::uint64_t pictures_ = 0;
};

TEST_F(every_mode, is_drawn_in_one_pixel_and_in_a_very_wide_row_without_complaint) {
  Pictures pictures;
  for (const char* words : kModes) pictures.draw(words);
  for (const char* words : kFilters) pictures.draw(words);
}

}  // namespace
}  // namespace sinew::viewer
