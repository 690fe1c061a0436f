# SPDX-License-Identifier: MIT
foreach(asked IN ITEMS "--target=avx9" "--target")
  execute_process(COMMAND ${PROGRAM} ${asked} RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE sentence)
  if(NOT status EQUAL 2 OR NOT sentence MATCHES "^sinew-bench: .*; this machine has .*scalar\n$")
    message(FATAL_ERROR "${asked}: status ${status}, which says: ${said}${sentence}")
  endif()
endforeach()
