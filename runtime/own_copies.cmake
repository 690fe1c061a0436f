# SPDX-License-Identifier: MIT
# Archives of this directory hold their own copies of inline functions (see own_copies.sh): what an engine compiles with -ffast-math
# or -mfma does not replace them. SINEW_OWN_COPIES says for tests whether they do.
file(SHA256 ${PROJECT_SOURCE_DIR}/runtime/own_copies.sh version)
set(script ${PROJECT_BINARY_DIR}/own_copies/${version}.sh)  # named by its text: archives are made again when that changes
configure_file(${PROJECT_SOURCE_DIR}/runtime/own_copies.sh ${script} COPYONLY)
set(sinew_own_copies_command sh ${script}
  "${CMAKE_AR}" "${CMAKE_LINKER}" "${CMAKE_OBJCOPY}" "${CMAKE_NM}")

# Answers in REASON why the step cannot be done, empty when a trial with an inline function worked.
function(sinew_why_no_own_copies reason)
  set(folder ${PROJECT_BINARY_DIR}/own_copies)
  file(WRITE ${folder}/trial.cpp "__attribute__((noinline)) inline int* one() { static int i = 1; return &i; }\nint* two() { return one() + 1; }\n")
  set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
  try_compile(compiled ${folder} SOURCES ${folder}/trial.cpp COPY_FILE ${folder}/before.a)
  file(REMOVE ${folder}/after.a)
  execute_process(COMMAND ${CMAKE_AR} x before.a WORKING_DIRECTORY ${folder} OUTPUT_QUIET ERROR_QUIET)
  file(GLOB object ${folder}/trial.cpp.o)
  execute_process(COMMAND ${sinew_own_copies_command} qc ${folder}/after.a ${object} RESULT_VARIABLE status ERROR_VARIABLE said OUTPUT_QUIET)
  execute_process(COMMAND ${CMAKE_NM} ${folder}/after.a OUTPUT_VARIABLE symbols ERROR_QUIET)
  if(NOT status EQUAL 0)
    set(${reason} "${CMAKE_LINKER} or ${CMAKE_OBJCOPY} cannot (binutils 2.29 can): ${said}" PARENT_SCOPE)
  elseif(NOT symbols MATCHES " T _Z3twov" OR symbols MATCHES " [WVu] ")
    set(${reason} "objects are not plain ELF objects" PARENT_SCOPE)
  else()
    set(${reason} "" PARENT_SCOPE)
  endif()
endfunction()

if(SINEW_SANITIZE)
  set(sinew_no_own_copies "sanitizers compare the copies of all objects")
elseif(NOT CMAKE_EXECUTABLE_FORMAT STREQUAL "ELF")
  set(sinew_no_own_copies "not an ELF platform")
elseif(CMAKE_INTERPROCEDURAL_OPTIMIZATION)
  set(sinew_no_own_copies "link-time optimisation merges functions by name before that")
else()
  sinew_why_no_own_copies(sinew_no_own_copies)
endif()

if(sinew_no_own_copies)
  set(SINEW_OWN_COPIES OFF CACHE INTERNAL "")
  message(STATUS "Libraries share copies of inline functions with programs that link them (${sinew_no_own_copies}): "
    "compile all of a program with the same floating-point flags")
else()
  set(SINEW_OWN_COPIES ON CACHE INTERNAL "")
  list(JOIN sinew_own_copies_command " " sinew_own_copies_rule)
  set(CMAKE_CXX_ARCHIVE_CREATE "${sinew_own_copies_rule} qc <TARGET> <OBJECTS>")
  set(CMAKE_CXX_ARCHIVE_APPEND "${sinew_own_copies_rule} q <TARGET> <OBJECTS>")
endif()
