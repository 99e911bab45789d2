// Writes dashboards of made-up stores for the browser test (tests/web): FOLDER/steps/dashboard and
// FOLDER/hostile/dashboard.

#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "reports/html/dashboard_page.hpp"
#include "tests/reports/forged_store.hpp"

#include <filesystem>
#include <iostream>

namespace {

void write_dashboard(const std::filesystem::path& folder,
                     const alcove::forged::Scenario& scenario) {
    alcove::Store store(folder / "store.sqlite");
    alcove::forged::append_nights(store, scenario);
    alcove::write_file_atomically(folder / "dashboard" / "index.html",
                                  alcove::make_dashboard_page(store.read()));
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "usage: alcove_write_nights FOLDER\n";
        return 2;
    }
    try {
        const std::filesystem::path folder = argv[1];
        // 25 methods are 200 series.
        write_dashboard(folder / "steps", {.nights = 40,
                                           .methods = 25,
                                           .slower_from = 30,
                                           .image_from = 39,
                                           .new_driver_from = 14});
        write_dashboard(folder / "hostile",
                        {.nights = 12,
                         .image_from = 11,
                         .text = "<img src=x onerror=document.title='owned'>\"'</script><script>"
                                 "document.title='owned'</script>&amp;<!--"});
    } catch (const alcove::Error& error) {
        std::cerr << error.what() << '\n';
        return error.exit_code();
    }
    return 0;
}
