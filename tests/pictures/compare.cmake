# Draws the pictures of a script of gnuplot as SVG, in a folder of their own, and compares the digest
# of each (digest.cpp) with the one stored here, or stores it. The tables are those of the driver
# of the script, or of the commands of the program below. Times differ from run to run, so that a script
# beside a table measured.csv draws that.
#
# cmake -D source=... -D build=... -D gnuplot=... -D script=... -D digest=... [-D renew=renew] -P compare.cmake
cmake_minimum_required(VERSION 3.21)
set(ENV{LC_ALL} C.UTF-8)
cmake_path(GET script STEM name)
cmake_path(GET script PARENT_PATH beside)
set(tables ${build}/pictures/${name})
file(REMOVE_RECURSE ${tables})
file(MAKE_DIRECTORY ${tables})

if(name STREQUAL "plot")
  # Versions of gnuplot label other ticks on a logarithmic axis that is shorter or longer than a decade.
  foreach(command
      "run --stop 1:lower:-0.3 --stop 1:upper:0.33 --stop 2:upper:0.1 --from 30 --until 150 --events e.csv --samples s.csv --plot plot_run.svg"
      "run --until 50 --velocities --samples s.csv --portrait plot_portrait.svg"
      "run --until 200P --every 1P --velocities --samples s.csv --portrait plot_section.svg"
      "sweep --vary omega=0.3:0.5:5 --impacts i.csv --plot plot_diagram.svg"
      "sweep --vary omega=0.5:0.3:5 --back --impacts i.csv --plot plot_branches.svg"
      "sweep --omega 0.69 --vary displacement1=-0.6:0.3:4 --vary restitution=0.5:0.9:5 --table t.csv --plot plot_map.svg"
      "sweep --vary omega=0.3:0.5:3 --vary beta=0.1:0.2:2 --response --table t.csv --column rms1 --plot plot_rms.svg"
      "sweep --vary omega=0.3:0.5:3 --vary beta=0.1:0.1:1 --table t.csv --column sticks2 --plot plot_row.svg"
      "orbit --omega 0.6 --vary omega=0.57:0.61:21 --table t.csv --plot plot_branch.svg"
      "sweep --vary omega=0.04:0.4:5:log --section s.csv --panels 2 --plot plot_states.svg")
    separate_arguments(command UNIX_COMMAND "${command}")
    execute_process(COMMAND ${build}/bin/vibro-impact ${command} WORKING_DIRECTORY ${tables}
                    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
else()
  if(EXISTS ${beside}/measured.csv)
    file(COPY_FILE ${beside}/measured.csv ${tables}/${name}.csv)
  else()
    execute_process(COMMAND ${CMAKE_COMMAND} --build ${build} --target tables_${name}
                    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
    file(GLOB written ${build}/figures/${name}*.csv)
    file(COPY ${written} DESTINATION ${tables})
  endif()
  set(kind svg)
  include(${source}/figures/draw.cmake)
endif()

# Pictures that are no longer drawn fail, too.
file(GLOB pictures RELATIVE ${tables} ${tables}/*.svg)
file(GLOB stored RELATIVE ${source}/tests/pictures ${source}/tests/pictures/${name}*.txt)
list(TRANSFORM stored REPLACE "txt$" "svg")
list(APPEND pictures ${stored})
list(REMOVE_DUPLICATES pictures)
foreach(picture IN LISTS pictures)
  cmake_path(GET picture STEM name)
  execute_process(COMMAND ${digest} ${tables}/${picture} ${source}/tests/pictures/${name}.txt ${renew}
                  RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    set(failed ON)
  endif()
endforeach()
if(failed)
  message(FATAL_ERROR "${script} draws other pictures than those stored")
endif()
