// SPDX-License-Identifier: MIT
#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <nanobind/nanobind.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include "importer/python/module/errors.h"
#include "importer/python/module/evaluate.h"

namespace sinew::python {
namespace {

namespace nb = nanobind;
using nb::literals::operator""_a;

using Issue = std::tuple<std::string, std::string, std::string, std::string>;  // severity, rule, pointer, detail

std::vector<Issue> issues_of(const std::vector<ImportIssue>& issues) {
  std::vector<Issue> out;
  for (const ImportIssue& issue : issues)
    out.emplace_back(name_of(issue.severity), issue.rule, issue.json_pointer, issue.detail);
  return out;
}

/// The arrays of a Python `Poses`, in the order in which every function takes and returns them.
struct PoseArguments {
  Numbers<float> translations, rotations, scales, weights;
};

void require_shape(const Numbers<float>& array, const char* name, std::initializer_list<std::size_t> shape) {
  bool same = array.ndim() == shape.size();
  std::size_t axis = 0;
  std::string expected;
  for (const std::size_t length : shape) {
    same = same && array.shape(axis) == length;
    expected += (axis++ ? ", " : "") + std::to_string(length);
  }
  require(same, std::string(name) + ": the shape is not [" + expected + "]");
}

PoseViews views_of(const Scene& scene, const PoseArguments& poses) {
  require(poses.translations.ndim() == 3, "translations: the shape is not [frame, joint, 3]");
  const std::size_t frames = poses.translations.shape(0), joints = scene.skeleton.joint_count();
  require_shape(poses.translations, "translations", {frames, joints, 3});
  require_shape(poses.rotations, "rotations", {frames, joints, 4});
  require_shape(poses.scales, "scales", {frames, joints, 3});
  require_shape(poses.weights, "weights", {frames, scene.weight_count()});
  return {frames,
          joints,
          scene.weight_count(),
          poses.translations.data(),
          poses.rotations.data(),
          poses.scales.data(),
          poses.weights.data()};
}

nb::tuple release(PoseArrays& poses) {
  return nb::make_tuple(poses.translations.release(), poses.rotations.release(), poses.scales.release(),
                        poses.weights.release());
}

nb::tuple sample(const ClipHandle& clip, const Numbers<double>& times, std::size_t threads) {
  require(times.ndim() == 1, "times: the shape is not [frame]");
  auto poses = [&] {
    const nb::gil_scoped_release unlocked;
    return sample_clip(clip, {times.data(), times.size()}, threads);
  }();
  return release(poses);
}

NumPyArray<float> world(const SceneHandle& scene, Numbers<float> t, Numbers<float> r, Numbers<float> s,
                        Numbers<float> w, std::size_t threads) {
  const PoseViews views = views_of(*scene.scene, {std::move(t), std::move(r), std::move(s), std::move(w)});
  auto matrices = [&] {
    const nb::gil_scoped_release unlocked;
    return world_matrices(*scene.scene, views, threads);
  }();
  return matrices.release();
}

nb::tuple blend_all(const SceneHandle& scene,
                    const std::vector<std::tuple<Numbers<float>, Numbers<float>, Numbers<float>, Numbers<float>>>& all,
                    const std::vector<float>& weights) {
  require(!all.empty() && all.size() == weights.size(), "blend: needs one weight for each of at least one pose");
  std::vector<PoseViews> views;
  for (const auto& [t, r, s, w] : all) views.push_back(views_of(*scene.scene, {t, r, s, w}));
  for (const PoseViews& view : views)
    require(view.frames == views.front().frames, "blend: the poses have different numbers of frames");
  auto poses = [&] {
    const nb::gil_scoped_release unlocked;
    return blend(*scene.scene, views, weights);
  }();
  return release(poses);
}

nb::list skin_all(const SceneHandle& scene, Numbers<float> t, Numbers<float> r, Numbers<float> s, Numbers<float> w,
                  const std::string& kind, bool normals, std::size_t threads) {
  const PoseViews views = views_of(*scene.scene, {std::move(t), std::move(r), std::move(s), std::move(w)});
  const bool is_dual = kind == "dual_quaternion", is_center = kind == "center_of_rotation";
  require(is_dual || is_center || kind == "linear",
          "kind: '" + kind + "' is not 'linear', 'dual_quaternion' or 'center_of_rotation'");
  auto primitives = [&] {
    const nb::gil_scoped_release unlocked;
    return skin(scene, views,
                is_dual     ? Skinning::dual_quaternion
                : is_center ? Skinning::center_of_rotation
                            : Skinning::linear,
                normals, threads);
  }();
  nb::list out;
  for (SkinnedPrimitive& primitive : primitives) {
    nb::object of_normals = nb::none();
    if (normals && primitive.normals.size() > 0) of_normals = nb::cast(primitive.normals.release());
    out.append(nb::make_tuple(primitive.node, primitive.mesh, primitive.primitive,
                              nb::cast(primitive.positions.release()), of_normals));
  }
  return out;
}

/// The rest pose, as one frame.
nb::tuple rest_pose(const SceneHandle& scene) {
  const Skeleton& skeleton = scene.scene->skeleton;
  PoseArrays rest(1, skeleton.joint_count(), scene.scene->weight_count());
  for (std::size_t j = 0; j < skeleton.joint_count(); ++j) {
    const Transform& local = skeleton.rest[j];
    std::copy_n(&local.translation.x, 3, rest.translations.data() + j * 3);
    const float rotation[4] = {local.rotation.x, local.rotation.y, local.rotation.z, local.rotation.w};
    std::copy_n(rotation, 4, rest.rotations.data() + j * 4);
    std::copy_n(&local.scale.x, 3, rest.scales.data() + j * 3);
  }
  const std::vector<float> weights = rest_weights_of(*scene.scene);
  std::copy(weights.begin(), weights.end(), rest.weights.data());
  return release(rest);
}

std::vector<std::int64_t> parents_of(const SceneHandle& scene) {
  std::vector<std::int64_t> out;
  for (const std::uint32_t parent : scene.scene->skeleton.parents)
    out.push_back(parent == kNone ? -1 : static_cast<std::int64_t>(parent));
  return out;
}

nb::object certificate_of(const ClipHandle& clip) {
  const auto& certificate = clip.clip.certificate();
  if (!certificate) return nb::none();
  nb::dict out;
  out["asked"] = certificate->asked_m;
  out["measured"] = certificate->measured_m;
  out["worst_time"] = certificate->worst_time_s;
  out["worst_joint"] = certificate->worst_joint == kNone
                           ? nb::object(nb::none())
                           : nb::cast(clip.scene().skeleton.names[certificate->worst_joint]);
  out["source_keys"] = certificate->source_keys;
  out["kept_keys"] = certificate->kept_keys;
  out["source_bytes"] = certificate->source_bytes;
  out["bytes"] = certificate->bytes;
  return out;
}

/// Raises sinew.FileError, which Python defines.
void translate_failure(const std::exception_ptr& thrown, void*) {
  try {
    std::rethrow_exception(thrown);
  } catch (const FileFailure& failure) {
    const ImportError& error = failure.error();
    std::vector<ImportIssue> all{error.issue};
    all.insert(all.end(), error.more_errors.begin(), error.more_errors.end());
    all.insert(all.end(), error.warnings.begin(), error.warnings.end());
    const nb::object type = nb::module_::import_("sinew._errors").attr("FileError");
    const nb::object raised = type(failure.what(), error.file, issues_of(all));
    PyErr_SetObject(type.ptr(), raised.ptr());
  }
}

}  // namespace

NB_MODULE(_sinew, module) {
  nb::register_exception_translator(translate_failure);
  nb::set_leak_warnings(false);  // modules that outlive the interpreter's last collection are no leak of ours

  nb::class_<SceneHandle>(module, "Scene")
      .def_prop_ro("file", [](const SceneHandle& s) { return s.file; })
      .def_prop_ro("joint_names", [](const SceneHandle& s) { return s.scene->skeleton.names; })
      .def_prop_ro("parents", parents_of)
      .def_prop_ro("nodes", [](const SceneHandle& s) { return s.scene->skeleton.node_of_joint; })
      .def_prop_ro("weight_count", [](const SceneHandle& s) { return s.scene->weight_count(); })
      .def_prop_ro("warnings", [](const SceneHandle& s) { return issues_of(s.warnings); })
      .def("clips", [](std::shared_ptr<SceneHandle> s) { return clips_of(s); })
      .def("rest", rest_pose);

  nb::class_<ClipHandle>(module, "Clip")
      .def_prop_ro("name", [](const ClipHandle& c) { return c.clip.name(); })
      .def_prop_ro("duration", [](const ClipHandle& c) { return c.clip.duration_s(); })
      .def_prop_ro("index", [](const ClipHandle& c) { return c.index; })
      .def_prop_ro("byte_size", [](const ClipHandle& c) { return c.clip.byte_size(); })
      .def_prop_ro("certificate", certificate_of);

  module.def("load", &load_scene, "file"_a, "centers_of_rotation"_a, "images"_a,
             nb::call_guard<nb::gil_scoped_release>());
  module.def("check", [](const std::filesystem::path& file) {
    return issues_of([&] {
      const nb::gil_scoped_release unlocked;
      return check_file(file);
    }());
  });
  module.def("sample", sample);
  module.def("world", world);
  module.def("blend", blend_all);
  module.def("skin", skin_all);
  module.def("compile_within", &compile_within, nb::call_guard<nb::gil_scoped_release>());
  module.def("retarget", [](const ClipHandle& clip, const std::shared_ptr<SceneHandle>& target, bool hold_feet) {
    auto out = [&] {
      const nb::gil_scoped_release unlocked;
      return retarget_clip(clip, target, hold_feet);
    }();
    return nb::make_tuple(std::move(out.clip), std::move(out.resting), out.height_ratio);
  });
}

}  // namespace sinew::python
