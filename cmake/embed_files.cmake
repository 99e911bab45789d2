# Run at build time: FILES -> OUTPUT, a .cpp with a table of their texts.
set(text "// Generated from the tree by cmake/embed_files.cmake.\n#include \"core/base/embedded_file.hpp\"\n\n#include <array>\n\nnamespace alcove {\n\nstd::span<const EmbeddedFile> ${FUNCTION}() {\n    static constexpr std::array kFiles{\n")
foreach(file IN LISTS FILES)
  file(READ ${file} body)
  file(RELATIVE_PATH name ${ROOT} ${file})
  string(APPEND text "        EmbeddedFile{\"${name}\", R\"~~~~(${body})~~~~\"},\n")
endforeach()
string(APPEND text "    };\n    return kFiles;\n}\n\n} // namespace alcove\n")
file(WRITE ${OUTPUT} "${text}")
