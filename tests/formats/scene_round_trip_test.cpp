// SPDX-License-Identifier: MIT
// A scene of our own, written by assimp's exporters and imported again: poses and vertices are those of the source.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>

#include <assimp/scene.h>
#include <assimp/Exporter.hpp>

#include "importer/formats/scene_draft.h"
#include "importer/formats/scene_file.h"
#include "importer/import_gltf.h"
#include "tests/formats/world_pose.h"
#include "tests/support/near.h"

namespace sinew::formats {
namespace {

constexpr std::array<double, 4> kTimes_s{0.0, 0.5, 1.25, 2.0};
constexpr std::array<glm::dvec3, 3> kPlaces{glm::dvec3(0, 1, 0), glm::dvec3(0, 2, 0), glm::dvec3(0, 2, 0)};
constexpr const char* kNames[] = {"hip", "knee", "foot"};
constexpr unsigned kRings = 9;

/// The rotation of joint j at key k. Angles stay small, since the exporter of FBX wraps Euler angles at 180 degrees.
glm::dquat key(std::size_t j, std::size_t k) {
  return glm::angleAxis(0.2 * static_cast<double>(j + 1) * static_cast<double>(k),
                        glm::normalize(glm::dvec3(1.0, 0.5 * static_cast<double>(j), 0.25)));
}

/// eq    world of joint j = world of joint j - 1 * T(place) * R(time); the joints make a chain
std::vector<Affined> source_pose(double time_s) {
  std::vector<Affined> out;
  std::size_t k = 0;
  while (k + 2 < kTimes_s.size() && kTimes_s[k + 1] <= time_s) ++k;
  const double factor = std::clamp((time_s - kTimes_s[k]) / (kTimes_s[k + 1] - kTimes_s[k]), 0.0, 1.0);
  for (std::size_t j = 0; j < kPlaces.size(); ++j) {
    const Affined own =
        affine_from_transform(Transformd{kPlaces[j], glm::slerp(key(j, k), key(j, k + 1), factor), glm::dvec3(1.0)});
    out.push_back(out.empty() ? own : out.back() * own);
  }
  return out;
}

glm::dvec3 vertex(unsigned v) {
  const double angle = 2.0 * v, height = 1.0 + 0.5 * (v / 3);
  return {std::cos(angle), height, std::sin(angle)};
}

/// Weight of joint j for a vertex, by its height.
double weight(unsigned v, std::size_t j) {
  const double at = (vertex(v).y - 1.0) / 2.0;
  return std::max(0.0, 1.0 - std::abs(at - static_cast<double>(j)));
}

/// eq    sum over joints of weight * world * T(-place in the world at rest) * vertex
glm::dvec3 source_vertex(unsigned v, const std::vector<Affined>& pose) {
  glm::dvec3 out(0.0), rest(0.0);
  for (std::size_t j = 0; j < pose.size(); ++j) {
    rest += kPlaces[j];
    out += weight(v, j) * transform_point(pose[j], vertex(v) - rest);
  }
  return out;
}

aiVector3D to_ai(const glm::dvec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

aiMesh* make_mesh() {
  auto* mesh = new aiMesh;
  mesh->mName.Set("leg");
  mesh->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
  mesh->mNumVertices = 3 * kRings;
  mesh->mVertices = new aiVector3D[mesh->mNumVertices];
  mesh->mNormals = new aiVector3D[mesh->mNumVertices];
  for (unsigned v = 0; v < mesh->mNumVertices; ++v) {
    mesh->mVertices[v] = to_ai(vertex(v));
    mesh->mNormals[v] = {0.0f, 1.0f, 0.0f};
  }
  mesh->mNumFaces = kRings;
  mesh->mFaces = new aiFace[kRings];
  for (unsigned f = 0; f < kRings; ++f) {
    mesh->mFaces[f].mNumIndices = 3;
    mesh->mFaces[f].mIndices = new unsigned[3]{3 * f, 3 * f + 1, 3 * f + 2};
  }
  mesh->mNumBones = 3;
  mesh->mBones = new aiBone*[3];
  glm::dvec3 rest(0.0);
  for (std::size_t j = 0; j < 3; ++j) {
    aiBone* bone = mesh->mBones[j] = new aiBone;
    bone->mName.Set(kNames[j]);
    rest += kPlaces[j];
    aiMatrix4x4::Translation(to_ai(-rest), bone->mOffsetMatrix);
    std::vector<aiVertexWeight> weights;
    for (unsigned v = 0; v < mesh->mNumVertices; ++v)
      if (weight(v, j) > 0.0) weights.emplace_back(v, static_cast<float>(weight(v, j)));
    bone->mNumWeights = static_cast<unsigned>(weights.size());
    bone->mWeights = new aiVertexWeight[weights.size()];
    std::copy(weights.begin(), weights.end(), bone->mWeights);
  }
  return mesh;
}

aiAnimation* make_animation() {
  auto* animation = new aiAnimation;
  animation->mName.Set("walk");
  animation->mTicksPerSecond = 1.0;  // the exporters take ticks for seconds
  animation->mDuration = kTimes_s.back();
  animation->mNumChannels = 3;
  animation->mChannels = new aiNodeAnim*[3];
  for (std::size_t j = 0; j < 3; ++j) {
    aiNodeAnim* channel = animation->mChannels[j] = new aiNodeAnim;
    constexpr auto kCount = static_cast<unsigned>(kTimes_s.size());
    channel->mNodeName.Set(kNames[j]);
    channel->mNumPositionKeys = channel->mNumRotationKeys = channel->mNumScalingKeys = kCount;
    channel->mPositionKeys = new aiVectorKey[kCount];
    channel->mRotationKeys = new aiQuatKey[kCount];
    channel->mScalingKeys = new aiVectorKey[kCount];
    for (unsigned k = 0; k < kCount; ++k) {
      const glm::quat q(key(j, k));
      channel->mPositionKeys[k] = {kTimes_s[k], to_ai(kPlaces[j])};
      channel->mRotationKeys[k] = {kTimes_s[k], aiQuaternion(q.w, q.x, q.y, q.z)};
      channel->mScalingKeys[k] = {kTimes_s[k], aiVector3D(1.0f, 1.0f, 1.0f)};
    }
  }
  return animation;
}

/// A chain of three joints and a skinned mesh beside it.
std::unique_ptr<aiScene> make_scene() {
  auto scene = std::make_unique<aiScene>();
  scene->mRootNode = new aiNode("world");
  aiNode* parent = scene->mRootNode;
  auto* shown = new aiNode("leg");
  shown->mNumMeshes = 1;
  shown->mMeshes = new unsigned[1]{0};
  parent->addChildren(1, &shown);
  for (std::size_t j = 0; j < 3; ++j) {
    auto* node = new aiNode(kNames[j]);
    aiMatrix4x4::Translation(to_ai(kPlaces[j]), node->mTransformation);
    parent->addChildren(1, &node);
    parent = node;
  }
  scene->mNumMeshes = scene->mNumMaterials = scene->mNumAnimations = 1;
  scene->mMeshes = new aiMesh* [1] { make_mesh() };
  scene->mMaterials = new aiMaterial* [1] { new aiMaterial };
  scene->mAnimations = new aiAnimation* [1] { make_animation() };
  return scene;
}

/// The posed position of the imported vertex whose rest position is nearest to `rest`.
glm::dvec3 skinned(const Scene& scene, const glm::dvec3& rest, const std::vector<Affined>& world, double& off) {
  const Primitive& primitive = scene.meshes.at(0).primitives.at(0);
  const auto nearest = std::min_element(
      primitive.positions.begin(), primitive.positions.end(), [&](const glm::vec3& a, const glm::vec3& b) {
        return glm::distance(glm::dvec3(a), rest) < glm::distance(glm::dvec3(b), rest);
      });
  off = glm::distance(glm::dvec3(*nearest), rest);
  const auto index = static_cast<std::uint32_t>(nearest - primitive.positions.begin());
  const Skin& skin = scene.skins.at(0);
  glm::dvec3 out(0.0);
  for (const InfluenceGroup& group : primitive.influences.groups)
    for (std::uint32_t i = 0; index - group.first_vertex < group.vertex_count && i < group.influence_count; ++i) {
      const std::size_t at =
          group.first_influence + std::size_t{index - group.first_vertex} * group.influence_count + i;
      const std::uint16_t joint = primitive.influences.joints[at];
      const Affined palette =
          world[scene.skeleton.node_of_joint[skin.joints[joint]]] * affine_cast<double>(skin.inverse_bind[joint]);
      out += double{primitive.influences.weights[at]} * transform_point(palette, glm::dvec3(*nearest));
    }
  return out;
}

void expect_round_trip(const char* format, bool is_fbx, double bound) {
  Assimp::Exporter exporter;
  const aiExportDataBlob* blob = exporter.ExportToBlob(make_scene().get(), format);
  ASSERT_NE(blob, nullptr) << exporter.GetErrorString();
  FormatOptions options;
  options.metres_per_unit = 1.0;
  ModelDraft draft;
  ImportedFormat summary;
  const auto fault =
      add_scene_file({static_cast<const std::byte*>(blob->data), blob->size}, is_fbx, format, options, draft, summary);
  ASSERT_FALSE(fault) << fault->detail;
  const auto bytes = draft.finish(format, summary.warnings);
  ASSERT_TRUE(bytes) << describe(format, bytes.error().issue);
  const auto file = import_gltf(*bytes, format);
  ASSERT_TRUE(file);
  const Scene& scene = file->scene;
  ASSERT_EQ(scene.animations.size(), 1u);
  EXPECT_NEAR(scene.animations[0].duration_s, kTimes_s.back(), 1e-3);
  EXPECT_EQ(scene.meshes.at(0).primitives.at(0).vertex_count(), 3 * kRings);
  double worst = 0.0;
  for (int i = 0; i <= 40; ++i) {
    const double time_s = 0.05 * i;
    const auto exact = source_pose(time_s), world = test::world_pose(scene, 0, time_s);
    for (std::size_t j = 0; j < 3; ++j) {
      const auto joint = scene.skeleton.find(kNames[j]);
      ASSERT_TRUE(joint) << kNames[j];
      worst = std::max(worst, test::distance(world[scene.skeleton.node_of_joint[*joint]], exact[j]));
    }
    for (unsigned v = 0; v < 3 * kRings; ++v) {
      double off = 0.0;
      worst = std::max(worst, test::distance(skinned(scene, vertex(v), world, off), source_vertex(v, exact)));
      EXPECT_LE(off, 1e-5);
    }
  }
  EXPECT_LE(worst, bound);
  testing::Test::RecordProperty("worst", std::to_string(worst));
}

// Exporters write six or seven digits, and FBX angles in place of rotations.
TEST(scene_round_trip, collada) { expect_round_trip("collada", false, 2e-6); }
TEST(scene_round_trip, fbx) { expect_round_trip("fbxa", true, 2e-5); }

TEST(scene_round_trip, keys_outside_of_the_clip_are_cut_and_the_curve_stays) {
  const auto source = make_scene();
  aiAnimation& animation = *source->mAnimations[0];
  animation.mDuration = 1.0;  // from key time 0.25 to 1.25
  for (unsigned j = 0; j < 3; ++j)
    for (unsigned k = 0; k < kTimes_s.size(); ++k)
      for (double* time :
           {&animation.mChannels[j]->mPositionKeys[k].mTime, &animation.mChannels[j]->mRotationKeys[k].mTime,
            &animation.mChannels[j]->mScalingKeys[k].mTime})
        *time -= 0.25;
  ModelDraft draft;
  ImportedFormat summary;
  SceneDraft scene{*source, draft, summary, true, 1.0, fold_joints(*source->mRootNode), {}, {}, {}, {}};
  for (const FoldedJoint& joint : scene.joints) {
    const Affined rest = matrix_of(joint.node->mTransformation);
    const int parent = joint.parent == FoldedJoint::kNoParent ? -1 : scene.node_of_joint[joint.parent];
    scene.node_of_joint.push_back(draft.add_node(text_of(joint.node->mName), parent, translation_of(rest)));
  }
  add_animations(scene);
  const auto bytes = draft.finish("cut", summary.warnings);
  ASSERT_TRUE(bytes) << describe("cut", bytes.error().issue);
  const auto file = import_gltf(*bytes, "cut");
  ASSERT_TRUE(file);
  EXPECT_TRUE(file->warnings.empty());
  EXPECT_EQ(file->scene.animations.at(0).duration_s, 1.0);
  for (const double time_s : {0.0, 0.1, 0.5, 1.0}) {
    const auto exact = source_pose(time_s + 0.25), world = test::world_pose(file->scene, 0, time_s);
    EXPECT_TRUE(test::is_near(world.back(), exact.back(), 1e-5)) << time_s;
  }
}

}  // namespace
}  // namespace sinew::formats
