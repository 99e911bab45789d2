#pragma once
// Reader of OFF files (Object File Format of Geomview): the form that scanned statues come in.

#include "core/contract/scene.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>

namespace alcove {

/// "OFF", the numbers of vertices, faces and edges, then x y z a vertex and n i1 .. in a face, a
/// line each; what follows a face on its line (a color) is left aside, as are empty lines and
/// comments from # on. Polygons become fans; normals are smooth, averages of the faces by angle;
/// faces without area are left out. The mesh is never called closed: nobody vouches for a file.
/// `where` is what errors call the text. Throws InputError with the line on anything else: fewer
/// lines than promised, indices out of range, numbers that are not finite or beyond 1e9, polygons
/// of fewer than 3 or more than 64 corners.
[[nodiscard]] Mesh parse_off(std::string_view text, std::string_view where);

struct OffOptions {
    /// Radius of interest in metres, > 0; by default 5 % of the diagonal of the bounding box.
    std::optional<double> ao_radius_m;
    /// A walkthrough_file in the coordinates of the file; its tracks move the object "model". By
    /// default the camera circles the model in 120 frames.
    std::optional<std::filesystem::path> walkthrough;
};

/// A file as a scene of one object, "model"; one unit is a metre. Throws InputError as parse_off
/// and read_walkthrough_file do, and on files of more than 1 GiB.
[[nodiscard]] std::unique_ptr<Scene> open_off_scene(const std::filesystem::path& path,
                                                    const OffOptions& options = {});

} // namespace alcove
