# SPDX-License-Identifier: MIT
# The public headers, by idea: an engine includes <sinew/NAME.h>, which is written from the file beside its name. Files in public/
# only gather what belongs to an idea. Headers that these include are written to sinew/detail/, which nobody includes by name.
# tests/architecture/public_headers_test.cpp holds the list to 45 and to the table in runtime/README.md.
set(sinew_public_headers
  animation.h       runtime/public/animation.h
  asset_file.h      runtime/public/asset_file.h
  blend_space.h     runtime/blend_space/blend_space.h
  clip.h            runtime/public/clip.h
  clip_file.h       runtime/clip/clip_file.h
  clip_library.h    runtime/public/clip_library.h
  compress.h        runtime/public/compress.h
  deform_jobs.h     runtime/public/deform_jobs.h
  cut_frame.h       runtime/plan/cut_frame.h
  frame.h           runtime/public/frame.h
  frame_hash.h      runtime/public/frame_hash.h
  fwd.h             runtime/public/fwd.h
  geometry_cache.h  runtime/public/geometry_cache.h
  graph.h           runtime/public/graph.h
  hold_feet.h       runtime/public/hold_feet.h
  job_thread.h      runtime/threads/job_thread.h
  lod.h             runtime/public/lod.h
  materials.h       runtime/model/material.h
  math.h            runtime/public/math.h
  memory.h          runtime/memory/memory_of.h
  mesh.h            runtime/public/mesh.h
  mirror.h          runtime/public/mirror.h
  morphs.h          runtime/public/morphs.h
  paging.h          runtime/public/paging.h
  plan.h            runtime/public/plan.h
  playback.h        runtime/public/playback.h
  pose_jobs.h       runtime/public/pose_jobs.h
  pose_program.h    runtime/public/pose_program.h
  procedures.h      runtime/public/procedures.h
  result.h          runtime/public/result.h
  retarget.h        runtime/public/retarget.h
  scene.h           runtime/public/scene.h
  skeleton.h        runtime/public/skeleton.h
  springs.h         runtime/public/springs.h
  sync.h            runtime/sync/sync_group.h
  update_rates.h    runtime/public/update_rates.h
  sinew.h           runtime/sinew.h
  sinew_assets.h    runtime/c_assets/sinew_assets.h
  sinew_geometry.h  runtime/c_geometry/sinew_geometry.h)
if(SINEW_IMPORTER)
  list(APPEND sinew_public_headers
    bake_geometry.h        importer/geometry_cache/encode_geometry_cache.h
    centers_of_rotation.h  importer/add_centers_of_rotation.h
    import.h               importer/import_gltf.h
    sinew_import.h         importer/c/sinew_import.h
    vrm.h                  importer/vrm.h
    vrm_springs.h          importer/vrm_springs.h)
endif()

# Programs outside of this tree read the headers from build/include, and an installed package holds that folder. They are written
# once now, so that all of their names are known, and again in the build when one of them has changed.
set(sinew_headers_list ${PROJECT_BINARY_DIR}/public_headers.txt)
set(sinew_headers_stamp ${PROJECT_BINARY_DIR}/public_headers.stamp)
list(JOIN sinew_public_headers "\n" sinew_headers_text)
file(CONFIGURE OUTPUT ${sinew_headers_list} CONTENT "${sinew_headers_text}\n")
set(sinew_write_headers ${CMAKE_COMMAND} -DLIST=${sinew_headers_list} -DFROM=${PROJECT_SOURCE_DIR}
  -DTO=${PROJECT_BINARY_DIR}/include/sinew -DSTAMP=${sinew_headers_stamp} -P ${PROJECT_SOURCE_DIR}/runtime/write_public_headers.cmake)
execute_process(COMMAND ${sinew_write_headers} COMMAND_ERROR_IS_FATAL ANY)
file(GLOB_RECURSE sinew_written_headers ${PROJECT_BINARY_DIR}/include/sinew/*.h)
# The headers are named as by-products, so that what includes them is compiled again in the same build that writes them anew.
add_custom_command(OUTPUT ${sinew_headers_stamp} BYPRODUCTS ${sinew_written_headers} COMMAND ${sinew_write_headers}
  DEPENDS ${sinew_headers_list} ${PROJECT_SOURCE_DIR}/runtime/write_public_headers.cmake DEPFILE ${sinew_headers_stamp}.d
  COMMENT "Writing the public headers" VERBATIM)
add_custom_target(sinew_headers ALL DEPENDS ${sinew_headers_stamp})
