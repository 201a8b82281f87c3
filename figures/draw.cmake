# Runs a script of gnuplot on the tables in a folder. A warning is an error: a column that is not in
# a table would leave its curve out.
if(NOT gnuplot)
  message(FATAL_ERROR "${script}: drawing needs gnuplot, which CMake did not find")
endif()
execute_process(
  COMMAND ${CMAKE_COMMAND} -E env LC_ALL=C.UTF-8 ${gnuplot} -e "data='${tables}'; kind='${kind}'" ${script}
  RESULT_VARIABLE status ERROR_VARIABLE error)
if(NOT status EQUAL 0 OR error MATCHES "warning")
  message(FATAL_ERROR "${script}: ${error}")
endif()
