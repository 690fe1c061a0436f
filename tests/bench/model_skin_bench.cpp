// SPDX-License-Identifier: MIT
// Every skinning method on every skinned model of the corpus. Times of the rigid methods include splitting the joint
// matrices, which they need in each frame. Linear blending is measured twice: as usual, and with one matrix for all
// vertices of the same joints and weights. The difference is what sharing saves.
#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "importer/import_gltf.h"
#include "runtime/deform/skin_center_of_rotation.h"
#include "runtime/deform/skin_dual_quaternion.h"
#include "runtime/deform/skin_linear.h"
#include "runtime/pose/hemisphere_pairs.h"
#include "runtime/pose/joint_palette.h"
#include "runtime/pose/local_to_model.h"
#include "runtime/pose/sample_clip.h"
#include "tests/bench/clip_characters.h"
#include "tests/bench/combinations.h"
#include "tests/bench/glm_skin.h"
#include "tests/bench/measure.h"
#include "tests/support/corpus.h"
#include "tests/support/tiny_assets.h"

namespace sinew::bench {
namespace {

/// One skin in a pose, for all skinning methods.
struct PosedSkin {
  std::vector<JointMatrix> palette;
  std::vector<JointPair> edges;
  std::vector<RigidStretch> split;
  bool any_stretch = false;
  std::vector<glm::mat4> glm_palette;
  std::vector<glm_skin::Rigid> glm_rigid;

  PosedSkin(const Skeleton& skeleton, const Skin& skin, std::span<const Affine> model)
      : palette(skin.joints.size()),
        edges(hemisphere_edges(skeleton, skin)),
        split(palette.size()),
        glm_rigid(palette.size()) {
    run_unchecked(JointPaletteJob{&skin, model, palette});
    for (const JointMatrix& m : palette) glm_palette.push_back(mat4_from_affine(affine_from(m)));
  }
  void split_palette() { run_unchecked(SplitPaletteJob{palette, split, &any_stretch, edges}); }
  /// Splits matrices into rigid parts. Plain code ignores stretch.
  void split_glm() {
    for (std::size_t j = 0; j < glm_palette.size(); ++j) {
      const glm::mat4& m = glm_palette[j];
      const glm::quat real = glm::normalize(glm::quat_cast(glm::mat3(m)));
      glm_rigid[j] = {real, glm::quat(0.0f, m[3].x, m[3].y, m[3].z) * real * 0.5f};
    }
  }
};

/// One skinned primitive in a pose.
struct Skinned {
  const Primitive* primitive;
  std::uint32_t skin;
  Combinations combinations;
  std::vector<JointPair> pairs;
  std::vector<glm::vec3> centers;  ///< near the vertices; times do not depend on their exact place
  std::vector<glm::vec3> positions, normals;

  Skinned(const Primitive& p, std::uint32_t skin_index, std::size_t joint_count)
      : primitive(&p),
        skin(skin_index),
        combinations(p.influences, joint_count),
        pairs(joint_pairs_of_vertices(p.influences, joint_count)),
        centers(p.positions),
        positions(p.vertex_count()),
        normals(p.vertex_count()) {
    for (glm::vec3& c : centers) c *= 0.97f;
  }
};

struct PosedModel {
  std::shared_ptr<const Scene> scene;
  std::vector<PosedSkin> skins;
  std::vector<Skinned> parts;
  std::size_t vertex_count = 0;
  bool normals = true;

  explicit PosedModel(std::shared_ptr<const Scene> shown) : scene(std::move(shown)) {
    const std::size_t joints = scene->skeleton.joint_count();
    test::PoseBuffer pose(joints);
    std::vector<Affine> model(joints);
    const Clip clip = scene->clips.empty() ? test::clip_of({}, scene->skeleton) : scene->clips[0];
    const double time_s = scene->animations.empty() ? 0.0 : 0.4 * scene->animations[0].duration_s;
    run_unchecked(SampleClipJob{.clip = &clip, .time_s = time_s, .pose = pose.span(), .weights = {}});
    run_unchecked(LocalToModelJob{.skeleton = &scene->skeleton, .local = pose.span(), .root = {}, .model = model});
    for (const Skin& skin : scene->skins) skins.emplace_back(scene->skeleton, skin, model);
    for (const MeshInstance& instance : scene->instances)
      for (const Primitive& p : scene->meshes[instance.mesh].primitives) {
        if (instance.skin == kNone || p.influences.empty()) continue;
        parts.emplace_back(p, instance.skin, scene->skins[instance.skin].joints.size());
        vertex_count += p.vertex_count();
        normals = normals && !p.flat_normals;
      }
  }

  VertexInput in(const Skinned& s) const {
    return {s.primitive->positions,
            normals ? std::span<const glm::vec3>(s.primitive->normals) : std::span<const glm::vec3>(),
            {}};
  }
  static VertexOutput out(Skinned& s) { return {s.positions, s.normals, {}}; }

  void skin_linear() {
    for (Skinned& s : parts)
      run_unchecked(SkinLinearJob{&s.primitive->influences, skins[s.skin].palette, in(s), out(s), NormalRule::linear});
  }
  void skin_by_combination() {
    for (Skinned& s : parts) s.combinations.skin(skins[s.skin].palette, in(s), out(s));
  }
  void skin_dual_quaternion() {
    for (PosedSkin& skin : skins) skin.split_palette();
    for (Skinned& s : parts) {
      const PosedSkin& skin = skins[s.skin];
      run_unchecked(SkinDualQuaternionJob{&s.primitive->influences, skin.split, skin.any_stretch, in(s), out(s),
                                          s.pairs, skin.palette});
    }
  }
  void skin_center_of_rotation() {
    for (PosedSkin& skin : skins) skin.split_palette();
    for (Skinned& s : parts) {
      const PosedSkin& skin = skins[s.skin];
      run_unchecked(SkinCenterOfRotationJob{&s.primitive->influences, skin.palette, skin.split, skin.any_stretch,
                                            s.centers, in(s), out(s), s.pairs});
    }
  }
  void skin_glm_linear() {
    for (Skinned& s : parts)
      glm_skin::skin_linear(s.primitive->influences, skins[s.skin].glm_palette, in(s), out(s), {normals, false});
  }
  void skin_glm_dual_quaternion() {
    for (PosedSkin& skin : skins) skin.split_glm();
    for (Skinned& s : parts)
      glm_skin::skin_dual_quaternion(s.primitive->influences, skins[s.skin].glm_rigid, in(s), out(s), {normals, false});
  }
  void skin_glm_center_of_rotation() {
    for (PosedSkin& skin : skins) skin.split_glm();
    for (Skinned& s : parts)
      glm_skin::skin_center_of_rotation(s.primitive->influences, skins[s.skin].glm_palette, skins[s.skin].glm_rigid,
                                        s.centers, in(s), out(s));
  }
};

/// Fails unless the variant gives the bits of the kernel.
void require_same(PosedModel& model) {
  model.skin_linear();
  std::vector<std::vector<glm::vec3>> expected;
  for (const Skinned& s : model.parts) expected.push_back(s.positions);
  model.skin_by_combination();
  for (std::size_t p = 0; p < expected.size(); ++p)
    if (std::memcmp(expected[p].data(), model.parts[p].positions.data(), expected[p].size() * sizeof(glm::vec3)) != 0)
      std::abort();
}

/// All models of the corpus with skinned vertices, each in one encoding. A folder NAME-ENCODING holds the model of the
/// folder NAME again.
std::vector<NamedScene> skinned_scenes() {
  std::vector<NamedScene> found;
  if (!test::corpus()) return found;
  for (const auto& path : test::corpus_files("models", {".glb", ".gltf"})) {
    const std::string name = path.parent_path().filename().string();
    const std::string shorter = name.substr(0, name.rfind('-'));
    const bool is_there = std::any_of(found.begin(), found.end(),
                                      [&](const NamedScene& s) { return s.name == name || s.name == shorter; });
    if (is_there) continue;
    auto file = import_gltf(path, {.decode_images = false});
    if (!file || file->scene.skins.empty()) continue;
    found.push_back({name, std::make_shared<const Scene>(std::move(file->scene))});
  }
  return found;
}

}  // namespace

void add_model_skin() {
  for (const NamedScene& named : skinned_scenes()) {
    const auto model = std::make_shared<PosedModel>(named.scene);
    if (model->vertex_count == 0) continue;
    require_same(*model);
    const auto add_case = [&](const std::string& job, void (PosedModel::*work)()) {
      add(job + "/" + named.name, model->vertex_count, [model, work] { ((*model).*work)(); });
    };
    add_case("skin_linear/sinew", &PosedModel::skin_linear);
    add_case("skin_linear/combinations", &PosedModel::skin_by_combination);
    add_case("skin_linear/glm", &PosedModel::skin_glm_linear);
    add_case("skin_dual_quaternion/sinew", &PosedModel::skin_dual_quaternion);
    add_case("skin_dual_quaternion/glm", &PosedModel::skin_glm_dual_quaternion);
    add_case("skin_center_of_rotation/sinew", &PosedModel::skin_center_of_rotation);
    add_case("skin_center_of_rotation/glm", &PosedModel::skin_glm_center_of_rotation);
  }
}

}  // namespace sinew::bench
