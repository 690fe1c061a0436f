# SPDX-License-Identifier: MIT
# cmake -DINCLUDE=build/include -DLIST=public_headers.txt -DCOMPILER=c++ -DSOURCE=tree
#   "-DOTHERS=include folders" -P public_headers_alone.cmake
# Each public header compiles alone and is small enough: the lines that a compiler reads for it, without comments and blank ones,
# are the cost of including it. They are counted, since times differ from run to run.
cmake_minimum_required(VERSION 3.25)
set(most_lines 88000)
set(most_lines_of_frame.h 40000)  # by far the most often included
set(most_lines_of_fwd.h 300)
set(most_lines_of_frame_hash.h 35000)
set(most_lines_of_result.h 36000)
foreach(name IN ITEMS sinew.h sinew_assets.h sinew_geometry.h sinew_import.h)
  set(most_lines_of_${name} 1500)
endforeach()
foreach(name IN ITEMS materials.h math.h mesh.h skeleton.h vrm.h)
  set(most_lines_of_${name} 46000)
endforeach()

file(STRINGS ${LIST} pairs)
set(names "")
while(pairs)
  list(POP_FRONT pairs name source)
  list(APPEND names ${name})
endwhile()
file(GLOB there RELATIVE ${INCLUDE}/sinew LIST_DIRECTORIES FALSE ${INCLUDE}/sinew/*)
list(SORT names)
list(SORT there)
if(NOT there STREQUAL names)
  message(FATAL_ERROR "include/sinew has ${there}, and the list names ${names}")
endif()

set(folders -I${INCLUDE})
list(REMOVE_ITEM OTHERS ${INCLUDE} ${SOURCE})  # of the tree itself
foreach(folder IN LISTS OTHERS)
  list(APPEND folders -idirafter ${folder})
endforeach()
set(scratch ${CMAKE_CURRENT_BINARY_DIR}/public_headers_alone)
foreach(name IN LISTS names)
  if(name MATCHES "^sinew")  # the C interface, to the letter of C11
    file(WRITE ${scratch}.c "#include <sinew/${name}>\n#include <sinew/${name}>\n")
    execute_process(COMMAND ${COMPILER} -x c -std=c11 -pedantic -Wall -Wextra -Wstrict-prototypes -Werror ${folders} -fsyntax-only ${scratch}.c
      COMMAND_ERROR_IS_FATAL ANY)
  endif()
  file(WRITE ${scratch}.cpp "#include <sinew/${name}>\n#include <sinew/${name}>\n")
  execute_process(COMMAND ${COMPILER} -std=c++20 -Wall -Wextra -Werror ${folders} -fsyntax-only ${scratch}.cpp COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${COMPILER} -std=c++20 ${folders} -E -P ${scratch}.cpp OUTPUT_FILE ${scratch}.txt COMMAND_ERROR_IS_FATAL ANY)
  file(READ ${scratch}.txt text)
  string(REGEX REPLACE "[^\n]+" "" ends "${text}")
  string(LENGTH "${ends}" count)
  set(most ${most_lines})
  if(DEFINED most_lines_of_${name})
    set(most ${most_lines_of_${name}})
  endif()
  message("${name}: ${count} lines")
  if(count GREATER most)
    message(SEND_ERROR "<sinew/${name}> costs ${count} lines, more than ${most}")
  endif()
endforeach()
