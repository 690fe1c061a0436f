// SPDX-License-Identifier: MIT
// What frames do between matrices and vertices, and after them: palettes, their rigid parts, flat normals.
#include "importer/topology/flat_order.h"
#include "runtime/deform/flat_normals.h"
#include "runtime/pose/hemisphere_pairs.h"
#include "runtime/pose/joint_palette.h"
#include "runtime/pose/local_to_model.h"
#include "runtime/pose/sample_clip.h"
#include "tests/bench/measure.h"
#include "tests/scenes/skeletons.h"
#include "tests/scenes/skinned_surface.h"
#include "tests/scenes/swinging.h"
#include "tests/support/tiny_assets.h"

namespace sinew::bench {
namespace {

/// A posed biped, whose joints all stretch or are all rigid.
struct PosedBiped {
  Skeleton skeleton = scenes::biped();
  Skin skin = scenes::skin_of_all_joints(skeleton);
  std::vector<JointPair> follow = hemisphere_edges(skeleton, skin);
  std::vector<Affine> model = std::vector<Affine>(skeleton.joint_count());
  std::vector<JointMatrix> palette = std::vector<JointMatrix>(skin.joints.size());
  std::vector<RigidStretch> parts = std::vector<RigidStretch>(skin.joints.size());
  bool any_stretch = false;

  explicit PosedBiped(const glm::vec3& scale) {
    const Clip clip = test::clip_of(scenes::swinging(skeleton, 60), skeleton);
    test::PoseBuffer pose(skeleton.joint_count());
    run_unchecked(SampleClipJob{.clip = &clip, .time_s = 0.77, .pose = pose.span(), .weights = {}});
    Transform root = pose.span().get(0);
    root.scale = scale;
    pose.span().set(0, root);
    run_unchecked(LocalToModelJob{&skeleton, pose.span(), {}, model});
    make();
  }
  void make() { run_unchecked(JointPaletteJob{&skin, model, palette}); }
  void split() { run_unchecked(SplitPaletteJob{palette, parts, &any_stretch, follow}); }
};

}  // namespace

void add_palettes() {
  const auto rigid = std::make_shared<PosedBiped>(glm::vec3(1));
  const auto stretched = std::make_shared<PosedBiped>(glm::vec3(1, 1.2f, 0.9f));
  const std::size_t joints = rigid->skin.joints.size();
  add("joint_palette/sinew/biped67", joints, [rigid] { rigid->make(); });
  add("split_palette/sinew/biped67/rigid", joints, [rigid] { rigid->split(); });
  add("split_palette/sinew/biped67/stretched", joints, [stretched] { stretched->split(); });
}

void add_flat_normals() {
  constexpr std::uint32_t kTriangles = 4'000;
  Primitive ordered = scenes::skinned_surface(scenes::biped(), 3 * kTriangles, 4);
  order_flat_corners(ordered);
  const auto surface = std::make_shared<const Primitive>(std::move(ordered));
  const auto faces = std::make_shared<const FlatFaces>(sort_flat_faces(surface->indices, surface->vertex_count()));
  const auto normals = std::make_shared<std::vector<glm::vec3>>(surface->vertex_count());
  add("flat_normals/sinew/4ktriangles", kTriangles, [surface, faces, normals] {
    run_unchecked(FlatNormalsJob{faces.get(), surface->positions, surface->normals, false, *normals});
  });
}

}  // namespace sinew::bench
