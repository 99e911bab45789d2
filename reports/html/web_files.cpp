#include "reports/html/web_files.hpp"

#include "core/base/assert.hpp"
#include "core/base/embedded_file.hpp"

#include <algorithm>

namespace alcove {

/// Generated from reports/web.
std::span<const EmbeddedFile> report_web_files();

std::string_view find_web_file(std::string_view name) {
    const auto files = report_web_files();
    const auto found = std::find_if(files.begin(), files.end(), [&](const EmbeddedFile& file) {
        return file.name.ends_with(name);
    });
    ALCOVE_ASSERT(found != files.end(), "an embedded file of reports/web");
    return found->text;
}

} // namespace alcove
