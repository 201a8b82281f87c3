# The library without what only its other parts need is configured: by itself, and inside a project
# of a user's by add_subdirectory, whose targets keep their names. (That it builds and links, the
# whole build and installed_package show: the same files.)
# cmake -D source=... -D program=<a C++ file> -D compiler=... -D folder=... -P library_alone.cmake
file(REMOVE_RECURSE ${folder})
set(without "")
foreach(package CLI11 fmt GTest OpenMP MPI benchmark)
  list(APPEND without -DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
endforeach()

include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

run(${CMAKE_COMMAND} -S ${source} -B ${folder}/alone -DCMAKE_CXX_COMPILER=${compiler} ${without})

file(WRITE ${folder}/user/CMakeLists.txt "cmake_minimum_required(VERSION 3.21)
project(user LANGUAGES CXX)
add_library(project_options INTERFACE)
add_subdirectory(${source} vibro_impact)
add_executable(program ${program})
target_link_libraries(program PRIVATE vibro_impact::simulation)
")
run(${CMAKE_COMMAND} -S ${folder}/user -B ${folder}/build -DCMAKE_CXX_COMPILER=${compiler}
    ${without})
