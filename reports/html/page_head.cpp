#include "reports/html/page_head.hpp"

#include "reports/html/escape.hpp"
#include "reports/html/web_files.hpp"

#include <fmt/core.h>

namespace alcove {

std::string make_page_head(std::string_view title, PageRights rights,
                           std::initializer_list<std::string_view> styles) {
    std::string style(find_web_file("page.css"));
    for (const std::string_view name : styles) {
        style += find_web_file(name);
    }
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; {}style-src "
        "'unsafe-inline'{}\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<meta name=\"color-scheme\" content=\"light dark\">\n"
        "<title>Alcove: {}</title>\n<style>{}</style></head><body>\n",
        rights.shows_pictures ? "img-src 'self' file:; " : "",
        rights.runs_scripts ? "; script-src 'unsafe-inline'" : "", escape_html(title), style);
}

} // namespace alcove
