# SPDX-License-Identifier: MIT
# Unused effects, and joints that a plan leaves out, cost frames no instruction: counts those of 50 frames, without and with many.
function(count effects result)
  file(REMOVE ${OUT}.${effects})
  execute_process(COMMAND ${VALGRIND} --tool=callgrind --instr-atstart=no --callgrind-out-file=${OUT}.${effects} ${PROGRAM} ${effects}
    RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE log)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${PROGRAM} ${effects} under callgrind failed (${status}):\n${said}${log}")
  endif()
  file(STRINGS ${OUT}.${effects} line REGEX "^totals: [0-9]+" LIMIT_COUNT 1)
  string(REGEX MATCH "[0-9]+" instructions "${line}")
  message("${effects} unused effects of each kind: ${instructions} instructions in 50 frames")
  set(${result} ${instructions} PARENT_SCOPE)
endfunction()

set(effects 300)
count(0 without)
count(${effects} with)
math(EXPR more "${with} - ${without}")
if(without LESS 50000)
  message(FATAL_ERROR "too few instructions: nothing was counted")
endif()
# Copies take a few instructions more or less where memory happens to lie elsewhere; one per effect and frame would be 15000.
if(more GREATER 600 OR more LESS -600)
  message(FATAL_ERROR "${effects} unused effects of each kind change 50 frames by ${more} instructions")
endif()
