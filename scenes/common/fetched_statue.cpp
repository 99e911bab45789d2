#include "scenes/common/fetched_statue.hpp"

#include "core/base/cache_folder.hpp"
#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "scenes/common/bounds.hpp"
#include "scenes/common/off_file.hpp"

namespace alcove {

Mesh read_fetched_statue(const std::string& name, double height_m) {
    const std::filesystem::path file = get_fetched_scenes_folder() / name / (name + ".off");
    if (!std::filesystem::exists(file)) {
        throw InputError("statue", "the scan has not been fetched", file.string(),
                         "`alcove scene fetch " + name + "` first");
    }
    Mesh mesh = parse_off(read_file(file), file.string());
    Bounds bounds;
    for (const glm::vec3& position : mesh.positions) {
        bounds.add(glm::dvec3(position));
    }
    if (!(bounds.high.y > bounds.low.y)) {
        throw InputError(file.string(), "is flat");
    }
    const double scale = height_m / (bounds.high.y - bounds.low.y);
    const glm::dvec3 foot(bounds.centre().x, bounds.low.y, bounds.centre().z);
    for (glm::vec3& position : mesh.positions) {
        position = glm::vec3(scale * (glm::dvec3(position) - foot));
    }
    mesh.name = name;
    mesh.albedo = {0.62f, 0.57f, 0.5f};
    return mesh;
}

} // namespace alcove
