// SPDX-License-Identifier: MIT
// Content of a slot after an update, and the counts of copied data.
#include "viewer/upload/frame_upload.h"

#include <cstring>
#include <initializer_list>

#include "tests/viewer/device_fixture.h"

namespace sinew::viewer {
namespace {

/// Two meshes on three instances: a mesh of two primitives, of which the second is blended, and a mesh of one.
Scene small_scene() {
  Scene scene;
  scene.materials.resize(3);
  scene.materials[1].alpha_mode = AlphaMode::blend;
  scene.materials[2].alpha_mode = AlphaMode::mask;
  scene.meshes.resize(2);
  scene.meshes[0].primitives.resize(2);
  scene.meshes[0].primitives[0].material = 0;
  scene.meshes[0].primitives[1].material = 1;
  scene.meshes[0].primitives[1].bounds = {{1, 2, 3}, {3, 6, 9}};
  scene.meshes[1].primitives.resize(1);
  scene.instances = {{.joint = 2, .mesh = 1}, {.joint = 0, .mesh = 0}, {.joint = 1, .mesh = 0}};
  return scene;
}

/// Attributes of one primitive of a frame.
struct Vertices {
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::vec4> tangents, colors;
  std::uint64_t since = 0;
};

/// A frame of the small scene.
struct Frame {
  std::vector<Vertices> primitives = std::vector<Vertices>(5);
  std::vector<InstanceResult> instances = {{.first_primitive = 0}, {.first_primitive = 1}, {.first_primitive = 3}};
  std::vector<Affine> model = std::vector<Affine>(3);
  std::vector<DeformedPrimitive> deformed = {};

  FrameResult result(std::uint64_t number) {
    deformed.clear();
    for (const Vertices& v : primitives)
      deformed.push_back({0, 0, v.positions, v.normals, v.tangents, v.colors, v.since});
    FrameResult out;
    out.frame = number;
    out.model = model;
    out.instances = instances;
    out.primitives = deformed;
    return out;
  }
};

std::vector<glm::vec3> vectors(float first, std::size_t count) {
  std::vector<glm::vec3> out;
  for (std::size_t i = 0; i < count; ++i) out.emplace_back(first, static_cast<float>(i), -first);
  return out;
}
std::vector<glm::vec4> rows(float first, std::size_t count) {
  std::vector<glm::vec4> out;
  for (const glm::vec3& v : vectors(first, count)) out.emplace_back(v, 1.0f);
  return out;
}

/// True if the slot holds the values at an offset.
template <class T>
bool holds(const FrameVertices& slot, VkDeviceSize at, const std::vector<T>& values) {
  return at != kAbsent && at + values.size() * sizeof(T) <= slot.buffer.size() &&
         std::memcmp(slot.buffer.mapped() + at, values.data(), values.size() * sizeof(T)) == 0;
}

class frame_upload_slots : public DeviceTest {
 protected:
  void update(FrameUpload& upload, Frame& frame, std::uint64_t number, std::uint64_t source = 0) {
    upload.update(0, frame.result(number), source);
  }
  Scene scene = small_scene();
};

TEST_F(frame_upload_slots, every_attribute_that_is_deformed_has_its_own_place_and_is_copied) {
  FrameUpload upload(*test_device(), scene, 1);
  Frame frame;
  frame.primitives[0] = {vectors(1, 3), vectors(2, 3), rows(3, 3), rows(4, 3)};
  frame.primitives[2] = {vectors(5, 5), {}, {}, rows(6, 5)};
  frame.primitives[4] = {{}, vectors(7, 1), rows(8, 1), {}};
  update(upload, frame, 1);
  const FrameVertices& slot = upload.vertices(0);
  ASSERT_EQ(slot.primitives.size(), 5u);
  VkDeviceSize end = 0;
  std::uint64_t bytes = 0;
  for (std::size_t p = 0; p < 5; ++p) {
    const Vertices& v = frame.primitives[p];
    const DeformedBuffers& at = slot.primitives[p];
    const auto expect = [&](const auto& values, VkDeviceSize place) {
      if (values.empty()) {
        EXPECT_EQ(place, kAbsent);
        return;
      }
      EXPECT_TRUE(holds(slot, place, values)) << "primitive " << p;
      EXPECT_EQ(place % 16, 0u);
      EXPECT_EQ(place, end) << "one after another";
      end = (place + values.size() * sizeof(values[0]) + 15) / 16 * 16;
      bytes += values.size() * sizeof(values[0]);
    };
    expect(v.positions, at.positions);
    expect(v.normals, at.normals);
    expect(v.tangents, at.tangents);
    expect(v.colors, at.colors);
  }
  EXPECT_EQ(upload.last_update().bytes, bytes);
  EXPECT_EQ(upload.uploaded_bytes(), bytes);
  EXPECT_EQ(upload.last_update().written, 3u);
  EXPECT_EQ(upload.last_update().unchanged, 0u);
  EXPECT_EQ(slot.frame, 1u);
}

TEST_F(frame_upload_slots, P19_a_primitive_is_copied_exactly_when_its_stamp_is_newer_than_the_slot) {
  for (const std::uint64_t since : {0u, 1u, 3u, 4u, 5u, 6u}) {
    FrameUpload upload(*test_device(), scene, 1);
    Frame frame;
    frame.primitives[0] = {vectors(1, 4), {}, {}, {}, 4};
    frame.primitives[1] = {vectors(2, 4), {}, {}, {}, 4};
    update(upload, frame, 4);
    const std::uint64_t once = upload.uploaded_bytes();
    const std::vector<glm::vec3> before = frame.primitives[0].positions;
    frame.primitives[0].positions = vectors(9, 4);
    frame.primitives[0].since = since;
    update(upload, frame, 6);
    const bool copied = since == 0 || since > 4;
    EXPECT_EQ(upload.last_update().written, copied ? 1u : 0u) << since;
    EXPECT_EQ(upload.last_update().unchanged, copied ? 1u : 2u) << since;
    EXPECT_EQ(upload.last_update().bytes, copied ? once / 2 : 0u) << since;
    EXPECT_EQ(upload.uploaded_bytes(), once + (copied ? once / 2 : 0));
    EXPECT_TRUE(holds(upload.vertices(0), upload.vertices(0).primitives[0].positions,
                      copied ? frame.primitives[0].positions : before))
        << since;
    frame.primitives[0].since = frame.primitives[1].since = 6;
    update(upload, frame, 7);
    EXPECT_EQ(upload.last_update().written, 0u) << "the slot is as new as frame 6, also where it copied nothing then";
  }
}

TEST_F(frame_upload_slots, a_slot_that_was_never_filled_or_saw_another_source_trusts_no_stamp) {
  FrameUpload upload(*test_device(), scene, 2);
  Frame frame;
  frame.primitives[0] = {vectors(1, 4), {}, {}, {}, 1};
  upload.update(0, frame.result(5), 0);
  EXPECT_EQ(upload.last_update().written, 1u);
  upload.update(1, frame.result(5), 0);
  EXPECT_EQ(upload.last_update().written, 1u) << "the other slot";
  upload.update(0, frame.result(6), 3);
  EXPECT_EQ(upload.last_update().written, 1u) << "another source";
  upload.update(0, frame.result(7), 3);
  EXPECT_EQ(upload.last_update().written, 0u);
  upload.update(0, frame.result(7), 0);
  EXPECT_EQ(upload.last_update().written, 1u) << "the first source again, with the same number";
}

TEST_F(frame_upload_slots, the_frame_that_is_there_is_not_looked_at_again) {
  FrameUpload upload(*test_device(), scene, 1);
  Frame frame;
  frame.primitives[0] = {vectors(1, 4), {}, {}, {}};
  frame.instances[1].visible = false;
  update(upload, frame, 0);
  EXPECT_EQ(upload.last_update().written, 1u) << "a number of 0 is a frame as well";
  frame.instances[1].visible = true;
  update(upload, frame, 0);
  EXPECT_EQ(upload.last_update().written + upload.last_update().unchanged, 0u);
  EXPECT_EQ(upload.last_update().bytes, 0u);
  EXPECT_FALSE(upload.vertices(0).instances[1].visible);
}

TEST_F(frame_upload_slots, vertices_that_come_to_lie_elsewhere_are_copied_whatever_their_stamp) {
  FrameUpload upload(*test_device(), scene, 1);
  Frame frame;
  for (Vertices& v : frame.primitives) v = {vectors(1, 4), {}, {}, {}, 1};
  frame.primitives[0].normals = vectors(2, 4);
  update(upload, frame, 1);
  frame.primitives[0].normals.clear();
  update(upload, frame, 2);
  EXPECT_EQ(upload.last_update().written, 5u) << "all others moved up";
  frame.primitives[3].tangents = rows(3, 4);
  frame.primitives[3].positions.clear();
  update(upload, frame, 3);
  EXPECT_EQ(upload.last_update().unchanged, 3u) << "those before it";
  for (std::size_t p = 0; p < 5; ++p)
    EXPECT_TRUE(p == 3 || holds(upload.vertices(0), upload.vertices(0).primitives[p].positions, vectors(1, 4)));
  EXPECT_TRUE(holds(upload.vertices(0), upload.vertices(0).primitives[3].tangents, rows(3, 4)));
}

TEST_F(frame_upload_slots, each_attribute_that_changes_its_place_alone_is_seen) {
  // Two attributes of the same size change places: nothing else moves.
  const auto written = [&](const Vertices& first, const Vertices& second) {
    FrameUpload upload(*test_device(), scene, 1);
    Frame frame;
    frame.primitives[0] = first;
    update(upload, frame, 1);
    frame.primitives[0] = second;
    update(upload, frame, 2);
    return upload.last_update().written;
  };
  const auto v = vectors(1, 4);
  const auto r = rows(1, 4);
  EXPECT_EQ(written({v, {}, {}, {}, 1}, {{}, v, {}, {}, 1}), 1u);
  EXPECT_EQ(written({{}, {}, r, {}, 1}, {{}, {}, {}, r, 1}), 1u);
  EXPECT_EQ(written({v, {}, r, {}, 1}, {v, {}, {}, r, 1}), 1u);
  EXPECT_EQ(written({v, v, r, r, 1}, {v, v, r, r, 1}), 0u);
}

TEST_F(frame_upload_slots, an_attribute_that_comes_alone_into_a_buffer_with_room_is_copied) {
  const Vertices all = {vectors(1, 4), vectors(2, 4), rows(3, 4), rows(4, 4), 1};
  for (int missing = 0; missing < 4; ++missing) {
    FrameUpload upload(*test_device(), scene, 1);
    Frame frame;
    Vertices& some = frame.primitives[0] = all;
    if (missing == 0) some.positions.clear();
    if (missing == 1) some.normals.clear();
    if (missing == 2) some.tangents.clear();
    if (missing == 3) some.colors.clear();
    frame.primitives[4] = {vectors(5, 40), {}, {}, {}, 1};
    update(upload, frame, 1);
    frame.primitives[0] = all;
    frame.primitives[4] = {};
    update(upload, frame, 2);
    EXPECT_EQ(upload.last_update().written, 1u) << missing;
    const FrameVertices& slot = upload.vertices(0);
    EXPECT_TRUE(holds(slot, slot.primitives[0].positions, all.positions)) << missing;
    EXPECT_TRUE(holds(slot, slot.primitives[0].normals, all.normals)) << missing;
    EXPECT_TRUE(holds(slot, slot.primitives[0].tangents, all.tangents)) << missing;
    EXPECT_TRUE(holds(slot, slot.primitives[0].colors, all.colors)) << missing;
  }
}

TEST_F(frame_upload_slots, a_larger_frame_takes_a_new_buffer_and_is_copied_whole_and_a_smaller_one_stays) {
  FrameUpload upload(*test_device(), scene, 1);
  Frame frame;
  frame.primitives[1] = {vectors(1, 4), {}, {}, {}, 1};
  update(upload, frame, 1);
  const VkBuffer first = upload.vertices(0).buffer.handle();
  frame.primitives[4] = {vectors(2, 4000), {}, {}, {}, 2};
  update(upload, frame, 2);
  EXPECT_NE(upload.vertices(0).buffer.handle(), first);
  EXPECT_EQ(upload.last_update().written, 2u) << "the new buffer is empty";
  EXPECT_TRUE(holds(upload.vertices(0), upload.vertices(0).primitives[1].positions, vectors(1, 4)));
  EXPECT_TRUE(holds(upload.vertices(0), upload.vertices(0).primitives[4].positions, vectors(2, 4000)));
  const VkBuffer second = upload.vertices(0).buffer.handle();
  frame.primitives[4] = {};
  update(upload, frame, 3);
  EXPECT_EQ(upload.vertices(0).buffer.handle(), second);
  EXPECT_EQ(upload.last_update().written, 0u);
}

TEST_F(frame_upload_slots, blended_primitives_have_the_centre_of_their_box_and_keep_it_while_they_do_not_change) {
  FrameUpload upload(*test_device(), scene, 1);
  Frame frame;
  for (Vertices& v : frame.primitives) v = {{{-1, 2, 10}, {3, 4, -6}, {0, 3, 0}}, {}, {}, {}, 1};
  update(upload, frame, 1);
  const std::vector<DeformedBuffers>& there = upload.vertices(0).primitives;
  for (const std::size_t opaque : {0u, 1u, 3u}) EXPECT_EQ(there[opaque].centre, glm::vec3(0)) << "not sorted";
  for (const std::size_t glass : {2u, 4u}) EXPECT_EQ(there[glass].centre, glm::vec3(1, 3, 2));
  update(upload, frame, 2);
  EXPECT_EQ(upload.last_update().unchanged, 5u);
  for (const std::size_t glass : {2u, 4u}) EXPECT_EQ(there[glass].centre, glm::vec3(1, 3, 2)) << "unchanged";
  frame.primitives[2] = {};
  update(upload, frame, 3);
  EXPECT_EQ(there[2].centre, glm::vec3(2, 4, 6)) << "of the box at rest";
  scene.meshes[0].primitives[1].bounds = {};
  update(upload, frame, 4);
  EXPECT_EQ(there[2].centre, glm::vec3(0)) << "nothing is known";
}

TEST_F(frame_upload_slots, a_variant_that_blends_is_sorted_as_well) {
  scene.meshes[1].primitives[0].material = 2;
  scene.meshes[1].primitives[0].bounds = {{2, 2, 2}, {4, 4, 4}};
  scene.meshes[1].primitives[0].variant_materials = {{0, 0}, {1, kNone}};
  Frame frame;
  FrameUpload without(*test_device(), scene, 1);
  update(without, frame, 1);
  EXPECT_EQ(without.vertices(0).primitives[0].centre, glm::vec3(0));
  scene.meshes[1].primitives[0].variant_materials.push_back({2, 1});
  FrameUpload with(*test_device(), scene, 1);
  update(with, frame, 1);
  EXPECT_EQ(with.vertices(0).primitives[0].centre, glm::vec3(3));
}

TEST_F(frame_upload_slots, instances_are_placed_as_the_frame_has_them) {
  FrameUpload upload(*test_device(), scene, 1);
  Frame frame;
  const bool hidden[] = {false, true, false};
  frame.instances[0].mirrored = true;
  frame.instances[1].bounds = {{1, 1, 1}, {2, 2, 2}};
  frame.instances[2].visible = false;
  frame.instances[2].world_from_mesh = translation({7, 8, 9});
  FrameResult result = frame.result(1);
  result.hidden = hidden;
  upload.update(0, result);
  const std::vector<PlacedInstance>& placed = upload.vertices(0).instances;
  ASSERT_EQ(placed.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(placed[i].mirrored, i == 0);
    EXPECT_EQ(placed[i].visible, i != 2);
    EXPECT_EQ(placed[i].hidden, i == 2) << "its joint is 1";
    EXPECT_EQ(placed[i].bounds.empty(), i != 1);
    EXPECT_EQ(placed[i].first_primitive, frame.instances[i].first_primitive);
  }
  EXPECT_EQ(placed[2].world_from_mesh.row[2].w, 9.0f);
  EXPECT_EQ(placed[1].bounds.upper, glm::vec3(2));
  upload.update(0, frame.result(2));
  EXPECT_FALSE(upload.vertices(0).instances[2].hidden) << "nothing of this frame is hidden";
}

TEST_F(frame_upload_slots, lights_stand_on_their_joints_and_shine_where_these_are_shown) {
  scene.lights.resize(4);
  scene.lights[0].joint = 1;
  scene.lights[1].joint = 2;
  scene.lights[2].joint = kNone;
  scene.lights[3].joint = 0;
  FrameUpload upload(*test_device(), scene, 1);
  Frame frame;
  for (std::size_t j = 0; j < 3; ++j) frame.model[j] = translation(glm::vec3(static_cast<float>(j) + 1.0f));
  const bool hidden[] = {false, true, false};
  FrameResult result = frame.result(1);
  result.hidden = hidden;
  upload.update(0, result);
  const FrameVertices& slot = upload.vertices(0);
  const float expected_x[] = {2, 3, 0, 1};
  const bool shines[] = {false, true, false, true};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(slot.world_from_light[i].row[0].w, expected_x[i]) << i;
    EXPECT_EQ(slot.light_shines[i], shines[i]) << i;
  }
}

TEST_F(frame_upload_slots, each_slot_has_a_look_of_its_own) {
  scene.animations.resize(1);
  scene.animations[0].properties.resize(1);
  PropertyTrack& track = scene.animations[0].properties[0];
  track.target = {PropertyKind::roughness, 1};
  track.values = {Interpolation::linear, {0.0f, 1.0f}, {0.25f, 0.75f}, 1};
  scene.properties = make_property_table(scene);
  FrameUpload upload(*test_device(), scene, 2);
  Frame frame;
  const float quarter[] = {0.25f}, half[] = {0.5f};
  FrameResult result = frame.result(1);
  result.properties = quarter;
  upload.update(0, result);
  EXPECT_EQ(upload.look(0).materials[1].roughness, 0.25f);
  EXPECT_EQ(upload.look(1).materials[1].roughness, scene.materials[1].roughness);
  result.frame = 2;
  result.properties = half;
  upload.update(1, result);
  EXPECT_EQ(upload.look(0).materials[1].roughness, 0.25f);
  EXPECT_EQ(upload.look(1).materials[1].roughness, 0.5f);
}

}  // namespace
}  // namespace sinew::viewer
