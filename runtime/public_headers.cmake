# SPDX-License-Identifier: MIT
# The headers that the package installs, under include/sinew/. All others are internal. A header that one of these includes is one
# of them too; architecture/installed_headers_* names those that are missing.
set(sinew_public_headers
  runtime/sinew.h
  runtime/base/bit_hash.h
  runtime/base/contract.h
  runtime/base/index.h
  runtime/base/result.h
  runtime/base/run_job.h
  runtime/base/same_bits.h
  runtime/base/shared_array.h
  runtime/base/shared_name.h
  runtime/math/affine.h
  runtime/math/axis_angle.h
  runtime/math/conventions.h
  runtime/math/decompose.h
  runtime/math/determinant_sign.h
  runtime/math/dual_quaternion.h
  runtime/math/euler.h
  runtime/math/interpolate.h
  runtime/math/inverse.h
  runtime/math/joint_matrix.h
  runtime/math/matrix_rotation.h
  runtime/math/negligible.h
  runtime/math/normal_transform.h
  runtime/math/quat_log_exp.h
  runtime/math/quaternion.h
  runtime/math/rotation_about.h
  runtime/math/rotation_between.h
  runtime/math/stretch.h
  runtime/math/swing_twist.h
  runtime/math/transform.h
  runtime/math/two_bones.h
  runtime/animation/bone_animation.h
  runtime/animation/close_loop.h
  runtime/animation/mirror_animation.h
  runtime/animation/mirror_map.h
  runtime/animation/property_track.h
  runtime/animation/side_names.h
  runtime/animation/skeleton.h
  runtime/animation/skeleton_signature.h
  runtime/animation/track.h
  runtime/animation/truth_pose.h
  runtime/clip/clip.h
  runtime/clip/clip_file.h
  runtime/clip/clip_rest.h
  runtime/clip/decompile_clip.h
  runtime/clip/keep_joints.h
  runtime/clip/unpack_clip.h
  runtime/library/bind_clips.h
  runtime/library/clip_channels.h
  runtime/library/clip_library.h
  runtime/memory/memory_of.h
  runtime/paging/cut_clip.h
  runtime/paging/page_table.h
  runtime/paging/paged_clip.h
  runtime/model/material.h
  runtime/model/mesh.h
  runtime/model/mirror_scene.h
  runtime/model/morph_set.h
  runtime/model/pose_corrective.h
  runtime/model/pose_samples.h
  runtime/model/scene.h
  runtime/model/scene_look.h
  runtime/model/skeleton_lod.h
  runtime/model/skin.h
  runtime/pose/add_pose.h
  runtime/pose/blend_poses.h
  runtime/pose/correct_pose.h
  runtime/pose/joint_palette.h
  runtime/pose/local_to_model.h
  runtime/pose/mirror_pose.h
  runtime/pose/pose.h
  runtime/pose/pose_memory.h
  runtime/pose/sample_clip.h
  runtime/deform/blend_combinations.h
  runtime/deform/combine_influences.h
  runtime/deform/flat_faces.h
  runtime/deform/flat_normals.h
  runtime/deform/grow_bounds.h
  runtime/deform/influence_streams.h
  runtime/deform/morph_vertices.h
  runtime/deform/skin_center_of_rotation.h
  runtime/deform/skin_dual_quaternion.h
  runtime/deform/skin_linear.h
  runtime/deform/surface_faces.h
  runtime/deform/surface_normals.h
  runtime/deform/vertex_streams.h
  runtime/pose_program/pose_program.h
  runtime/pose_program/run_pose_program.h
  runtime/plan/compile_plan.h
  runtime/plan/frame_buffer.h
  runtime/plan/frame_hash.h
  runtime/plan/frame_input.h
  runtime/plan/frame_result.h
  runtime/plan/input_copy.h
  runtime/plan/joint_scales.h
  runtime/plan/needs.h
  runtime/plan/run_plan.h
  runtime/plan/plan_assets.h
  runtime/plan/plan_stages.h
  runtime/plan/vertex_source.h
  runtime/playback/event_cursor.h
  runtime/playback/playback_clock.h
  runtime/playback/root_motion.h
  runtime/playback/root_track.h
  runtime/retarget/feet_map.h
  runtime/retarget/hold_feet.h
  runtime/retarget/hold_feet_animation.h
  runtime/retarget/humanoid_bones.h
  runtime/retarget/retarget_animation.h
  runtime/retarget/retarget_pose.h
  runtime/retarget/retarget_properties.h
  runtime/retarget/retarget_weights.h
  runtime/retarget/share_twist.h
  runtime/retarget/skeleton_map.h
  runtime/retarget/twist_map.h
  runtime/threads/job_thread.h
  runtime/compress/clip_error.h
  runtime/compress/compile_clip_within.h
  runtime/compress/truth_samples.h
  runtime/compress/virtual_vertices.h
  runtime/lod/clip_bounds.h
  runtime/lod/compile_skeleton_lod.h
  runtime/lod/interpolated_input.h
  runtime/lod/update_rate.h
  runtime/geometry_cache/bind_geometry.h
  runtime/geometry_cache/frame_window.h
  runtime/geometry_cache/geometry_cache.h
  runtime/geometry_cache/geometry_decoder.h
  runtime/geometry_cache/geometry_player.h
  runtime/geometry_cache/scene_of_cache.h
  runtime/asset_file/asset_file.h
  runtime/asset_file/read_assets.h
  runtime/asset_file/read_pages.h
  runtime/asset_file/write_asset_file.h
  runtime/c/clips.h
  runtime/c/library.h
  runtime/c/messages.h
  runtime/c/mirror.h
  runtime/c/pages.h
  runtime/c/root_motion.h
  runtime/c/skeleton_lod.h
  runtime/c/update_levels.h
  runtime/c/frame.h
  runtime/c/jobs.h
  runtime/c/plan.h
  runtime/c/playback.h
  runtime/c/pose.h
  runtime/c/retarget.h
  runtime/c/scene.h
  runtime/c/types.h
  runtime/c_assets/sinew_assets.h
  runtime/c_geometry/sinew_geometry.h)
if(SINEW_IMPORTER)
  list(APPEND sinew_public_headers
    importer/add_centers_of_rotation.h
    importer/geometry_cache/encode_geometry_cache.h
    importer/geometry_cache/geometry_take.h
    importer/import_error.h
    importer/import_gltf.h
    importer/c/sinew_import.h
    importer/topology/centers_of_rotation.h
    importer/vrm.h)
endif()

# Programs outside of this tree read the headers from build/include, and an installed package holds that folder: there they include
# each other as <sinew/...>, so that an engine may have a folder `runtime` of its own.
list(TRANSFORM sinew_public_headers PREPEND ${PROJECT_SOURCE_DIR}/ OUTPUT_VARIABLE sinew_public_sources)
list(TRANSFORM sinew_public_headers PREPEND ${PROJECT_BINARY_DIR}/include/sinew/ OUTPUT_VARIABLE sinew_written_headers)
set(sinew_headers_list ${PROJECT_BINARY_DIR}/public_headers.txt)
list(JOIN sinew_public_headers "\n" sinew_headers_text)
file(CONFIGURE OUTPUT ${sinew_headers_list} CONTENT "${sinew_headers_text}\n")
set(sinew_write_headers ${PROJECT_SOURCE_DIR}/runtime/write_public_headers.cmake)
# The headers are named as by-products, so that what includes them is compiled again in the same build that writes them anew.
add_custom_command(OUTPUT ${PROJECT_BINARY_DIR}/public_headers.stamp
  BYPRODUCTS ${sinew_written_headers}
  COMMAND ${CMAKE_COMMAND} -DLIST=${sinew_headers_list} -DFROM=${PROJECT_SOURCE_DIR} -DTO=${PROJECT_BINARY_DIR}/include/sinew -P ${sinew_write_headers}
  COMMAND ${CMAKE_COMMAND} -E touch ${PROJECT_BINARY_DIR}/public_headers.stamp
  DEPENDS ${sinew_public_sources} ${sinew_headers_list} ${sinew_write_headers} COMMENT "Writing the public headers" VERBATIM)
add_custom_target(sinew_headers ALL DEPENDS ${PROJECT_BINARY_DIR}/public_headers.stamp)
