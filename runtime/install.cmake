# SPDX-License-Identifier: MIT
# The package: libraries, public headers under include/sinew, programs, and what find_package(sinew) reads. Nothing in it
# names the folder that it was installed into, so it can be moved. Components: `library` is what programs load, `dev` what they are
# built with, `tools` the programs.
include(CMakePackageConfigHelpers)
set(sinew_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/sinew)

install(DIRECTORY ${PROJECT_BINARY_DIR}/include/sinew DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev)

file(RELATIVE_PATH sinew_up "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
string(REGEX REPLACE "/$" "" sinew_up "${sinew_up}")
set(sinew_shared_flag "")
if(BUILD_SHARED_LIBS)
  set(sinew_shared_flag " -DSINEW_SHARED")
endif()

# pkg-config's names of packages; a package without one is headers only.
set(sinew_pkg_config_of hwy=libhwy TBB=tbb zstd=libzstd draco=draco OpenMesh=openmesh turbojpeg=libturbojpeg webp=libwebp avif=libavif)

# Packages whose targets a static library names: who links it finds them again. What is not listed here is a plain library.
set(sinew_package_of glm=glm tl=tl-expected hwy=hwy TBB=TBB Threads=Threads nlohmann_json=nlohmann_json OpenMeshCore=OpenMesh
  meshoptimizer=meshoptimizer draco=draco)

# Writes sinew-NAME.pc. What a shared library links is its own affair; whoever links a static one links that, too.
function(sinew_pkg_config name components links packages)
  list(TRANSFORM components PREPEND sinew- OUTPUT_VARIABLE requires)
  set(libraries "")
  foreach(library IN LISTS links packages)
    set(required "")
    foreach(pair IN LISTS sinew_pkg_config_of)
      if(pair MATCHES "^${library}=(.+)$")
        set(required ${CMAKE_MATCH_1})
      endif()
    endforeach()
    if(BUILD_SHARED_LIBS)
    elseif(required)
      list(APPEND requires ${required})
    elseif(library STREQUAL "Threads::Threads")
      list(APPEND libraries -pthread)
    elseif(library STREQUAL "meshoptimizer")
      list(APPEND libraries -lmeshoptimizer)
    endif()
  endforeach()
  list(REMOVE_DUPLICATES requires)
  list(REMOVE_DUPLICATES libraries)
  list(JOIN requires ", " requires)
  list(JOIN libraries " " libraries)
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/package/sinew-${name}.pc @ONLY CONTENT [[
prefix=${pcfiledir}/@sinew_up@
Name: sinew-@name@
Description: @PROJECT_DESCRIPTION@, component @name@
Version: @PROJECT_VERSION@
Requires: @requires@
Cflags: -I${prefix}/@CMAKE_INSTALL_INCLUDEDIR@@sinew_shared_flag@
Libs: -L${prefix}/@CMAKE_INSTALL_LIBDIR@ -lsinew_@name@ @libraries@
]])
  install(FILES ${PROJECT_BINARY_DIR}/package/sinew-${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT dev)
endfunction()

# One component: a library, the others of ours that it links, and the packages.
set(SINEW_COMPONENTS "")
function(sinew_component name)
  get_target_property(links sinew_${name} LINK_LIBRARIES)
  list(TRANSFORM links REPLACE "^[$]<INSTALL_INTERFACE:(.*)>$" "\\1")
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
  sinew_pkg_config(${name} "${components}" "${links}" "${packages}")
  install(TARGETS sinew_${name} EXPORT sinew_${name}_targets
    ARCHIVE COMPONENT dev
    LIBRARY COMPONENT library NAMELINK_COMPONENT dev
    RUNTIME COMPONENT library)
  install(EXPORT sinew_${name}_targets NAMESPACE sinew:: FILE sinew-${name}.cmake DESTINATION ${sinew_package_dir}
    COMPONENT dev)
  set(SINEW_COMPONENTS ${SINEW_COMPONENTS} ${name} PARENT_SCOPE)
  string(APPEND SINEW_NEEDS "set(sinew_components_of_${name} ${components})\nset(sinew_packages_of_${name} ${packages})\n")
  set(SINEW_NEEDS "${SINEW_NEEDS}" PARENT_SCOPE)
endfunction()
foreach(name IN ITEMS runtime threads compress lod graph procedures springs geometry_cache asset_file c c_assets c_geometry)  # those that others link come before them
  sinew_component(${name})
endforeach()
if(SINEW_IMPORTER)
  sinew_component(importer)
  install(TARGETS sinew COMPONENT tools)
endif()

configure_package_config_file(${PROJECT_SOURCE_DIR}/runtime/sinew-config.cmake.in
  ${PROJECT_BINARY_DIR}/package/sinew-config.cmake INSTALL_DESTINATION ${sinew_package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/sinew-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/package/sinew-config.cmake ${PROJECT_BINARY_DIR}/package/sinew-config-version.cmake
  DESTINATION ${sinew_package_dir} COMPONENT dev)
foreach(component IN ITEMS library dev tools)
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR}/${component} COMPONENT ${component})
endforeach()

# `cpack` writes a Debian package of each component.
set(CPACK_GENERATOR DEB)
set(CPACK_COMPONENTS_ALL dev)
if(BUILD_SHARED_LIBS)
  list(APPEND CPACK_COMPONENTS_ALL library)
endif()
if(SINEW_IMPORTER)
  list(APPEND CPACK_COMPONENTS_ALL tools)
endif()
set(CPACK_PACKAGE_CONTACT "the authors of sinew <sinew@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_DEV_PACKAGE_NAME libsinew-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_TOOLS_PACKAGE_NAME sinew)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libsinew${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
# What the headers include, and what the static libraries are linked with.
set(sinew_dev_needs libglm-dev libexpected-dev)
if(BUILD_SHARED_LIBS)
  list(APPEND sinew_dev_needs "${CPACK_DEBIAN_LIBRARY_PACKAGE_NAME} (= ${PROJECT_VERSION})")
else()
  list(APPEND sinew_dev_needs libhwy-dev libtbb-dev libzstd-dev)
  if(SINEW_IMPORTER)
    list(APPEND sinew_dev_needs libdraco-dev libmeshoptimizer-dev libopenmesh-dev libturbojpeg0-dev libwebp-dev libavif-dev nlohmann-json3-dev)
  endif()
endif()
list(JOIN sinew_dev_needs ", " CPACK_DEBIAN_DEV_PACKAGE_DEPENDS)
include(CPack)
