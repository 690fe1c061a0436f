# SPDX-License-Identifier: MIT
# cmake -DFIRST=program -DSECOND=program -P same_output.cmake: fails unless both end with status 0 and print the same text.
foreach(program IN ITEMS FIRST SECOND)
  execute_process(COMMAND ${${program}} RESULT_VARIABLE status OUTPUT_VARIABLE ${program}_said)
  if(NOT status EQUAL 0 OR ${program}_said STREQUAL "")
    message(FATAL_ERROR "${${program}}: exit status ${status}\n${${program}_said}")
  endif()
endforeach()
if(NOT FIRST_said STREQUAL SECOND_said)
  message(FATAL_ERROR "${FIRST} prints\n${FIRST_said}${SECOND} prints\n${SECOND_said}")
endif()
