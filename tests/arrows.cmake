# The layers, read off the includes: who may include whom. cmake -D source=... -P arrows.cmake
#
#   reference/scenes <- reference/truth <- reference/generator, figures     public headers of the
#                                                                            simulation alone
#   lib/simulation   <- lib/analysis, through for_analysis.hpp alone
#   lib/analysis     <- lib/program   <- figures (its progress line)
# Inside the simulation a folder includes only folders before it: chain, flight, stops, chatter, run.
cmake_minimum_required(VERSION 3.21)
set(folders chain flight stops chatter run)

# refuse(where pattern): no file of `where` includes what `pattern` describes.
function(refuse where pattern)
  file(GLOB_RECURSE files ${source}/${where}/*.hpp ${source}/${where}/*.cpp)
  if(NOT files)
    message(SEND_ERROR "${where}: no files")
  endif()
  foreach(file IN LISTS files)
    file(STRINGS ${file} wrong REGEX "^#include [\"<]${pattern}")
    if(wrong)
      message(SEND_ERROR "${file} must not include ${wrong}")
    endif()
  endforeach()
endfunction()

set(inside "(\\.\\./|lib/|figures/|reference/|tests/|program/)")
refuse(lib/simulation "(${inside}|analysis/|simulation/analysis|vibro_impact/analysis/)")
refuse(lib/analysis "(${inside}|simulation/[a-z]+/)")
# Orbits include neither settled motions nor sweeps.
set(sweeping "(vibro_impact/analysis/)?(sweep|settle|orbit_record|lyapunov)")
refuse(lib/analysis/orbits "${sweeping}\\.hpp")
refuse(lib/analysis/orbits "analysis/sweep/")
refuse(lib/program "(\\.\\./|lib/|figures/|reference/|tests/|simulation/|analysis/)")
refuse(lib/include "(\\.\\./|lib/|figures/|reference/|tests/|program/|simulation/|analysis/orbits|analysis/sweep)")
refuse(lib/examples "(\\.\\./|lib/|figures/|reference/|tests/|program/|simulation/|analysis/)")
refuse(figures "(\\.\\./|lib/|tests/|simulation/|analysis/|program/[a-oq-z])")
refuse(reference "(\\.\\./|lib/|figures/|tests/|program/|simulation/|analysis/|vibro_impact/analysis/)")

# A public header of the simulation includes none of the analysis.
file(GLOB headers ${source}/lib/include/vibro_impact/*.hpp)
foreach(header IN LISTS headers)
  file(STRINGS ${header} wrong REGEX "^#include [\"<](vibro_impact/)?analysis/")
  if(wrong)
    message(SEND_ERROR "${header} must not include ${wrong}")
  endif()
endforeach()

set(later ${folders})
foreach(folder IN LISTS folders)
  list(REMOVE_ITEM later ${folder})
  list(JOIN later "|" behind)
  if(behind)
    refuse(lib/simulation/${folder} "(simulation/)?(${behind})/")
  endif()
endforeach()
