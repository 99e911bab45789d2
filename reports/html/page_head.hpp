#pragma once
// How every page begins.

#include <initializer_list>
#include <string>
#include <string_view>

namespace alcove {

/// What a page may do beside showing itself.
struct PageRights {
    bool shows_pictures = false; ///< of its own folder
    bool runs_scripts = false;   ///< inline ones
};

/// From the document type to the open body. page.css comes first, then `styles`, by the names of
/// embedded files; `title` is escaped here.
[[nodiscard]] std::string make_page_head(std::string_view title, PageRights rights,
                                         std::initializer_list<std::string_view> styles = {});

} // namespace alcove
