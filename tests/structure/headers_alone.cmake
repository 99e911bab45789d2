# cmake -P: every public header compiles alone. One that its own source file includes first has been compiled so by the
# build, which takes no time here. COMPILER, ROOT, FLAGS (a list), WORK (a scratch folder).
set(headers "")
foreach(room IN ITEMS core methods metrics scenes reports harness)
  file(GLOB_RECURSE found RELATIVE ${ROOT} ${ROOT}/${room}/*.hpp)
  list(APPEND headers ${found})
endforeach()
list(LENGTH headers count)
if(count LESS 50)
  message(FATAL_ERROR "only ${count} headers found below ${ROOT}")
endif()

# One script a header, so that xargs can run two at a time; a header is included, not compiled as the main file, because
# `#pragma once` in a main file is a warning of its own.
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
set(sources "")
set(built 0)
foreach(header IN LISTS headers)
  string(REGEX REPLACE "\\.hpp$" ".cpp" source ${header})
  if(EXISTS ${ROOT}/${source})
    file(STRINGS ${ROOT}/${source} first_include REGEX "^#include" LIMIT_COUNT 1)
    if(first_include STREQUAL "#include \"${header}\"")
      math(EXPR built "${built} + 1")
      continue()
    endif()
  endif()
  string(REPLACE "/" "__" name ${header})
  file(WRITE ${WORK}/${name}.cpp "#include \"${header}\"\n")
  string(APPEND sources "${WORK}/${name}.cpp\n")
endforeach()
file(WRITE ${WORK}/sources.txt "${sources}")
execute_process(
  COMMAND xargs -P 2 -n 1 ${COMPILER} -std=c++20 -fsyntax-only -I${ROOT} ${FLAGS}
  INPUT_FILE ${WORK}/sources.txt
  ERROR_VARIABLE errors
  RESULT_VARIABLE result)
if(result)
  message(FATAL_ERROR "headers that do not compile alone:\n${errors}")
endif()
message(STATUS "${count} headers compile alone, ${built} of them at the head of their source files")
