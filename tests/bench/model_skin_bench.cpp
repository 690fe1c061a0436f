// SPDX-License-Identifier: MIT
// Linear-blend skinning of whole models. Their vertices share combinations of joints and weights: the cases say how
// much that saves.
#include <cstdlib>
#include <cstring>

#include "runtime/deform/skin_linear.h"
#include "runtime/pose/joint_palette.h"
#include "runtime/pose/local_to_model.h"
#include "runtime/pose/sample_clip.h"
#include "tests/bench/clip_characters.h"
#include "tests/bench/combinations.h"
#include "tests/bench/glm_skin.h"
#include "tests/bench/measure.h"
#include "tests/support/tiny_assets.h"

namespace sinew::bench {
namespace {

/// One skinned primitive in a pose.
struct Skinned {
  const Primitive* primitive;
  std::uint32_t skin;
  Combinations combinations;
  std::vector<glm::vec3> positions, normals;

  Skinned(const Primitive& p, std::uint32_t skin_index, std::size_t joint_count)
      : primitive(&p),
        skin(skin_index),
        combinations(p.influences, joint_count),
        positions(p.vertex_count()),
        normals(p.vertex_count()) {}
};

struct PosedModel {
  std::shared_ptr<const Scene> scene;
  std::vector<std::vector<JointMatrix>> palettes;
  std::vector<std::vector<glm::mat4>> glm_palettes;
  std::vector<Skinned> parts;
  std::size_t vertex_count = 0;
  bool normals = true;

  explicit PosedModel(std::shared_ptr<const Scene> shown) : scene(std::move(shown)) {
    const std::size_t joints = scene->skeleton.joint_count();
    test::PoseBuffer pose(joints);
    std::vector<Affine> model(joints);
    run(SampleClipJob{
        .clip = &scene->clips[0], .time_s = 0.4 * scene->animations[0].duration_s, .pose = pose.span(), .weights = {}});
    run(LocalToModelJob{.skeleton = &scene->skeleton, .local = pose.span(), .root = {}, .model = model});
    for (const Skin& skin : scene->skins) {
      run(JointPaletteJob{&skin, model, palettes.emplace_back(skin.joints.size())});
      glm_palettes.emplace_back();
      for (const JointMatrix& m : palettes.back()) glm_palettes.back().push_back(mat4_from_affine(affine_from(m)));
    }
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

  void skin() {
    for (Skinned& s : parts)
      run(SkinLinearJob{&s.primitive->influences, palettes[s.skin], in(s), out(s), NormalRule::linear});
  }
  void skin_by_combination() {
    for (Skinned& s : parts) s.combinations.skin(palettes[s.skin], in(s), out(s));
  }
  void skin_glm() {
    for (Skinned& s : parts)
      glm_skin::skin_linear(s.primitive->influences, glm_palettes[s.skin], in(s), out(s), {normals, false});
  }
};

/// The variant must give the bits of the kernel.
void require_same(PosedModel& model) {
  model.skin();
  std::vector<std::vector<glm::vec3>> expected;
  for (const Skinned& s : model.parts) expected.push_back(s.positions);
  model.skin_by_combination();
  for (std::size_t p = 0; p < expected.size(); ++p)
    if (std::memcmp(expected[p].data(), model.parts[p].positions.data(), expected[p].size() * sizeof(glm::vec3)) != 0)
      std::abort();
}

}  // namespace

void add_model_skin() {
  for (const NamedScene& named : corpus_scenes()) {
    const auto model = std::make_shared<PosedModel>(named.scene);
    require_same(*model);
    add("skin_linear/sinew/" + named.name, model->vertex_count, [model] { model->skin(); });
    add("skin_linear/combinations/" + named.name, model->vertex_count, [model] { model->skin_by_combination(); });
    add("skin_linear/glm/" + named.name, model->vertex_count, [model] { model->skin_glm(); });
  }
}

}  // namespace sinew::bench
