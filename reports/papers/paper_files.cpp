#include "reports/papers/paper_files.hpp"

#include "core/base/assert.hpp"

namespace alcove {

std::string_view find_paper_file(std::string_view name) {
    for (const EmbeddedFile& file : embedded_papers()) {
        if (file.name == name) {
            return file.text;
        }
    }
    ALCOVE_ASSERT(false, "a file of this room");
    return {};
}

} // namespace alcove
