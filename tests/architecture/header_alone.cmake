# SPDX-License-Identifier: MIT
# Every header compiles alone, with no more than what its target gives to those who link it. A header x.h beside an x.cpp is compiled
# there: include_direction_test holds that it is included first. For the others sources are generated, one per header, which includes it
# twice. standard_includes_test holds that what a precompiled header brings to both is included. They are built by the test, not by
# default.
function(sinew_headers_alone folder)
  cmake_parse_arguments(arg "" "" "EXCLUDE;LIBRARIES" ${ARGN})
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/${folder}/*.h)
  set(sources)
  foreach(header IN LISTS headers)
    set(skip FALSE)
    foreach(pattern IN LISTS arg_EXCLUDE)
      if(header MATCHES "${pattern}")
        set(skip TRUE)
      endif()
    endforeach()
    string(REGEX REPLACE "\\.h$" ".cpp" own ${PROJECT_SOURCE_DIR}/${header})
    if(EXISTS ${own})
      file(STRINGS ${own} several_times REGEX "foreach_target\\.h")  # a kernel: Highway's header comes first there
      if(NOT several_times)
        set(skip TRUE)
      endif()
    endif()
    if(skip)
      continue()
    endif()
    string(REPLACE "/" "__" stem "${header}")
    set(source ${CMAKE_CURRENT_BINARY_DIR}/alone/${stem}.cpp)
    set(content "#include \"${header}\"\n#include \"${header}\"\n")
    file(CONFIGURE OUTPUT ${source} CONTENT "${content}" @ONLY)
    list(APPEND sources ${source})
  endforeach()
  string(REPLACE "/" "-" name "${folder}")
  add_library(sinew-headers-alone-${name} OBJECT EXCLUDE_FROM_ALL ${sources})
  target_include_directories(sinew-headers-alone-${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(sinew-headers-alone-${name} PRIVATE ${arg_LIBRARIES} sinew_flags)
  target_compile_options(sinew-headers-alone-${name} PRIVATE -O0)   # nothing of them is ever run
  sinew_precompile(sinew-headers-alone-${name})
  add_test(NAME architecture/header_alone.${name}
    COMMAND ${CMAKE_COMMAND} --build ${CMAKE_BINARY_DIR} --target sinew-headers-alone-${name})
  set_tests_properties(architecture/header_alone.${name} PROPERTIES RESOURCE_LOCK build_folder TIMEOUT 600 COST 20)
endfunction()
