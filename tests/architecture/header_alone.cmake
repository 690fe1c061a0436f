# SPDX-License-Identifier: MIT
# sinew_headers_alone(FOLDER [EXCLUDE regex] [PRECOMPILED headers...] LIBRARIES ...): every header of the folder compiles alone, with no
# more than what the libraries give to those who link them (header_alone.py).
function(sinew_headers_alone folder)
  cmake_parse_arguments(arg "" "EXCLUDE" "LIBRARIES;PRECOMPILED" ${ARGN})
  string(REPLACE "/" "-" name "${folder}")
  add_library(sinew-headers-alone-${name} INTERFACE)
  target_link_libraries(sinew-headers-alone-${name} INTERFACE ${arg_LIBRARIES} sinew_flags)
  set(folders $<TARGET_PROPERTY:sinew-headers-alone-${name},INTERFACE_INCLUDE_DIRECTORIES>)
  set(definitions $<TARGET_PROPERTY:sinew-headers-alone-${name},INTERFACE_COMPILE_DEFINITIONS>)
  if(arg_EXCLUDE)
    set(arg_EXCLUDE --exclude ${arg_EXCLUDE})
  endif()
  add_test(NAME architecture/header_alone.${name}
    COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/header_alone.py ${PROJECT_SOURCE_DIR} ${folder}
      --headers ${arg_PRECOMPILED} ${arg_EXCLUDE} --work ${CMAKE_CURRENT_BINARY_DIR}/alone/${name} --
      ${CMAKE_CXX_COMPILER} -std=c++20 -w "-I$<JOIN:${folders},;-I>" "$<$<BOOL:${definitions}>:-D$<JOIN:${definitions},;-D>>"
    COMMAND_EXPAND_LISTS)
  set_tests_properties(architecture/header_alone.${name} PROPERTIES TIMEOUT 600 COST 20 PROCESSORS 2)
endfunction()
