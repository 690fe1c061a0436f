# SPDX-License-Identifier: MIT
# cmake -DSTATUS=2 "-DCOMMAND=program;argument" -P exits_with.cmake: fails unless the program ends with that status.
execute_process(COMMAND ${COMMAND} RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE err)
if(NOT status STREQUAL STATUS)
  message(FATAL_ERROR "exit status ${status}, expected ${STATUS}\n${out}${err}")
endif()
if(NOT STATUS STREQUAL 0 AND err STREQUAL "")
  message(FATAL_ERROR "exit status ${status} without a message on stderr")
endif()
