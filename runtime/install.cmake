# SPDX-License-Identifier: MIT
# The package: libraries, public headers under include/sinew, programs, and what find_package(sinew) reads. Nothing in it
# names the folder that it was installed into, so it can be moved.
include(CMakePackageConfigHelpers)
set(sinew_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/sinew)

install(DIRECTORY ${PROJECT_BINARY_DIR}/include/sinew DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})

# Packages whose targets a static library names: who links it finds them again. What is not listed here is a plain library.
set(sinew_package_of glm=glm tl=tl-expected hwy=hwy TBB=TBB nlohmann_json=nlohmann_json OpenMeshCore=OpenMesh
  meshoptimizer=meshoptimizer draco=draco)

# One component: a library, the others of ours that it links, and the packages.
set(SINEW_COMPONENTS "")
function(sinew_component name)
  get_target_property(links sinew_${name} LINK_LIBRARIES)
  set(components "")
  set(packages "")
  foreach(link IN LISTS links)
    string(REGEX REPLACE "^sinew(_|::)" "" component "${link}")
    string(REGEX REPLACE "::.*$" "" library "${link}")
    if(component IN_LIST SINEW_COMPONENTS)
      list(APPEND components ${component})
    endif()
    foreach(pair IN LISTS sinew_package_of)
      if(pair MATCHES "^${library}=(.+)$")
        list(APPEND packages ${CMAKE_MATCH_1})
      endif()
    endforeach()
  endforeach()
  install(TARGETS sinew_${name} EXPORT sinew_${name}_targets)
  install(EXPORT sinew_${name}_targets NAMESPACE sinew:: FILE sinew-${name}.cmake DESTINATION ${sinew_package_dir})
  set(SINEW_COMPONENTS ${SINEW_COMPONENTS} ${name} PARENT_SCOPE)
  string(APPEND SINEW_NEEDS "set(sinew_components_of_${name} ${components})\nset(sinew_packages_of_${name} ${packages})\n")
  set(SINEW_NEEDS "${SINEW_NEEDS}" PARENT_SCOPE)
endfunction()
foreach(name IN ITEMS runtime threads compress lod geometry_cache asset_file c c_assets c_geometry)  # those that others link come before them
  sinew_component(${name})
endforeach()
if(SINEW_IMPORTER)
  sinew_component(importer)
  install(TARGETS sinew)
endif()

configure_package_config_file(${PROJECT_SOURCE_DIR}/runtime/sinew-config.cmake.in
  ${PROJECT_BINARY_DIR}/package/sinew-config.cmake INSTALL_DESTINATION ${sinew_package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/sinew-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/package/sinew-config.cmake ${PROJECT_BINARY_DIR}/package/sinew-config-version.cmake
  DESTINATION ${sinew_package_dir})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
