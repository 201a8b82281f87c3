# The library without what only its other parts need is configured: by itself, and inside a project
# of a user's by add_subdirectory, whose targets keep their names. (That it builds and links, the
# whole build and installed_package show: the same files.) What is left out is named.
# cmake -D source=... -D program=<a C++ file> -D compiler=... -D folder=... -P library_alone.cmake
file(REMOVE_RECURSE ${folder})
set(without "")
foreach(package CLI11 fmt GTest OpenMP)
  list(APPEND without -DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
endforeach()

include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

run(${CMAKE_COMMAND} -S ${source} -B ${folder}/alone -DCMAKE_CXX_COMPILER=${compiler} ${without})
if(NOT said MATCHES "program vibro-impact, the figures[ \n]+and the tests are left out")
  message(SEND_ERROR "without CLI11 and fmt, CMake does not say that the program is left out:\n${said}")
endif()

file(WRITE ${folder}/user/CMakeLists.txt "cmake_minimum_required(VERSION 3.21)
project(user LANGUAGES CXX)
add_library(project_options INTERFACE)
add_subdirectory(${source} vibro_impact)
add_executable(program ${program})
target_link_libraries(program PRIVATE vibro_impact::simulation)
get_target_property(type vibro_impact_analysis TYPE)
message(STATUS \"type \${type}\")
")
foreach(type STATIC SHARED)
  set(shared OFF)
  if(type STREQUAL "SHARED")
    set(shared ON)
  endif()
  run(${CMAKE_COMMAND} -S ${folder}/user -B ${folder}/build -DCMAKE_CXX_COMPILER=${compiler}
      -DBUILD_SHARED_LIBS=${shared} ${without})
  if(NOT said MATCHES "type ${type}_LIBRARY")
    message(SEND_ERROR "BUILD_SHARED_LIBS=${shared}: no ${type} library:\n${said}")
  endif()
endforeach()
# Without a build type, as here, the libraries are optimised all the same.
file(READ ${folder}/build/compile_commands.json commands)
string(REGEX MATCHALL "\"command\"[^\n]*/vibro_impact_[a-z]+\\.dir/[^\n]*" commands "${commands}")
list(LENGTH commands count)
list(FILTER commands EXCLUDE REGEX " -O2 ")
if(count LESS 2 OR commands)
  message(SEND_ERROR "of ${count} sources of the library these are compiled without -O2:\n${commands}")
endif()

# `cmake --install` also works after a build without the program.
file(READ ${build}/lib/program/cmake_install.cmake rules)
if(NOT rules MATCHES "TYPE EXECUTABLE OPTIONAL FILES \"[^\"]*/vibro-impact\"")
  message(SEND_ERROR "the installation fails where the program is not built")
endif()

# -ffast-math is refused in one sentence.
execute_process(COMMAND ${compiler} -std=c++20 -ffast-math -fsyntax-only -x c++
                        ${source}/lib/simulation/chain/twofold.hpp
                RESULT_VARIABLE status ERROR_VARIABLE message)
if(status EQUAL 0 OR NOT message MATCHES "#error \"-ffast-math|error: \"-ffast-math")
  message(SEND_ERROR "-ffast-math is not refused: ${message}")
endif()
