# The layers, read off the includes: `a <- b` says that b may include a. cmake -D source=... -P arrows.cmake
#
#   reference/scenes <- reference/truth <- reference/numbers <- reference/generator
#                                                               public headers of the simulation
#   reference/truth  <- figures, tests
#   figures/measures <- figures, tests; no other folder of figures includes another one
#   lib/simulation   <- lib/analysis, through for_analysis.hpp alone
#   lib/analysis     <- lib/program   <- figures (its progress line)
# Inside the simulation a folder includes only folders before it: chain, flight, modal, stops,
# chatter, run.
cmake_minimum_required(VERSION 3.21)
set(folders chain flight modal stops chatter run)

# refuse(where pattern [allowed]): no file of `where` includes what `pattern` describes, but for what
# `allowed` does. With `where` ending in a slash, the files of its subfolders may.
function(refuse where pattern)
  if(where MATCHES "/$")
    file(GLOB files ${source}/${where}*.hpp ${source}/${where}*.cpp)
  else()
    file(GLOB_RECURSE files ${source}/${where}/*.hpp ${source}/${where}/*.cpp)
  endif()
  if(NOT files)
    message(SEND_ERROR "${where}: no files")
  endif()
  foreach(file IN LISTS files)
    file(STRINGS ${file} wrong REGEX "^#include [\"<]${pattern}")
    if(ARGN)
      list(FILTER wrong EXCLUDE REGEX "${ARGN}")
    endif()
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
refuse(figures "(\\.\\./|lib/|tests/|simulation/|analysis/|program/)" "program/progress\\.hpp")
refuse(reference "(\\.\\./|lib/|figures/|tests/|program/|simulation/|analysis/|vibro_impact/analysis/)")
refuse(reference/scenes "(figures|reference/(truth|numbers|generator))/")
refuse(reference/truth "reference/(numbers|generator)/")
# The questions to the two engines include nothing of either: scenes, tables, and the kinds of events.
refuse(reference/numbers "vibro_impact/" "vibro_impact/event\\.hpp")
refuse(reference/numbers "reference/(generator|truth/e)")
# The generator takes scenes, the names of their fields, cases and the kinds of events from the
# project, and reads tables. It shares no true events.
refuse(reference/generator "vibro_impact/" "vibro_impact/(event|scene_fields)\\.hpp")
refuse(reference/generator "reference/truth/e" "reference/truth/extreme_cases\\.hpp")
# A folder of figures may include the files that all drivers share.
refuse(figures "(figures/)?(check|stability)/")
foreach(folder / /check /measures /stability)
  refuse(figures${folder} "(figures/)?error_vs_runtime/")
endforeach()
refuse(figures/measures "figures/")

# No line of these files may match the expression.
function(refuse_lines expression rule)
  foreach(file IN LISTS ARGN)
    file(STRINGS ${file} wrong REGEX "${expression}")
    if(wrong)
      message(SEND_ERROR "${file}: ${wrong}: ${rule}")
    endif()
  endforeach()
endfunction()

# Tests of two users, or of two builds, share no file.
file(GLOB_RECURSE files ${source}/tests/*.?pp)
refuse_lines("TempDir|\"/tmp" "must be a folder of the build, or one of mkdtemp" ${files})

# A public header of the simulation includes none of the analysis.
file(GLOB files ${source}/lib/include/vibro_impact/*.hpp)
refuse_lines("^#include [\"<](vibro_impact/)?analysis/" "is of the analysis" ${files})

# Another impact law is a change of impact_law.hpp alone: no file of the library takes the coefficient
# of a law but those that check it and that give it a name.
file(GLOB_RECURSE files ${source}/lib/simulation/*.?pp ${source}/lib/analysis/*.?pp)
list(FILTER files EXCLUDE REGEX "/(scene|parameter)\\.cpp$")
refuse_lines("(\\.|->)restitution" "must ask the impact law" ${files})

set(later ${folders})
foreach(folder IN LISTS folders)
  list(REMOVE_ITEM later ${folder})
  list(JOIN later "|" behind)
  if(behind)
    refuse(lib/simulation/${folder} "(simulation/)?(${behind})/")
  endif()
endforeach()

# The header of all headers includes each of them, but itself.
foreach(all vibro_impact analysis/analysis)
  cmake_path(GET all PARENT_PATH folder)
  file(GLOB headers ${source}/lib/include/vibro_impact/${folder}/*.hpp)
  file(READ ${source}/lib/include/vibro_impact/${all}.hpp text)
  foreach(header IN LISTS headers)
    cmake_path(GET header FILENAME name)
    string(FIND "${text}" "#include \"${name}\"" place)
    if(place EQUAL -1 AND NOT "${all}.hpp" MATCHES "(^|/)${name}$")
      message(SEND_ERROR "${all}.hpp does not include ${name}")
    endif()
  endforeach()
endforeach()
