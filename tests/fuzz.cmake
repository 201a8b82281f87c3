# The fuzz target alone, in a build folder of its own: `make fuzz`.
if(NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  message(FATAL_ERROR "VIBRO_IMPACT_FUZZ needs clang (-DCMAKE_CXX_COMPILER=clang++), "
                      "not ${CMAKE_CXX_COMPILER_ID}")
endif()
target_compile_options(vibro_impact PRIVATE -g -O1 -fsanitize=fuzzer-no-link,address,undefined
                                            -fno-sanitize-recover=all)
add_executable(fuzz_options tests/fuzz_options.cpp lib/runner/options.cpp)
target_include_directories(fuzz_options PRIVATE figures lib/runner)
target_compile_options(fuzz_options PRIVATE -g -O1 -fsanitize=fuzzer,address,undefined
                                            -fno-sanitize-recover=all)
target_link_options(fuzz_options PRIVATE -fsanitize=fuzzer,address,undefined)
target_link_libraries(fuzz_options PRIVATE vibro_impact project_options CLI11::CLI11)
