#pragma once
// The measured images that a run folder kept, each with the reference's: visibilities, or the
// pictures of rounds of radiance.

#include "reports/record/record.hpp"

namespace alcove {

struct KeptPicture {
    std::string round;
    std::string scene;
    std::string cell; ///< its id
    std::string label;
    int frame = 0;
    std::string picture; ///< "visibility" or "picture", or one of a film: "film_visibility"
    std::filesystem::path test;
    std::filesystem::path reference;
};

struct KeptPictures {
    std::vector<KeptPicture> pictures; ///< by round, cell, picture and frame
    std::size_t missing = 0;           ///< that the plan keeps and that are not there
    std::size_t unfinished_rounds = 0; ///< which are left out
};

/// Of the methods' cells of finished rounds. Throws InputError where a picture lies outside of the
/// run folder, by way of a symbolic link.
[[nodiscard]] KeptPictures list_kept_pictures(const RunFolder& run);

} // namespace alcove
