// SPDX-License-Identifier: MIT
#include "importer/build/build_placements.h"

#include <cmath>
#include <optional>
#include <string>

#include "importer/file/json_pointer.h"
#include "importer/read/extension_fields.h"
#include "importer/read/json_member.h"
#include "importer/read/lights.h"

namespace sinew {
namespace {

using gltf::Json;

Camera build_camera(const tinygltf::Camera& source, std::uint32_t index, IssueLog& log) {
  Camera camera;
  camera.name = source.name;
  camera.perspective = source.type != "orthographic";
  const gltf::DepthRange depth = gltf::depth_range(source);
  const auto use = [&](double value, float& out, const char* name) {
    if (value > 0.0)
      out = static_cast<float>(value);
    else
      log.report(Rule::camera_values, pointer("cameras", index),
                 std::string(name) + " is not above 0; " + std::to_string(out) + " is used");
  };
  if (camera.perspective) {
    const double aspect = source.perspective.aspectRatio;
    use(source.perspective.yfov, camera.fov_y_rad, "yfov");
    camera.aspect = aspect > 0.0 ? static_cast<float>(aspect) : 0.0f;
  } else {
    use(std::abs(source.orthographic.xmag), camera.half_width, "xmag");
    use(std::abs(source.orthographic.ymag), camera.half_height, "ymag");
  }
  if (camera.perspective || depth.near > 0.0)
    use(depth.near, camera.near_m, "znear");
  else
    camera.near_m = 0.0f;
  if (depth.far > depth.near)
    camera.far_m = static_cast<float>(depth.far);
  else if (depth.far != 0.0)
    log.report(Rule::camera_values, pointer("cameras", index), "zfar is not above znear; infinite is used");
  return camera;
}

void build_lights(const gltf::Document& document, const JointOrder& order, Scene& scene, Placements& placements,
                  IssueLog& log) {
  constexpr const char* kLights = "KHR_lights_punctual";
  const std::vector<std::optional<Light>> lights = read_lights(document, log);
  placements.of_light.resize(lights.size());
  for (std::uint32_t n = 0; n < document.nodes.size(); ++n) {
    const Json* use = member(member(&document.nodes[n].extensions, kLights), "light");
    if (use == nullptr) continue;
    const std::uint32_t light = index_below(use, lights.size());
    if (light == kNone) {
      log.report(Rule::light_values, pointer("nodes", n, "extensions", kLights, "light"),
                 "there is no such light; ignored");
      continue;
    }
    if (!lights[light]) continue;
    placements.of_light[light].push_back(static_cast<std::uint32_t>(scene.lights.size()));
    scene.lights.push_back(*lights[light]);
    scene.lights.back().joint = order.joint_of_node[n];
  }
}

void build_cameras(const gltf::Document& document, const JointOrder& order, Scene& scene, Placements& placements,
                   IssueLog& log) {
  for (std::uint32_t c = 0; c < document.cameras.size(); ++c) {
    scene.cameras.push_back(build_camera(document.cameras[c], c, log));
    placements.of_camera.push_back({c});
  }
  for (std::uint32_t n = 0; n < document.nodes.size(); ++n) {
    const std::uint32_t camera = document.nodes[n].camera;
    if (camera == kNone) continue;
    std::uint32_t placed = camera;
    if (scene.cameras[camera].joint != kNone) {  // the camera is used by several nodes: copy it
      placed = static_cast<std::uint32_t>(scene.cameras.size());
      placements.of_camera[camera].push_back(placed);
      scene.cameras.push_back(scene.cameras[camera]);
    }
    scene.cameras[placed].joint = order.joint_of_node[n];
  }
}

void find_hidden_joints(const gltf::Document& document, const JointOrder& order, Scene& scene, IssueLog& log) {
  for (std::uint32_t n = 0; n < document.nodes.size(); ++n) {
    const ExtensionFields visibility(document.nodes[n].extensions, pointer("nodes", n), "KHR_node_visibility", log);
    if (!visibility.boolean("visible", true)) scene.hidden_joints.push_back(order.joint_of_node[n]);
  }
}

}  // namespace

std::vector<std::uint32_t> Placements::indices_in_scene(const PropertyTarget& target, const JointOrder& order) const {
  if (target.kind == PropertyKind::node_visible) return {order.joint_of_node[target.index]};
  if (target.kind <= PropertyKind::camera_far) return of_camera[target.index];
  if (target.kind <= PropertyKind::light_outer_cone) return of_light[target.index];
  return {target.index};
}

Placements build_placements(const gltf::Document& document, const JointOrder& order, Scene& scene, IssueLog& log) {
  Placements placements;
  build_cameras(document, order, scene, placements, log);
  build_lights(document, order, scene, placements, log);
  find_hidden_joints(document, order, scene, log);
  for (const auto& source : document.scenes) {
    SceneRoots roots{source.name, {}};
    for (const std::uint32_t node : source.nodes) roots.joints.push_back(order.joint_of_node[node]);
    scene.scenes.push_back(std::move(roots));
  }
  if (document.scene != kNone)
    scene.default_scene = document.scene;
  else if (!document.scenes.empty())
    scene.default_scene = 0;
  return placements;
}

}  // namespace sinew
