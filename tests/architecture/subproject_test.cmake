# SPDX-License-Identifier: MIT
# An engine that builds sinew with itself, by add_subdirectory and by FetchContent: what that changes, what it installs, and one build of
# it, with shared libraries, in which CMake joins the sources of several folders (CMAKE_UNITY_BUILD). That build has little to compile: no
# optimisation, one instruction set.
cmake_minimum_required(VERSION 3.25)
function(step)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT status EQUAL 0)
    list(JOIN ARGN " " line)
    message(FATAL_ERROR "failed (${status}): ${line}\n${out}${err}")
  endif()
endfunction()

file(REMOVE_RECURSE ${SCRATCH})
set(engine ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/subproject -G Ninja -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER})
step(${engine} -B ${SCRATCH}/fetched -DBY=FetchContent -DFETCHCONTENT_SOURCE_DIR_SINEW=${SINEW} -DFETCHCONTENT_FULLY_DISCONNECTED=ON
  -DCMAKE_DISABLE_FIND_PACKAGE_TBB=ON)
step(${engine} -B ${SCRATCH}/added -DBY=add_subdirectory -DSINEW=${SINEW} -DCMAKE_UNITY_BUILD=ON -DBUILD_SHARED_LIBS=ON "-DCMAKE_CXX_FLAGS=-O0 -ffast-math -DHWY_COMPILE_ONLY_STATIC")

execute_process(COMMAND ninja -C ${SCRATCH}/fetched -n OUTPUT_VARIABLE steps)
string(REGEX MATCH "\\[1/([0-9]+)\\]" first "${steps}")
message("an engine with sinew is built in ${CMAKE_MATCH_1} steps")
if(NOT CMAKE_MATCH_1 OR CMAKE_MATCH_1 GREATER 200)
  message(FATAL_ERROR "an engine with sinew takes ${CMAKE_MATCH_1} steps to build")
endif()

step(ninja -C ${SCRATCH}/added)
step(${SCRATCH}/added/engine)
file(GLOB_RECURSE shared RELATIVE ${SCRATCH}/added/sinew/runtime ${SCRATCH}/added/sinew/runtime/*.so.*)
if(CMAKE_HOST_UNIX AND NOT "libsinew_runtime.so.0.1" IN_LIST shared)
  message(FATAL_ERROR "shared libraries have no versioned name: ${shared}")
endif()
step(${CMAKE_COMMAND} --install ${SCRATCH}/added --prefix ${SCRATCH}/installed)
file(GLOB_RECURSE installed RELATIVE ${SCRATCH}/installed ${SCRATCH}/installed/*)
if(NOT installed STREQUAL "bin/engine")
  message(FATAL_ERROR "an engine with sinew installs ${installed}")
endif()
