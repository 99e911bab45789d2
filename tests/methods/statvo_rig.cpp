#include "tests/methods/statvo_rig.hpp"

#include <cmath>
#include <random>

#include <glm/geometric.hpp>

namespace alcove {

StatvoScene make_statvo_scene(ImageSize size) {
    StatvoScene scene{make_wall_image(size, 1.0f), Image(size, 1, INFINITY)};
    DepthImage& image = scene.visible;
    std::minstd_rand random(5);
    const auto draw = [&random] { return static_cast<double>(random() % 100003u) / 100003.0; };
    const glm::dvec3 floor_normal = glm::normalize(glm::dvec3(0.05, 1.0, 0.1));
    const glm::dvec3 wall_normal = glm::normalize(glm::dvec3(0.4, 0.05, 1.0));
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const glm::dvec3 d = compute_pixel_direction(image.camera, size, {x + 0.5, y + 0.5});
            const double to_wall =
                glm::dot(glm::dvec3(0.0, 0.0, -4.0), wall_normal) / glm::dot(d, wall_normal);
            const double to_floor =
                glm::dot(glm::dvec3(0.0, -1.0, 0.0), floor_normal) / glm::dot(d, floor_normal);
            const bool is_floor = to_floor > 0.0 && to_floor < to_wall;
            double depth = (is_floor ? to_floor : to_wall) + 0.02 * draw();
            glm::dvec3 normal = is_floor ? floor_normal : wall_normal;
            const bool is_window = !is_floor && x > size.width * 3 / 4 && y < size.height / 3;
            depth = is_window ? INFINITY : depth;
            const bool is_post = x >= 6 && x < 9;
            const bool is_block = x >= 17 && x < 27 && y > size.height / 2;
            if (is_post || is_block) {
                scene.hidden.at(x, y) = static_cast<float>(depth);
                depth = (is_post ? 1.9 : 2.6) + 0.02 * draw();
                normal = {0.0, 0.0, 1.0};
            }
            image.depth.at(x, y) = static_cast<float>(depth);
            for (int c = 0; c < 3; ++c) {
                image.normal.at(x, y, c) = static_cast<float>(normal[c]);
            }
        }
    }
    return scene;
}

RigResult StatvoRig::run_peeled(const MethodUnit& unit, const ResolvedParameters& resolved,
                                const DepthImage& visible, const Image& hidden) {
    const ImageSize size = visible.depth.size();
    const GBuffer gbuffer(gl(), size, {Channel::eye_depth, Channel::normal}, {});
    const GBuffer second(gl(), size, {Channel::eye_depth}, {});
    gl::write_texture(gl(), gbuffer.texture(Channel::eye_depth), visible.depth);
    gl::write_texture(gl(), gbuffer.texture(Channel::normal), visible.normal);
    gl::write_texture(gl(), second.texture(Channel::eye_depth), hidden);
    const std::unique_ptr<Method> method = unit.create(context(), resolved);
    method->resize(size);
    FrameView view;
    view.camera = visible.camera;
    view.previous_camera = visible.camera;
    view.size = size;
    context().reset_state();
    MethodInputs inputs{view, gbuffer};
    if (method->get_requests().layers > 1) {
        inputs.layers = {&second};
    }
    PassRecorder passes(PassTiming::none);
    const MethodOutput output = method->render(inputs, passes);
    return {gl::read_texture(gl(), *output.visibility, 1),
            gl::read_texture(gl(), gbuffer.texture(Channel::normal), 3), passes.names()};
}

std::string StatvoRig::describe(const Overrides& settings) {
    std::string text;
    for (const auto& [name, value] : settings) {
        text += (text.empty() ? "" : ",") + name + "=" + value;
    }
    return text;
}

} // namespace alcove
