# Runs the quick figure drivers and compares their tables with the run stored in the repository.
# cmake -D programs=... -D folder=... -D drivers=a,b,... -P stored_run.cmake
string(REPLACE "," ";" names "${drivers}")
file(REMOVE_RECURSE ${folder})
foreach(name ${names})
  execute_process(COMMAND ${programs}/${name} --output ${folder} RESULT_VARIABLE failed)
  if(failed)
    message(FATAL_ERROR "${name} ended with status ${failed}")
  endif()
endforeach()
execute_process(COMMAND ${programs}/provenance --output ${folder} --drivers ${drivers}
                RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "the tables are not those of the stored run")
endif()
