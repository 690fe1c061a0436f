// SPDX-License-Identifier: MIT
#include "tests/support/scene_equality.h"

#include <array>

#include <gtest/gtest.h>

namespace sinew::test {
namespace {

template <class V>
void expect_same(const SparseDeltas<V>& a, const SparseDeltas<V>& b, const char* what) {
  EXPECT_EQ(a.vertices, b.vertices) << what;
  EXPECT_TRUE(a.deltas == b.deltas) << what;
}

void expect_same(const MorphSet& a, const MorphSet& b) {
  ASSERT_EQ(a.targets.size(), b.targets.size());
  for (std::size_t t = 0; t < a.targets.size(); ++t) {
    SCOPED_TRACE(testing::Message() << "target " << t);
    expect_same(a.targets[t].positions, b.targets[t].positions, "positions");
    expect_same(a.targets[t].normals, b.targets[t].normals, "normals");
    expect_same(a.targets[t].tangents, b.targets[t].tangents, "tangents");
    expect_same(a.targets[t].colors, b.targets[t].colors, "colors");
    ASSERT_EQ(a.targets[t].texcoords.size(), b.targets[t].texcoords.size());
    for (std::size_t s = 0; s < a.targets[t].texcoords.size(); ++s)
      expect_same(a.targets[t].texcoords[s], b.targets[t].texcoords[s], "texcoords");
  }
}

void expect_same(const VertexInfluences& a, const VertexInfluences& b) {
  ASSERT_EQ(a.groups.size(), b.groups.size());
  for (std::size_t g = 0; g < a.groups.size(); ++g) {
    EXPECT_EQ(a.groups[g].first_vertex, b.groups[g].first_vertex);
    EXPECT_EQ(a.groups[g].vertex_count, b.groups[g].vertex_count);
    EXPECT_EQ(a.groups[g].influence_count, b.groups[g].influence_count);
    EXPECT_EQ(a.groups[g].first_influence, b.groups[g].first_influence);
  }
  EXPECT_EQ(a.joints, b.joints);
  EXPECT_EQ(a.weights, b.weights);
}

void expect_same(const Primitive& a, const Primitive& b) {
  EXPECT_EQ(a.topology, b.topology);
  EXPECT_EQ(a.indices, b.indices);
  EXPECT_TRUE(a.positions == b.positions);
  EXPECT_TRUE(a.normals == b.normals);
  EXPECT_TRUE(a.tangents == b.tangents);
  EXPECT_TRUE(a.texcoords == b.texcoords);
  EXPECT_TRUE(a.colors == b.colors);
  EXPECT_EQ(a.material, b.material);
  EXPECT_EQ(a.variant_materials, b.variant_materials);
  EXPECT_EQ(a.flat_normals, b.flat_normals);
  EXPECT_EQ(a.bounds.lower, b.bounds.lower);
  EXPECT_EQ(a.bounds.upper, b.bounds.upper);
  expect_same(a.influences, b.influences);
  expect_same(a.morphs, b.morphs);
}

void expect_same_meshes(const Scene& a, const Scene& b) {
  ASSERT_EQ(a.meshes.size(), b.meshes.size());
  for (std::size_t m = 0; m < a.meshes.size(); ++m) {
    SCOPED_TRACE("mesh " + a.meshes[m].name);
    EXPECT_EQ(a.meshes[m].name, b.meshes[m].name);
    EXPECT_EQ(a.meshes[m].default_weights, b.meshes[m].default_weights);
    EXPECT_EQ(a.meshes[m].target_names, b.meshes[m].target_names);
    ASSERT_EQ(a.meshes[m].primitives.size(), b.meshes[m].primitives.size());
    for (std::size_t p = 0; p < a.meshes[m].primitives.size(); ++p)
      expect_same(a.meshes[m].primitives[p], b.meshes[m].primitives[p]);
  }
}

void expect_same_skeletons(const Scene& a, const Scene& b) {
  const Skeleton &s = a.skeleton, &t = b.skeleton;
  EXPECT_EQ(s.parents, t.parents);
  EXPECT_EQ(s.names, t.names);
  EXPECT_TRUE(s.rest == t.rest);
  EXPECT_TRUE(s.fixed_matrices == t.fixed_matrices);
  EXPECT_EQ(s.fixed_matrix_of, t.fixed_matrix_of);
  EXPECT_EQ(s.level_begin, t.level_begin);
  EXPECT_EQ(a.hidden_joints, b.hidden_joints);
  EXPECT_EQ(a.variants, b.variants);
  ASSERT_EQ(a.skins.size(), b.skins.size());
  for (std::size_t i = 0; i < a.skins.size(); ++i) {
    EXPECT_EQ(a.skins[i].name, b.skins[i].name);
    EXPECT_EQ(a.skins[i].joints, b.skins[i].joints);
    EXPECT_TRUE(a.skins[i].inverse_bind == b.skins[i].inverse_bind);
    EXPECT_EQ(a.skins[i].skeleton_root, b.skins[i].skeleton_root);
  }
  ASSERT_EQ(a.instances.size(), b.instances.size());
  for (std::size_t i = 0; i < a.instances.size(); ++i) {
    EXPECT_EQ(a.instances[i].joint, b.instances[i].joint);
    EXPECT_EQ(a.instances[i].mesh, b.instances[i].mesh);
    EXPECT_EQ(a.instances[i].skin, b.instances[i].skin);
    EXPECT_EQ(a.instances[i].rest_weights, b.instances[i].rest_weights);
    EXPECT_TRUE(a.instances[i].copies == b.instances[i].copies);
  }
}

template <class T>
void expect_same_track(const T& a, const T& b, const char* what) {
  EXPECT_EQ(a.times_s, b.times_s) << what;
  EXPECT_TRUE(a.values == b.values) << what;
  if (!a.empty()) {
    EXPECT_EQ(a.interpolation, b.interpolation) << what;
  }
}

void expect_same_animations(const Scene& a, const Scene& b) {
  ASSERT_EQ(a.animations.size(), b.animations.size());
  for (std::size_t i = 0; i < a.animations.size(); ++i) {
    const Animation &x = a.animations[i], &y = b.animations[i];
    SCOPED_TRACE("animation " + x.name);
    EXPECT_EQ(x.name, y.name);
    EXPECT_EQ(x.duration_s, y.duration_s);
    ASSERT_EQ(x.bones.size(), y.bones.size());
    for (std::size_t j = 0; j < x.bones.size(); ++j) {
      EXPECT_EQ(x.bones[j].joint, y.bones[j].joint);
      expect_same_track(x.bones[j].translation, y.bones[j].translation, "translation");
      expect_same_track(x.bones[j].rotation, y.bones[j].rotation, "rotation");
      expect_same_track(x.bones[j].scale, y.bones[j].scale, "scale");
    }
    ASSERT_EQ(x.weights.size(), y.weights.size());
    for (std::size_t j = 0; j < x.weights.size(); ++j) {
      EXPECT_EQ(x.weights[j].instance, y.weights[j].instance);
      EXPECT_EQ(x.weights[j].weights.target_count, y.weights[j].weights.target_count);
      EXPECT_EQ(x.weights[j].first_target, y.weights[j].first_target);
      expect_same_track(x.weights[j].weights, y.weights[j].weights, "weights");
    }
    ASSERT_EQ(x.properties.size(), y.properties.size());
    for (std::size_t j = 0; j < x.properties.size(); ++j) {
      EXPECT_EQ(x.properties[j].target, y.properties[j].target);
      EXPECT_EQ(x.properties[j].values.target_count, y.properties[j].values.target_count);
      expect_same_track(x.properties[j].values, y.properties[j].values, "property");
    }
  }
}

void expect_same_use(const TextureUse& a, const TextureUse& b, const char* what) {
  EXPECT_EQ(a.texture, b.texture) << what;
  EXPECT_EQ(a.texcoord, b.texcoord) << what;
  EXPECT_EQ(a.offset, b.offset) << what;
  EXPECT_EQ(a.rotation_rad, b.rotation_rad) << what;
  EXPECT_EQ(a.scale, b.scale) << what;
}

void expect_same_layers(const Material& x, const Material& y) {
  EXPECT_EQ(x.specular.ior, y.specular.ior);
  EXPECT_EQ(x.specular.factor, y.specular.factor);
  EXPECT_EQ(x.specular.color, y.specular.color);
  EXPECT_EQ(x.specular.has_glossiness, y.specular.has_glossiness);
  EXPECT_EQ(x.clearcoat.factor, y.clearcoat.factor);
  EXPECT_EQ(x.clearcoat.roughness, y.clearcoat.roughness);
  EXPECT_EQ(x.clearcoat.normal_scale, y.clearcoat.normal_scale);
  EXPECT_EQ(x.sheen.color, y.sheen.color);
  EXPECT_EQ(x.sheen.roughness, y.sheen.roughness);
  EXPECT_EQ(x.transmission.factor, y.transmission.factor);
  const auto film = [](const Iridescence& i) { return std::array{i.factor, i.ior, i.thinnest_nm, i.thickest_nm}; };
  EXPECT_EQ(film(x.iridescence), film(y.iridescence));
  EXPECT_EQ(x.anisotropy.strength, y.anisotropy.strength);
  EXPECT_EQ(x.anisotropy.rotation_rad, y.anisotropy.rotation_rad);
  EXPECT_EQ(x.volume.thickness_m, y.volume.thickness_m);
  EXPECT_EQ(x.volume.attenuation_distance_m, y.volume.attenuation_distance_m);
  EXPECT_EQ(x.volume.attenuation_color, y.volume.attenuation_color);
}

void expect_same_materials(const Scene& a, const Scene& b) {
  ASSERT_EQ(a.materials.size(), b.materials.size());
  for (std::size_t i = 0; i < a.materials.size(); ++i) {
    const Material &x = a.materials[i], &y = b.materials[i];
    SCOPED_TRACE("material " + x.name);
    EXPECT_EQ(x.name, y.name);
    EXPECT_EQ(x.base_color, y.base_color);
    EXPECT_EQ(x.metallic, y.metallic);
    EXPECT_EQ(x.roughness, y.roughness);
    EXPECT_EQ(x.normal_scale, y.normal_scale);
    EXPECT_EQ(x.occlusion_strength, y.occlusion_strength);
    EXPECT_EQ(x.emissive, y.emissive);
    EXPECT_EQ(x.emissive_strength, y.emissive_strength);
    EXPECT_EQ(x.alpha_mode, y.alpha_mode);
    EXPECT_EQ(x.alpha_cutoff, y.alpha_cutoff);
    EXPECT_EQ(x.double_sided, y.double_sided);
    EXPECT_EQ(x.unlit, y.unlit);
    expect_same_layers(x, y);
    const auto uses = texture_uses(x), others = texture_uses(y);
    for (std::size_t u = 0; u < uses.size(); ++u)
      expect_same_use(*uses[u], *others[u], ("texture use " + std::to_string(u)).c_str());
  }
  ASSERT_EQ(a.images.size(), b.images.size());
  for (std::size_t i = 0; i < a.images.size(); ++i) {
    EXPECT_EQ(a.images[i].name, b.images[i].name);
    EXPECT_EQ(a.images[i].rgba, b.images[i].rgba);
  }
  ASSERT_EQ(a.textures.size(), b.textures.size());
  for (std::size_t i = 0; i < a.textures.size(); ++i) {
    EXPECT_EQ(a.textures[i].image, b.textures[i].image);
    EXPECT_EQ(a.textures[i].sampler.magnify, b.textures[i].sampler.magnify);
    EXPECT_EQ(a.textures[i].sampler.minify, b.textures[i].sampler.minify);
    EXPECT_EQ(a.textures[i].sampler.mipmap, b.textures[i].sampler.mipmap);
    EXPECT_EQ(a.textures[i].sampler.use_mipmaps, b.textures[i].sampler.use_mipmaps);
    EXPECT_EQ(a.textures[i].sampler.wrap_u, b.textures[i].sampler.wrap_u);
    EXPECT_EQ(a.textures[i].sampler.wrap_v, b.textures[i].sampler.wrap_v);
  }
}

void expect_same_cameras_and_lights(const Scene& a, const Scene& b) {
  ASSERT_EQ(a.cameras.size(), b.cameras.size());
  for (std::size_t i = 0; i < a.cameras.size(); ++i) {
    EXPECT_EQ(a.cameras[i].name, b.cameras[i].name);
    EXPECT_EQ(a.cameras[i].joint, b.cameras[i].joint);
    EXPECT_EQ(a.cameras[i].perspective, b.cameras[i].perspective);
    EXPECT_EQ(a.cameras[i].half_width, b.cameras[i].half_width);
    EXPECT_EQ(a.cameras[i].half_height, b.cameras[i].half_height);
    EXPECT_EQ(a.cameras[i].fov_y_rad, b.cameras[i].fov_y_rad);
    EXPECT_EQ(a.cameras[i].aspect, b.cameras[i].aspect);
    EXPECT_EQ(a.cameras[i].near_m, b.cameras[i].near_m);
    EXPECT_EQ(a.cameras[i].far_m, b.cameras[i].far_m);
  }
  ASSERT_EQ(a.lights.size(), b.lights.size());
  for (std::size_t i = 0; i < a.lights.size(); ++i) {
    EXPECT_EQ(a.lights[i].name, b.lights[i].name);
    EXPECT_EQ(a.lights[i].kind, b.lights[i].kind);
    EXPECT_EQ(a.lights[i].joint, b.lights[i].joint);
    EXPECT_EQ(a.lights[i].color, b.lights[i].color);
    EXPECT_EQ(a.lights[i].intensity, b.lights[i].intensity);
    EXPECT_EQ(a.lights[i].range_m, b.lights[i].range_m);
    EXPECT_EQ(a.lights[i].inner_cone_rad, b.lights[i].inner_cone_rad);
    EXPECT_EQ(a.lights[i].outer_cone_rad, b.lights[i].outer_cone_rad);
  }
}

}  // namespace

void expect_equal(const Scene& before, const Scene& after) {
  expect_same_skeletons(before, after);
  expect_same_meshes(before, after);
  expect_same_animations(before, after);
  expect_same_materials(before, after);
  expect_same_cameras_and_lights(before, after);
  ASSERT_EQ(before.scenes.size(), after.scenes.size());
  for (std::size_t s = 0; s < before.scenes.size(); ++s) {
    EXPECT_EQ(before.scenes[s].name, after.scenes[s].name);
    EXPECT_EQ(before.scenes[s].joints, after.scenes[s].joints);
  }
  EXPECT_EQ(before.default_scene, after.default_scene);
}

}  // namespace sinew::test
