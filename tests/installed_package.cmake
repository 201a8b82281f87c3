# Installs the build, builds the examples against the installed package from outside the tree, and
# runs them:
#   cmake -D build=<folder> -D examples=<folder> -D compiler=<path>
#         -D folder=<where they are built> -P installed_package.cmake
# Eigen, fmt and Boost, with which the library was built, are hidden: the package needs none.
set(installed ${build}/installed)

include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

file(REMOVE_RECURSE ${installed} ${folder})
run(${CMAKE_COMMAND} --install ${build} --prefix ${installed})
foreach(document LICENSE README.md)
  file(GLOB_RECURSE found ${installed}/share/${document})
  if(NOT found)
    message(FATAL_ERROR "${document} is not installed")
  endif()
endforeach()
file(GLOB_RECURSE headers ${installed}/include/*)
foreach(header ${headers})
  file(STRINGS ${header} foreign REGEX "#include <(Eigen|fmt|boost)/")
  if(foreign)
    message(FATAL_ERROR "${header}: ${foreign}")
  endif()
endforeach()

run(${CMAKE_COMMAND} -S ${examples} -B ${folder} -DCMAKE_BUILD_TYPE=Release
    -DCMAKE_CXX_COMPILER=${compiler} -DCMAKE_PREFIX_PATH=${installed}
    -DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON -DCMAKE_DISABLE_FIND_PACKAGE_fmt=ON
    -DCMAKE_DISABLE_FIND_PACKAGE_Boost=ON)
run(${CMAKE_COMMAND} --build ${folder})
file(GLOB sources ${examples}/*.cpp)
if(NOT sources)
  message(FATAL_ERROR "${examples}: no examples")
endif()
foreach(source ${sources})
  cmake_path(GET source STEM example)
  run(${CMAKE_COMMAND} -E chdir ${folder} ./${example})
endforeach()

# The same by pkg-config.
find_program(pkg_config pkg-config REQUIRED)
file(GLOB_RECURSE found ${installed}/vibro_impact.pc)
cmake_path(GET found PARENT_PATH pc_folder)
execute_process(COMMAND ${CMAKE_COMMAND} -E env PKG_CONFIG_PATH=${pc_folder}
                        ${pkg_config} --cflags --libs vibro_impact
                OUTPUT_VARIABLE options COMMAND_ERROR_IS_FATAL ANY)
separate_arguments(options UNIX_COMMAND "${options}")
list(GET sources 0 source)
run(${compiler} ${source} -o ${folder}/by_pkg_config ${options})
run(${CMAKE_COMMAND} -E chdir ${folder} ./by_pkg_config)

# The installed program draws without the source tree.
find_program(gnuplot gnuplot)
if(gnuplot)
  run(${CMAKE_COMMAND} -E chdir ${folder} ${installed}/bin/vibro-impact run --until 30
      --samples run.csv --plot run.svg)
  if(NOT EXISTS ${folder}/run.svg)
    message(FATAL_ERROR "vibro-impact run --plot: no picture")
  endif()
endif()
