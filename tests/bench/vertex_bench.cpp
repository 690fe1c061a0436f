// SPDX-License-Identifier: MIT
#include "runtime/jobs/joint_palette.h"
#include "runtime/jobs/local_to_model.h"
#include "runtime/jobs/morph_vertices.h"
#include "runtime/jobs/sample_clip.h"
#include "runtime/jobs/skin_dual_quaternion.h"
#include "runtime/jobs/skin_linear.h"
#include "tests/bench/glm_skin.h"
#include "tests/bench/measure.h"
#include "tests/scenes/face.h"
#include "tests/scenes/skeletons.h"
#include "tests/scenes/skinned_surface.h"
#include "tests/scenes/swinging.h"
#include "tests/support/tiny_assets.h"

namespace sinew::bench {
namespace {

/// Room for deformed vertices.
struct Deformed {
  std::vector<glm::vec3> positions, normals, scratch;
  std::vector<glm::vec4> tangents;

  explicit Deformed(std::size_t count) : positions(count), normals(count), scratch(count), tangents(count) {}
};

/// A posed surface over a biped, its palettes for both implementations.
struct Surface {
  Primitive primitive;
  Deformed out;
  std::vector<JointMatrix> palette;
  std::vector<RigidStretch> split;
  bool any_stretch = false;
  std::vector<glm::mat4> glm_palette;
  std::vector<glm_skin::Rigid> glm_rigid;

  Surface(std::uint32_t vertex_count, std::uint32_t influence_count) : out(vertex_count) {
    const Skeleton skeleton = scenes::biped();
    const Clip clip = test::clip_of(scenes::swinging(skeleton, 60), skeleton);
    const Skin skin = scenes::skin_of_all_joints(skeleton);
    primitive = scenes::skinned_surface(skeleton, vertex_count, influence_count);
    test::PoseBuffer pose(skeleton.joint_count());
    std::vector<Affine> model(skeleton.joint_count());
    run(SampleClipJob{.clip = &clip, .time_s = 0.77, .pose = pose.span(), .weights = {}});
    run(LocalToModelJob{&skeleton, pose.span(), {}, model});
    palette.resize(skin.joints.size());
    split.resize(skin.joints.size());
    run(JointPaletteJob{&skin, model, palette});
    run(SplitPaletteJob{palette, split, &any_stretch});
    for (const JointMatrix& m : palette) glm_palette.push_back(mat4_from_affine(affine_from(m)));
    for (const RigidStretch& s : split) glm_rigid.push_back({s.rigid.real, s.rigid.dual});
  }

  VertexInput in(glm_skin::Attributes wanted) const {
    return {primitive.positions, wanted.normals ? std::span(primitive.normals) : std::span<const glm::vec3>(),
            wanted.tangents ? std::span(primitive.tangents) : std::span<const glm::vec4>()};
  }
  VertexOutput output() { return {out.positions, out.normals, out.tangents}; }
};

struct Kind {
  const char* name;
  glm_skin::Attributes wanted;
};

void add_skin_case(const std::shared_ptr<Surface>& s, const Kind& kind, const std::string& tail) {
  const std::size_t count = s->primitive.vertex_count();
  const auto wanted = kind.wanted;
  add("skin_linear/sinew/" + tail, count, [s, wanted] {
    run(SkinLinearJob{&s->primitive.influences, s->palette, s->in(wanted), s->output(), NormalRule::linear});
  });
  add("skin_linear/glm/" + tail, count, [s, wanted] {
    glm_skin::skin_linear(s->primitive.influences, s->glm_palette, s->in(wanted), s->output(), wanted);
  });
  add("skin_dual_quaternion/sinew/" + tail, count, [s, wanted] {
    run(SkinDualQuaternionJob{&s->primitive.influences, s->split, s->any_stretch, s->in(wanted), s->output()});
  });
  add("skin_dual_quaternion/glm/" + tail, count, [s, wanted] {
    glm_skin::skin_dual_quaternion(s->primitive.influences, s->glm_rigid, s->in(wanted), s->output(), wanted);
  });
}

}  // namespace

void add_skin() {
  const Kind kinds[] = {{"P", {}}, {"PN", {true, false}}, {"PNT", {true, true}}};
  const std::pair<const char*, std::uint32_t> sizes[] = {{"10k", 10'000}, {"1M", 1'000'000}};
  for (const auto& [label, count] : sizes)
    for (const std::uint32_t influences : {1u, 4u}) {
      if (count > 10'000 && influences == 1) continue;
      const auto surface = std::make_shared<Surface>(count, influences);
      for (const Kind& kind : kinds) add_skin_case(surface, kind, std::string(kind.name) + "/" + std::to_string(influences) + "/" + label);
    }
}

void add_morph() {
  struct Face {
    Primitive primitive = scenes::face(10'000, 16);
    Deformed out{10'000};
  };
  const auto f = std::make_shared<Face>();
  for (const std::size_t active : {std::size_t{0}, std::size_t{1}, std::size_t{4}, std::size_t{16}}) {
    std::vector<float> weights(16, 0.0f);
    std::fill_n(weights.begin(), active, 0.4f);
    const std::string tail = "PN/16targets/" + std::to_string(active) + "active/10k";
    const auto in = [f] { return VertexInput{f->primitive.positions, f->primitive.normals, {}}; };
    const auto out = [f] { return VertexOutput{f->out.positions, f->out.normals, {}}; };
    add("morph/sinew/" + tail, 10'000, [=] {
      run(MorphVerticesJob{&f->primitive.morphs, weights, in(), out(), f->out.scratch, true});
    });
    add("morph/glm/" + tail, 10'000, [=] { glm_skin::morph(f->primitive.morphs, weights, in(), out()); });
  }
}

}  // namespace sinew::bench
