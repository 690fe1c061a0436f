# SPDX-License-Identifier: MIT
# The package: libraries, public headers under include/sinew, programs, and what find_package(sinew) reads. Nothing in it
# names the folder that it was installed into, so it can be moved.
include(CMakePackageConfigHelpers)
set(sinew_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/sinew)

install(TARGETS sinew_runtime sinew_threads sinew_compress sinew_lod sinew_c EXPORT sinew_runtime_targets)
install(EXPORT sinew_runtime_targets NAMESPACE sinew:: FILE sinew-runtime.cmake DESTINATION ${sinew_package_dir})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/runtime/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/sinew/runtime
  FILES_MATCHING PATTERN "*.h" PATTERN "*-inl.h" EXCLUDE)

if(SINEW_IMPORTER)
  # Packages whose targets the static library names; each must be found again by who links it.
  set(SINEW_IMPORTER_PACKAGES "")
  get_target_property(importer_links sinew_importer LINK_LIBRARIES)
  foreach(pair IN ITEMS tinygltf=TinyGLTF nlohmann_json=nlohmann_json OpenMesh=OpenMesh meshoptimizer=meshoptimizer
      draco=draco embree=embree fmt=fmt spdlog=spdlog ZLIB=ZLIB)
    string(REGEX MATCH "^([^=]+)=(.+)$" matched "${pair}")
    if("${importer_links}" MATCHES "${CMAKE_MATCH_1}")
      string(REGEX REPLACE "^[^=]+=" "" package "${pair}")
      list(APPEND SINEW_IMPORTER_PACKAGES ${package})
    endif()
  endforeach()
  list(JOIN SINEW_IMPORTER_PACKAGES " " SINEW_IMPORTER_PACKAGES)
  install(TARGETS sinew_importer EXPORT sinew_importer_targets)
  install(EXPORT sinew_importer_targets NAMESPACE sinew:: FILE sinew-importer.cmake DESTINATION ${sinew_package_dir})
  install(FILES ${PROJECT_SOURCE_DIR}/importer/import_gltf.h ${PROJECT_SOURCE_DIR}/importer/import_error.h
    ${PROJECT_SOURCE_DIR}/importer/add_centers_of_rotation.h
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/sinew/importer)
  install(FILES ${PROJECT_SOURCE_DIR}/importer/c/sinew_import.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/sinew/importer/c)
  install(FILES ${PROJECT_SOURCE_DIR}/importer/topology/centers_of_rotation.h
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/sinew/importer/topology)
  install(TARGETS sinew)
endif()

configure_package_config_file(${PROJECT_SOURCE_DIR}/runtime/sinew-config.cmake.in
  ${PROJECT_BINARY_DIR}/package/sinew-config.cmake INSTALL_DESTINATION ${sinew_package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/sinew-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/package/sinew-config.cmake ${PROJECT_BINARY_DIR}/package/sinew-config-version.cmake
  DESTINATION ${sinew_package_dir})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
