# Recomputes a table of reference/ with the generator, into a file of its own, and compares it with
# the stored one byte for byte.
execute_process(COMMAND ${generator} ${table} ${output} RESULT_VARIABLE status ERROR_VARIABLE report)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${generator} ${table}: ${report}")
endif()
execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${output} ${stored}
                RESULT_VARIABLE differs)
if(differs)
  message(FATAL_ERROR "${table}: ${output} differs from ${stored}")
endif()
