// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "runtime/deform/morph_vertices.h"
#include "runtime/deform/skin_center_of_rotation.h"
#include "runtime/deform/skin_dual_quaternion.h"
#include "runtime/deform/skin_linear.h"
#include "runtime/deform/skin_tiles.h"
#include "runtime/plan/needs.h"
#include "runtime/pose/hemisphere_pairs.h"
#include "runtime/pose/joint_palette.h"
#include "runtime/pose/local_to_model.h"
#include "runtime/pose/sample_clip.h"
#include "runtime/threads/default_executor.h"
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

/// Memory of deformed vertices.
struct Deformed {
  std::vector<glm::vec3> positions, normals, scratch;
  std::vector<glm::vec4> tangents;

  explicit Deformed(std::size_t count) : positions(count), normals(count), scratch(count), tangents(count) {}
};

/// A posed surface around a biped, with palettes for both implementations.
struct Surface {
  Primitive primitive;
  Deformed out;
  std::vector<JointMatrix> palette;
  std::vector<RigidStretch> split;
  bool any_stretch = false;
  std::vector<JointPair> pairs;
  std::vector<glm::mat4> glm_palette;
  std::vector<glm_skin::Rigid> glm_rigid;

  Surface(std::uint32_t vertex_count, std::uint32_t influence_count,
          scenes::VertexOrder order = scenes::VertexOrder::by_joints)
      : out(vertex_count) {
    const Skeleton skeleton = scenes::biped();
    const Clip clip = test::clip_of(scenes::swinging(skeleton, 60), skeleton);
    const Skin skin = scenes::skin_of_all_joints(skeleton);
    primitive = scenes::skinned_surface(skeleton, vertex_count, influence_count, order);
    test::PoseBuffer pose(skeleton.joint_count());
    std::vector<Affine> model(skeleton.joint_count());
    run_unchecked(SampleClipJob{.clip = &clip, .time_s = 0.77, .pose = pose.span(), .weights = {}});
    run_unchecked(LocalToModelJob{&skeleton, pose.span(), {}, model});
    palette.resize(skin.joints.size());
    split.resize(skin.joints.size());
    run_unchecked(JointPaletteJob{&skin, model, palette});
    pairs = joint_pairs_of_vertices(primitive.influences, palette.size());
    run_unchecked(SplitPaletteJob{palette, split, &any_stretch, hemisphere_edges(skeleton, skin)});
    for (const JointMatrix& m : palette) glm_palette.push_back(mat4_from_affine(affine_from(m)));
    for (const RigidStretch& s : split) glm_rigid.push_back({s.rigid.real, s.rigid.dual});
  }

  VertexInput in(glm_skin::Attributes wanted) const {
    return {primitive.positions, wanted.normals ? std::span(primitive.normals) : std::span<const glm::vec3>(),
            wanted.tangents ? std::span(primitive.tangents) : std::span<const glm::vec4>()};
  }
  VertexOutput output() { return {out.positions, out.normals, out.tangents}; }

  /// Bytes read and bytes written per vertex.
  std::size_t bytes_in(glm_skin::Attributes wanted) const {
    return bytes_out(wanted) + primitive.influences.groups[0].influence_count * (sizeof(float) + sizeof(std::uint16_t));
  }
  static std::size_t bytes_out(glm_skin::Attributes wanted) {
    return sizeof(glm::vec3) + (wanted.normals ? sizeof(glm::vec3) : 0) + (wanted.tangents ? sizeof(glm::vec4) : 0);
  }

  /// Centers of rotation, 3 cm below each vertex.
  std::vector<glm::vec3> centers() const {
    std::vector<glm::vec3> around = primitive.positions;
    for (std::size_t v = 0; v < around.size(); ++v) around[v] -= 0.03f * primitive.normals[v];
    return around;
  }

  /// Largest distance, in metres, of the last output from double precision, over at least a thousandth of the vertices.
  double error_m(Skinning kind) const {
    const std::vector<glm::vec3> around =
        kind == Skinning::center_of_rotation ? centers() : std::vector<glm::vec3>(primitive.vertex_count());
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
      const auto truth = [&]() -> Vec3<double> {
        switch (kind) {
          case Skinning::linear: return reference::skin_linear<double>(matrices, weights, p);
          case Skinning::dual_quaternion:
            return reference::skin_dual_quaternion<double>(motions, {}, weights, p, n).position;
          case Skinning::center_of_rotation: break;
        }
        return reference::skin_center_of_rotation<double>(motions, matrices, weights, p, n, Vec3<double>(around[v]))
            .position;
      };
      worst = std::max(worst, glm::length(Vec3<double>(out.positions[v]) - truth()));
    }
    return worst;
  }
};

/// Influences with joints and normalised weights in bytes, as most files have them.
struct Bytes {
  std::vector<InfluenceGroup> groups;
  std::vector<std::uint8_t> joints, weights;

  explicit Bytes(const VertexInfluences& from) : groups(from.groups), joints(from.joints.begin(), from.joints.end()) {
    for (const float w : from.weights) weights.push_back(static_cast<std::uint8_t>(std::lround(w * 255.0f)));
  }
  InfluenceStreams streams() const { return {groups, std::span(joints), std::span(weights)}; }
};

struct Kind {
  const char* name;
  glm_skin::Attributes wanted;
};

/// Adds one implementation, and measures its error now.
template <class Work>
void add_with_error(const std::string& name, const std::shared_ptr<Surface>& s, glm_skin::Attributes wanted,
                    Skinning kind, Work work) {
  work();
  const std::size_t count = s->primitive.vertex_count();
  add(name, count, std::move(work), {s->error_m(kind), count * (s->bytes_in(wanted) + Surface::bytes_out(wanted))});
}

void add_skin_case(const std::shared_ptr<Surface>& s, const Kind& kind, const std::string& tail) {
  const auto wanted = kind.wanted;
  const std::size_t count = s->primitive.vertex_count();
  add_with_error("skin_linear/sinew/" + tail, s, wanted, Skinning::linear, [s, wanted] {
    run_unchecked(SkinLinearJob{&s->primitive.influences, s->palette, s->in(wanted), s->output(), NormalRule::linear});
  });
  add_with_error("skin_linear/glm/" + tail, s, wanted, Skinning::linear, [s, wanted] {
    glm_skin::skin_linear(s->primitive.influences, s->glm_palette, s->in(wanted), s->output(), wanted);
  });
  add_with_error("skin_dual_quaternion/sinew/" + tail, s, wanted, Skinning::dual_quaternion, [s, wanted] {
    run_unchecked(SkinDualQuaternionJob{&s->primitive.influences, s->split, s->any_stretch, s->in(wanted), s->output(),
                                        s->pairs, s->palette});
  });
  add_with_error("skin_dual_quaternion/glm/" + tail, s, wanted, Skinning::dual_quaternion, [s, wanted] {
    glm_skin::skin_dual_quaternion(s->primitive.influences, s->glm_rigid, s->in(wanted), s->output(), wanted);
  });
  add_with_error("skin_dual_quaternion/signs_by_vertex/" + tail, s, wanted, Skinning::dual_quaternion, [s, wanted] {
    run_unchecked(
        SkinDualQuaternionJob{&s->primitive.influences, s->split, s->any_stretch, s->in(wanted), s->output(), {}});
  });
  const auto small = std::make_shared<Bytes>(s->primitive.influences);
  add_with_error("skin_linear/bytes/" + tail, s, wanted, Skinning::linear, [s, wanted, small] {
    run_unchecked(SkinLinearJob{small->streams(), s->palette, s->in(wanted), s->output(), NormalRule::linear});
  });
  const auto tiles = std::make_shared<VertexTiles>(tile_vertices(s->primitive.influences, s->in(wanted)));
  add_with_error("skin_linear/tiles/" + tail, s, wanted, Skinning::linear, [s, tiles] {
    run_unchecked(SkinTilesJob{.tiles = tiles.get(), .palette = s->palette, .out = s->output()});
  });
  add_with_error("skin_dual_quaternion/tiles/" + tail, s, wanted, Skinning::dual_quaternion, [s, wanted, tiles] {
    run_unchecked(SkinDualQuaternionJob{&s->primitive.influences, s->split, s->any_stretch, s->in(wanted), s->output(),
                                        s->pairs, s->palette, tiles.get()});
  });
  const auto traffic = std::make_shared<StreamTraffic>(count * s->bytes_in(wanted), count * Surface::bytes_out(wanted));
  add("skin_linear/stream/" + tail, count, [traffic] { traffic->run(); }, {Facts{}.error, traffic->bytes()});
  if (wanted.tangents || !wanted.normals) return;
  add_with_error("skin_linear/vertexwise/" + tail, s, wanted, Skinning::linear,
                 [s, wanted] { vertexwise_linear(s->primitive.influences, s->palette, s->in(wanted), s->output()); });
  add_with_error("skin_dual_quaternion/vertexwise/" + tail, s, wanted, Skinning::dual_quaternion, [s, wanted] {
    vertexwise_dual_quaternion(s->primitive.influences, s->split, s->in(wanted), s->output());
  });
}

/// Adds both implementations of one case.
void add_center_of_rotation_case(const std::shared_ptr<Surface>& s, const std::string& tail) {
  const auto centers = std::make_shared<std::vector<glm::vec3>>(s->centers());
  const glm_skin::Attributes wanted{true, false};
  add_with_error("skin_center_of_rotation/sinew/" + tail, s, wanted, Skinning::center_of_rotation,
                 [s, centers, wanted] {
                   run_unchecked(SkinCenterOfRotationJob{&s->primitive.influences, s->palette, s->split, s->any_stretch,
                                                         *centers, s->in(wanted), s->output(), s->pairs});
                 });
  const auto tiles = std::make_shared<VertexTiles>(tile_vertices(s->primitive.influences, s->in(wanted), *centers));
  add_with_error("skin_center_of_rotation/tiles/" + tail, s, wanted, Skinning::center_of_rotation,
                 [s, wanted, centers, tiles] {
                   run_unchecked(SkinCenterOfRotationJob{&s->primitive.influences, s->palette, s->split, s->any_stretch,
                                                         *centers, s->in(wanted), s->output(), s->pairs, tiles.get()});
                 });
  add_with_error("skin_center_of_rotation/glm/" + tail, s, wanted, Skinning::center_of_rotation, [s, centers, wanted] {
    glm_skin::skin_center_of_rotation(s->primitive.influences, s->glm_palette, s->glm_rigid, *centers, s->in(wanted),
                                      s->output());
  });
}

/// Splits the work into one range per thread: shows how much more memory bandwidth several cores have than one.
void add_threads_case(const std::string& tail, std::uint32_t vertex_count, std::size_t threads) {
  const auto parts = std::make_shared<std::vector<std::shared_ptr<Surface>>>();
  for (std::size_t t = 0; t < threads; ++t)
    parts->push_back(std::make_shared<Surface>(vertex_count / static_cast<std::uint32_t>(threads), 4u));
  const glm_skin::Attributes wanted{true, false};
  const auto each = [parts, threads](const auto& skin) {
    run_in_parallel(threads, [&](std::size_t t) { skin(*(*parts)[t]); });
  };
  const Surface& one = *parts->front();
  Facts facts{Facts{}.error, vertex_count * (one.bytes_in(wanted) + Surface::bytes_out(wanted))};
  facts.wall_time = true;
  add(
      "skin_linear/sinew/" + tail, vertex_count,
      [each, wanted] {
        each([&](Surface& s) {
          run_unchecked(
              SkinLinearJob{&s.primitive.influences, s.palette, s.in(wanted), s.output(), NormalRule::linear});
        });
      },
      facts);
  add(
      "skin_linear/glm/" + tail, vertex_count,
      [each, wanted] {
        each([&](Surface& s) {
          glm_skin::skin_linear(s.primitive.influences, s.glm_palette, s.in(wanted), s.output(), wanted);
        });
      },
      facts);
}

/// Characters that run in turn. Their vertices together exceed the caches, so each one is cold at its turn.
void add_cold_case(const std::string& tail, std::uint32_t vertex_count) {
  struct Turns {
    std::vector<Surface> characters;
    std::size_t now = 0;
    Surface& next() { return characters[now++ % characters.size()]; }
  };
  constexpr std::size_t kCharacters = 64;
  const auto turns = std::make_shared<Turns>();
  turns->characters.assign(kCharacters, Surface(vertex_count, 4u));
  const glm_skin::Attributes wanted{true, false};
  const Surface& one = turns->characters.front();
  const Facts facts{Facts{}.error, vertex_count * (one.bytes_in(wanted) + Surface::bytes_out(wanted))};
  add(
      "skin_linear/sinew/" + tail, vertex_count,
      [turns, wanted] {
        Surface& s = turns->next();
        run_unchecked(SkinLinearJob{&s.primitive.influences, s.palette, s.in(wanted), s.output(), NormalRule::linear});
      },
      facts);
  add(
      "skin_linear/glm/" + tail, vertex_count,
      [turns, wanted] {
        Surface& s = turns->next();
        glm_skin::skin_linear(s.primitive.influences, s.glm_palette, s.in(wanted), s.output(), wanted);
      },
      facts);
}

}  // namespace

void add_skin(std::size_t most_vertices) {
  const Kind kinds[] = {{"P", {}}, {"PN", {true, false}}, {"PNT", {true, true}}};
  for (const std::uint32_t influences : {1u, 2u, 4u, 8u}) {
    const auto surface = std::make_shared<Surface>(10'000, influences);
    if (influences == 4) add_center_of_rotation_case(surface, "PN/4/10k");
    for (const Kind& kind : kinds)
      add_skin_case(surface, kind, std::string(kind.name) + "/" + std::to_string(influences) + "/10k");
  }
  const auto mixed = std::make_shared<Surface>(10'000, 4u, scenes::VertexOrder::in_turns);
  add_skin_case(mixed, kinds[1], "PN/4/10k/mixed");
  add_center_of_rotation_case(mixed, "PN/4/10k/mixed");
  // Sizes from the nearest cache up to memory.
  for (const auto& [label, count] : {std::pair{"300", 300u}, {"1k", 1'000u}, {"100k", 100'000u}, {"1M", 1'000'000u}}) {
    if (count > most_vertices) continue;
    const auto surface = std::make_shared<Surface>(count, 4u);
    add_center_of_rotation_case(surface, "PN/4/" + std::string(label));
    for (const Kind& kind : kinds)
      if (count == 1'000'000 || &kind == &kinds[1])
        add_skin_case(surface, kind, std::string(kind.name) + "/4/" + label);
  }
  if (most_vertices >= 100'000) add_cold_case("PN/4/10k/cold", 10'000);
  for (const std::size_t threads : thread_counts())
    if (most_vertices >= 1'000'000)
      add_threads_case("PN/4/1M/" + std::to_string(threads) + "threads", 1'000'000, threads);
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
        for (std::size_t i = 0; i < moved.vertices.size(); ++i)
          truth[moved.vertices[i]] += static_cast<double>(weights[t]) * Vec3<double>(moved.deltas[i]);
      }
      double worst = 0.0;
      for (std::size_t v = 0; v < truth.size(); ++v)
        worst = std::max(worst, glm::length(Vec3<double>(out.positions[v]) - truth[v]));
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
    add_measured("sinew", [=] {
      run_unchecked(MorphVerticesJob{&f->primitive.morphs, weights, in(), out(), f->out.scratch, true});
    });
    add_measured("glm", [=] { glm_skin::morph(f->primitive.morphs, weights, in(), out()); });
  }
}

}  // namespace sinew::bench
