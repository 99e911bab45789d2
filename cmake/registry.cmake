# Run at build time: the room's list of UNITS -> OUTPUT, its registry.cpp.
function(hash_folder folder result)
  file(GLOB files ${ROOT}/${folder}/*)
  list(SORT files)
  set(all "")
  foreach(file IN LISTS files)
    if(NOT IS_DIRECTORY ${file})
      file(SHA256 ${file} digest)
      get_filename_component(name ${file} NAME)
      string(APPEND all "${name} ${digest}\n")
    endif()
  endforeach()
  string(SHA256 digest "${all}")
  set(${result} ${digest} PARENT_SCOPE)
endfunction()

set(common "")
foreach(folder IN LISTS COMMON)
  hash_folder(${folder} digest)
  string(APPEND common "${digest}\n")
endforeach()

set(includes "")
set(entries "")
foreach(unit IN LISTS UNITS)
  hash_folder(${ROOM}/${unit} own)
  string(SHA256 digest "${own}\n${common}")
  string(APPEND includes "#include \"${ROOM}/${unit}/${unit}.hpp\"\n")
  string(APPEND entries "    add(${unit}_unit(), \"${unit}\", \"${digest}\");\n")
endforeach()
file(WRITE ${OUTPUT} "// Generated from ${ROOM}/CMakeLists.txt by cmake/registry.cmake.
#include \"${ROOM}/registry.hpp\"

${includes}
namespace alcove {

Registry<${UNIT_TYPE}> ${ROOM}_registry() {
    std::vector<${UNIT_TYPE}> units;
    const auto add = [&units](${UNIT_TYPE} unit, const char* folder, const char* hash) {
        unit.folder = folder;
        unit.content_hash = hash;
        units.push_back(std::move(unit));
    };
${entries}    return Registry<${UNIT_TYPE}>{\"${ROOM}\", std::move(units)};
}

} // namespace alcove
")
