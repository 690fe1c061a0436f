// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "runtime/jobs/joint_palette.h"
#include "runtime/jobs/local_to_model.h"
#include "runtime/jobs/morph_vertices.h"
#include "runtime/jobs/sample_clip.h"
#include "runtime/jobs/skin_center_of_rotation.h"
#include "runtime/jobs/skin_dual_quaternion.h"
#include "runtime/jobs/skin_linear.h"
#include "runtime/plan/sign_pairs.h"
#include "tests/bench/glm_skin.h"
#include "tests/bench/measure.h"
#include "tests/bench/slower_variants.h"
#include "tests/bench/stream.h"
#include "tests/reference/skinning.h"
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
  std::vector<JointPair> pairs;
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
    pairs = sharing_pairs(primitive.influences, palette.size());
    run(SplitPaletteJob{palette, split, &any_stretch, sign_edges(skeleton, skin)});
    for (const JointMatrix& m : palette) glm_palette.push_back(mat4_from_affine(affine_from(m)));
    for (const RigidStretch& s : split) glm_rigid.push_back({s.rigid.real, s.rigid.dual});
  }

  VertexInput in(glm_skin::Attributes wanted) const {
    return {primitive.positions, wanted.normals ? std::span(primitive.normals) : std::span<const glm::vec3>(),
            wanted.tangents ? std::span(primitive.tangents) : std::span<const glm::vec4>()};
  }
  VertexOutput output() { return {out.positions, out.normals, out.tangents}; }

  /// Bytes that one vertex takes in, and that it gives.
  std::size_t bytes_in(glm_skin::Attributes wanted) const {
    return bytes_out(wanted) + primitive.influences.groups[0].influence_count * (sizeof(float) + sizeof(std::uint16_t));
  }
  static std::size_t bytes_out(glm_skin::Attributes wanted) {
    return sizeof(glm::vec3) + (wanted.normals ? sizeof(glm::vec3) : 0) + (wanted.tangents ? sizeof(glm::vec4) : 0);
  }

  /// Largest distance in metres of the last output from double precision, over a thousandth of the vertices at least.
  double error_m(bool dual_quaternions) const {
    const InfluenceGroup& group = primitive.influences.groups[0];
    double worst = 0.0;
    for (std::size_t v = 0; v < primitive.vertex_count(); v += 1 + primitive.vertex_count() / 5000) {
      std::vector<DualQuatd> motions;
      std::vector<Affined> matrices;
      std::vector<double> weights;
      for (std::size_t i = 0; i < group.influence_count; ++i) {
        const std::size_t at = v * group.influence_count + i, joint = primitive.influences.joints[at];
        motions.push_back({quat_cast<double>(split[joint].rigid.real), quat_cast<double>(split[joint].rigid.dual)});
        matrices.push_back(affine_cast<double>(affine_from(palette[joint])));
        weights.push_back(static_cast<double>(primitive.influences.weights[at]));
      }
      const Vec3<double> p(primitive.positions[v]), n(primitive.normals[v]);
      const Vec3<double> truth = dual_quaternions ? reference::skin_dual_quaternion<double>(motions, {}, weights, p, n).position
                                                  : reference::skin_linear<double>(matrices, weights, p);
      const Vec3<double> d = Vec3<double>(out.positions[v]) - truth;
      worst = std::max(worst, std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z));
    }
    return worst;
  }
};

struct Kind {
  const char* name;
  glm_skin::Attributes wanted;
};

/// Adds one implementation with its error, measured here.
template <class Work>
void add_with_error(const std::string& name, const std::shared_ptr<Surface>& s, glm_skin::Attributes wanted, bool dual_quaternions, Work work) {
  work();
  const std::size_t count = s->primitive.vertex_count();
  add(name, count, std::move(work), {s->error_m(dual_quaternions), count * (s->bytes_in(wanted) + Surface::bytes_out(wanted))});
}

void add_skin_case(const std::shared_ptr<Surface>& s, const Kind& kind, const std::string& tail) {
  const auto wanted = kind.wanted;
  const std::size_t count = s->primitive.vertex_count();
  add_with_error("skin_linear/sinew/" + tail, s, wanted, false, [s, wanted] {
    run(SkinLinearJob{&s->primitive.influences, s->palette, s->in(wanted), s->output(), NormalRule::linear});
  });
  add_with_error("skin_linear/glm/" + tail, s, wanted, false, [s, wanted] {
    glm_skin::skin_linear(s->primitive.influences, s->glm_palette, s->in(wanted), s->output(), wanted);
  });
  add_with_error("skin_dual_quaternion/sinew/" + tail, s, wanted, true, [s, wanted] {
    run(SkinDualQuaternionJob{&s->primitive.influences, s->split, s->any_stretch, s->in(wanted), s->output(), s->pairs});
  });
  add_with_error("skin_dual_quaternion/glm/" + tail, s, wanted, true, [s, wanted] {
    glm_skin::skin_dual_quaternion(s->primitive.influences, s->glm_rigid, s->in(wanted), s->output(), wanted);
  });
  add_with_error("skin_dual_quaternion/signs_by_vertex/" + tail, s, wanted, true, [s, wanted] {
    run(SkinDualQuaternionJob{&s->primitive.influences, s->split, s->any_stretch, s->in(wanted), s->output(), {}});
  });
  const auto traffic = std::make_shared<StreamTraffic>(count * s->bytes_in(wanted), count * Surface::bytes_out(wanted));
  add("skin_linear/stream/" + tail, count, [traffic] { traffic->run(); }, {Facts{}.error, traffic->bytes()});
  if (wanted.tangents || !wanted.normals) return;
  add_with_error("skin_linear/vertexwise/" + tail, s, wanted, false, [s, wanted] {
    vertexwise_linear(s->primitive.influences, s->palette, s->in(wanted), s->output());
  });
  add_with_error("skin_dual_quaternion/vertexwise/" + tail, s, wanted, true, [s, wanted] {
    vertexwise_dual_quaternion(s->primitive.influences, s->split, s->in(wanted), s->output());
  });
}


/// Both ways of one case; a center lies a little below its vertex.
void add_center_of_rotation_case(const std::shared_ptr<Surface>& s, const std::string& tail) {
  const auto centers = std::make_shared<std::vector<glm::vec3>>(s->primitive.positions);
  for (std::size_t v = 0; v < centers->size(); ++v) (*centers)[v] -= 0.03f * s->primitive.normals[v];
  const std::size_t count = s->primitive.vertex_count();
  add("skin_center_of_rotation/sinew/" + tail, count, [s, centers] {
    run(SkinCenterOfRotationJob{&s->primitive.influences, s->palette, s->split, s->any_stretch, *centers, s->in({true, false}), s->output()});
  });
  add("skin_center_of_rotation/glm/" + tail, count, [s, centers] {
    glm_skin::skin_center_of_rotation(s->primitive.influences, s->glm_palette, s->glm_rigid, *centers, s->in({true, false}), s->output());
  });
}

}  // namespace

void add_skin(std::size_t most_vertices) {
  const Kind kinds[] = {{"P", {}}, {"PN", {true, false}}, {"PNT", {true, true}}};
  const std::pair<const char*, std::uint32_t> sizes[] = {{"10k", 10'000}, {"1M", 1'000'000}};
  for (const auto& [label, count] : sizes)
    for (const std::uint32_t influences : {1u, 2u, 4u, 8u}) {
      if (count > most_vertices || (count > 10'000 && influences != 4)) continue;
      const auto surface = std::make_shared<Surface>(count, influences);
      if (influences == 4) add_center_of_rotation_case(surface, "PN/4/" + std::string(label));
      for (const Kind& kind : kinds) add_skin_case(surface, kind, std::string(kind.name) + "/" + std::to_string(influences) + "/" + label);
    }
}

void add_morph() {
  struct Face {
    Primitive primitive = scenes::face(10'000, 16);
    Deformed out{10'000};

    /// Largest distance in metres of the last output from double precision.
    double error_m(const std::vector<float>& weights) const {
      std::vector<Vec3<double>> truth(primitive.positions.begin(), primitive.positions.end());
      for (std::size_t t = 0; t < weights.size(); ++t) {
        const SparseDeltas<glm::vec3>& moved = primitive.morphs.targets[t].positions;
        for (std::size_t i = 0; i < moved.vertices.size(); ++i) truth[moved.vertices[i]] += static_cast<double>(weights[t]) * Vec3<double>(moved.deltas[i]);
      }
      double worst = 0.0;
      for (std::size_t v = 0; v < truth.size(); ++v) worst = std::max(worst, glm::length(Vec3<double>(out.positions[v]) - truth[v]));
      return worst;
    }
  };
  const auto f = std::make_shared<Face>();
  const auto in = [f] { return VertexInput{f->primitive.positions, f->primitive.normals, {}}; };
  const auto out = [f] { return VertexOutput{f->out.positions, f->out.normals, {}}; };
  for (const std::size_t active : {std::size_t{0}, std::size_t{1}, std::size_t{4}, std::size_t{16}}) {
    std::vector<float> weights(16, 0.0f);
    std::fill_n(weights.begin(), active, 0.4f);
    const std::string tail = "PN/16targets/" + std::to_string(active) + "active/10k";
    const auto add_measured = [&](const char* implementation, auto work) {
      work();
      add(std::string("morph/") + implementation + "/" + tail, 10'000, work, {f->error_m(weights), 0});
    };
    add_measured("sinew", [=] { run(MorphVerticesJob{&f->primitive.morphs, weights, in(), out(), f->out.scratch, true}); });
    add_measured("glm", [=] { glm_skin::morph(f->primitive.morphs, weights, in(), out()); });
  }
}

}  // namespace sinew::bench
