# Run at build time: INPUTS, COMPILER, FLAGS -> OUTPUT, the build's identity.
set(all "${COMPILER}\n${FLAGS}\n")
list(SORT INPUTS)
foreach(file IN LISTS INPUTS)
  if(NOT IS_DIRECTORY ${file})
    file(SHA256 ${file} digest)
    file(RELATIVE_PATH name ${ROOT} ${file})
    string(APPEND all "${name} ${digest}\n")
  endif()
endforeach()
string(SHA256 id "${all}")
string(SUBSTRING "${id}" 0 16 id)
string(STRIP "${FLAGS}" FLAGS)
file(WRITE ${OUTPUT} "// Generated from the tree by cmake/build_info.cmake.
#include \"harness/run/build_info.hpp\"

namespace alcove {

BuildInfo get_build_info() {
    return {\"${id}\", \"${COMPILER}\", \"${FLAGS}\", \"${BUILD_TYPE}\"};
}

} // namespace alcove
")
