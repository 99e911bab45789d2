#pragma once
// Where things are kept between runs.

#include <filesystem>

namespace alcove {

/// $ALCOVE_CACHE, else $HOME/.cache/alcove, else a folder among the system's temporary ones. It may
/// not be there yet.
[[nodiscard]] std::filesystem::path get_cache_folder();

/// The folder of models that `alcove scene fetch` has brought, one folder each, by their names.
[[nodiscard]] std::filesystem::path get_fetched_scenes_folder();

} // namespace alcove
