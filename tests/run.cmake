# run(command ...): sets `said` to what it says. Where it fails, this is shown and the script ends.
function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(NOT status EQUAL 0)
    list(JOIN ARGV " " command)
    message(FATAL_ERROR "${command}: ${status}\n${said}")
  endif()
  set(said "${said}" PARENT_SCOPE)
endfunction()
