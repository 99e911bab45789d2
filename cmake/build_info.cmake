# Run at build time: INPUTS, COMPILER, FLAGS -> OUTPUT, the build's identity and those of its parts.
function(hash_inputs result pattern)
  set(all "${COMPILER}\n${FLAGS}\n")
  foreach(file IN LISTS INPUTS)
    file(RELATIVE_PATH name ${ROOT} ${file})
    if(NOT IS_DIRECTORY ${file} AND name MATCHES "${pattern}")
      file(SHA256 ${file} digest)
      string(APPEND all "${name} ${digest}\n")
    endif()
  endforeach()
  string(SHA256 id "${all}")
  string(SUBSTRING "${id}" 0 16 id)
  set(${result} ${id} PARENT_SCOPE)
endfunction()

list(SORT INPUTS)
hash_inputs(id ".")
hash_inputs(frame_id "^core/(base|contract|frame|gl)/")
hash_inputs(capture_id "^(core/|harness/run/[a-z_]*[.](cpp|hpp)$)")
string(STRIP "${FLAGS}" FLAGS)
file(WRITE ${OUTPUT} "// Generated from the tree by cmake/build_info.cmake.
#include \"harness/run/build_info.hpp\"

namespace alcove {

BuildInfo get_build_info() {
    return {\"${id}\", \"${COMPILER}\", \"${FLAGS}\", \"${BUILD_TYPE}\", \"${frame_id}\", \"${capture_id}\"};
}

} // namespace alcove
")
