#include "scenes/statue/statue.hpp"

#include "scenes/common/bunny_mesh.hpp"
#include "scenes/common/fetched_statue.hpp"
#include "scenes/common/knot.hpp"
#include "scenes/common/pedestal.hpp"
#include "scenes/common/rigid_scene.hpp"
#include "scenes/common/solids.hpp"
#include "scenes/common/walkthrough_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace alcove {
namespace {

enum class Piece { knot, bunny, elephant, armadillo };
enum class Motion { turn, slide, turn_and_slide, rest };

struct StatueParameters {
    Piece piece = Piece::knot;
    Motion motion = Motion::turn;
    double detail = 1.0;
};

ParameterTable make_table() {
    using P = StatueParameters;
    return describe_parameters(
        "statue", {choice(&P::piece, "piece", {"knot", "bunny", "elephant", "armadillo"})
                       .meaning("a carved trefoil knot; the Stanford bunny, which needs the npm "
                                "package `bunny`; or a scan of high polygon count, which `alcove "
                                "scene fetch` brings")
                       .source("ours"),
                   choice(&P::motion, "motion", {"turn", "slide", "turn_and_slide", "rest"})
                       .meaning("by 2 degrees and by 8 mm a frame on frames 10 to 100")
                       .source("ours"),
                   real(&P::detail, "detail")
                       .range(0.05, 32.0)
                       .log_scale()
                       .unit("1")
                       .meaning("number of vertices of the knot and the mouldings, relative to the "
                                "default; scans have their own")
                       .source("ours")});
}

constexpr double kTop = 0.35;   ///< of the plinth, metres
constexpr double kSink = 0.006; ///< of the piece into it: in contact, no two faces in one plane
constexpr double kHeight = 1.0; ///< of a scan, metres
constexpr int kBegin = 10;
constexpr int kEnd = 100;
constexpr double kDegreesAFrame = 2.0;
constexpr double kMetresAFrame = 0.008;
/// From the place at rest.
constexpr double kStart_m = -0.5 * (kEnd - kBegin) * kMetresAFrame;

Mesh make_piece(const StatueParameters& parameters) {
    switch (parameters.piece) {
    case Piece::knot:
        return make_knot(parameters.detail, {0.62f, 0.57f, 0.5f});
    case Piece::bunny:
        return read_bunny("statue");
    case Piece::elephant:
        return read_fetched_statue("elephant", kHeight);
    case Piece::armadillo:
        return read_fetched_statue("armadillo", kHeight);
    }
    std::abort(); // bind() has checked the choice
}

bool does_turn(Motion motion) {
    return motion == Motion::turn || motion == Motion::turn_and_slide;
}
bool does_slide(Motion motion) {
    return motion == Motion::slide || motion == Motion::turn_and_slide;
}

Walkthrough make_walkthrough(Motion motion) {
    Walkthrough walkthrough = get_embedded_walkthrough("scenes/statue/walkthrough.json");
    if (motion == Motion::rest) {
        return walkthrough;
    }
    const int frames = kEnd - kBegin;
    const glm::dvec3 start(does_slide(motion) ? kStart_m : 0.0, 0.0, 0.0);
    ObjectTrack track;
    track.object = "piece";
    track.keys = {{kBegin, start, 0.0},
                  {kEnd, -start, does_turn(motion) ? kDegreesAFrame * frames : 0.0}};
    // The close-up goes around where the piece has arrived.
    for (auto frame = static_cast<std::size_t>(walkthrough.cuts.back());
         frame < walkthrough.cameras.size(); ++frame) {
        walkthrough.cameras[frame].position -= start;
    }
    walkthrough.tracks.push_back(std::move(track));
    return walkthrough;
}

std::unique_ptr<Scene> open_statue(const ResolvedParameters& resolved) {
    const auto parameters = make_table().bind<StatueParameters>(resolved);
    const int rounds = static_cast<int>(std::lround(5.0 * std::sqrt(parameters.detail)));
    RigidSceneContent content;
    content.meshes.push_back(
        make_box_mesh("floor", {0.52f, 0.52f, 0.54f}, {-5.0, -0.3, -5.0}, {5.0, 0.0, 5.0}));
    content.meshes.push_back(
        make_pedestal("plinth", {0.6f, 0.6f, 0.58f}, kTop, 1.3, 0.75, std::clamp(rounds, 2, 40)));
    content.meshes.push_back(make_piece(parameters));
    content.objects = {{"floor", 0}, {"plinth", 1}, {"piece", 2}};
    content.transforms.assign(3, glm::dmat4(1.0));
    content.transforms[2] = glm::translate(glm::dmat4(1.0), {0.0, kTop - kSink, 0.0});
    content.lights.directional.push_back(
        {glm::normalize(glm::dvec3(0.5, 0.9, 0.6)), glm::vec3(1.0f, 0.96f, 0.9f)});
    content.lights.ambient = glm::vec3(0.46f, 0.48f, 0.52f);
    content.walkthrough = make_walkthrough(parameters.motion);
    content.ao_radius_m = 0.25;
    return std::make_unique<RigidScene>(std::move(content));
}

} // namespace

SceneUnit statue_unit() {
    SceneUnit unit;
    unit.name = "statue";
    unit.title = "Statue that turns or slides";
    unit.stresses = "flow of a turning body (its speed grows with the distance from the axis), "
                    "concave carving that occludes itself, a contact that moves along";
    unit.license = "CC0-1.0, built by this program; with piece=bunny unstated, Stanford University "
                   "Computer Graphics Laboratory; other pieces unstated, see licence.json beside "
                   "the fetched file, no pictures of them may be published";
    unit.parameters = make_table();
    unit.open = open_statue;
    return unit;
}

} // namespace alcove
