#include "methods/common/path_tracer.hpp"

#include "core/base/assert.hpp"
#include "methods/common/falloff_weight.hpp"
#include "methods/common/ray_directions.hpp"
#include "methods/common/run_on_threads.hpp"
#include "methods/common/sobol.hpp"
#include "methods/common/surface_albedo.hpp"
#include "methods/common/traced_scene.hpp"
#include "methods/common/traced_surface.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include <embree3/rtcore.h>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace alcove {
namespace {

constexpr unsigned kBundle = SobolBundles::kPoints;
constexpr float kInversePi = std::numbers::inv_pi_v<float>;
constexpr float kFarthest = std::numeric_limits<float>::infinity();
/// Of the way to a point light: a lamp may lie on what holds it.
constexpr float kWayToPoint = 1.0f - 0x1p-12f;

/// The way from a surface to a light; nothing beyond `length` of it is in the way.
struct LightWay {
    glm::vec3 direction;
    float length;
};

LightWay find_way(const DirectionalLight& light, const glm::vec3& /*from*/) {
    return {glm::vec3(light.to_light), kFarthest};
}

LightWay find_way(const PointLight& light, const glm::vec3& from) {
    return {glm::vec3(light.position - glm::dvec3(from)), kWayToPoint};
}

glm::vec3 light_surface(const DirectionalLight& light, const TracedSurface& surface) {
    return compute_irradiance(light, glm::dvec3(surface.normal));
}

glm::vec3 light_surface(const PointLight& light, const TracedSurface& surface) {
    return compute_irradiance(light, glm::dvec3(surface.point), glm::dvec3(surface.normal));
}

bool is_dark(const glm::vec3& light) {
    return light == glm::vec3(0.0f);
}

template <class Visit>
void visit_lights(const Lights& lights, const Visit& visit) {
    for (const DirectionalLight& light : lights.directional) {
        visit(light);
    }
    for (const PointLight& light : lights.points) {
        visit(light);
    }
}

void set_pixel(Image& image, int x, int y, const glm::vec3& value) {
    for (int channel = 0; channel < 3; ++channel) {
        image.at(x, y, channel) = value[channel];
    }
}

/// 16 rays and which of them are cast.
struct RayBundle {
    alignas(64) RTCRayHit16 rays{};
    alignas(64) std::array<int, kBundle> valid{};

    RayBundle() { std::fill_n(rays.ray.mask, kBundle, 0xffffffffu); }

    void set_ray(unsigned lane, const glm::vec3& origin, const glm::vec3& direction, float length) {
        rays.ray.org_x[lane] = origin.x;
        rays.ray.org_y[lane] = origin.y;
        rays.ray.org_z[lane] = origin.z;
        rays.ray.dir_x[lane] = direction.x;
        rays.ray.dir_y[lane] = direction.y;
        rays.ray.dir_z[lane] = direction.z;
        rays.ray.tfar[lane] = length;
        valid[lane] = -1;
    }
    [[nodiscard]] glm::vec3 direction(unsigned lane) const {
        return {rays.ray.dir_x[lane], rays.ray.dir_y[lane], rays.ray.dir_z[lane]};
    }
    [[nodiscard]] unsigned count_valid() const {
        return static_cast<unsigned>(std::count(valid.begin(), valid.end(), -1));
    }
    [[nodiscard]] bool is_blocked(unsigned lane) const { return rays.ray.tfar[lane] < 0.0f; }
};

/// What rays of one pixel and half brought, as sums.
struct Gathered {
    glm::vec3 environment{0.0f};
    glm::vec3 bounce{0.0f};
    float blocked = 0.0f;
};

/// Where a ray of a pixel hit: what waits for its light.
struct Sender {
    TracedHit hit;
    float u;
    float v;
    glm::vec3 direction; ///< of the ray that hit it
    float distance;
    float weight; ///< of its light
    Gathered* receiver;
    std::uint32_t seed;
};

/// All that is the same for every pixel.
struct Scope {
    const Camera& camera;
    ImageSize size;
    glm::vec3 eye; ///< relative to the scene's origin
    const TracedScene& scene;
    const SurfaceAlbedo& albedo;
    const Lights& lights; ///< points relative to the scene's origin
    const PathSettings& settings;
    const SobolBundles& points;
    SurfaceRules rules;
    float reach_m;
    /// Else it is enough to know whether something was hit.
    bool weight_needs_distance;
};

/// Traces rows, one after another. Senders of neighbouring pixels are lit together, 16 at a time,
/// so that bundles are full although most rays meet nothing; what a row holds does not depend on
/// who traces which row.
class RowTracer {
  public:
    explicit RowTracer(const Scope& scope);
    /// Fills row `y` of every image of the result.
    void trace(int y, TracedRadiance& result);
    [[nodiscard]] std::uint64_t ray_count() const { return m_ray_count; }

  private:
    /// A pixel between the casting of its rays and the end of its row.
    struct Pixel {
        glm::vec3 direction{0.0f};       ///< of the camera ray
        std::optional<glm::vec3> albedo; ///< nothing: background
        std::array<Gathered, 2> halves;
    };

    void cast_pixel(int x, int y, TracedRadiance& result);
    void write_pixel(int x, int y, TracedRadiance& result) const;
    /// Irradiance from lights straight on.
    [[nodiscard]] glm::vec3 compute_direct(const TracedSurface& surface);
    /// Casts one half's rays; what they bring is complete when all senders are lit.
    void gather(const TracedSurface& surface, Gathered& gathered, std::uint32_t seed);
    /// Weights of what the bundle's rays hit, 0 where they meet nothing within reach. With
    /// `needs_hits` the bundle holds the nearest hit wherever the weight is not 0.
    void weigh_hits(RayBundle& bundle, bool needs_hits, std::array<float, kBundle>& weights);
    void light_senders();
    template <class Light>
    void add_light(const Light& light);
    void add_environment();

    const Scope& m_scope;
    RTCIntersectContext m_context;
    std::vector<Pixel> m_pixels;
    std::array<Sender, kBundle> m_senders; ///< waiting
    unsigned m_sender_count = 0;
    std::array<TracedSurface, kBundle> m_surfaces; ///< of the senders that are being lit
    std::array<glm::vec3, kBundle> m_received;     ///< irradiance / pi there
    RayBundle m_receiver_rays;
    RayBundle m_sender_rays;
    std::uint64_t m_ray_count = 0;
};

RowTracer::RowTracer(const Scope& scope)
    : m_scope(scope), m_pixels(static_cast<std::size_t>(scope.size.width)) {
    rtcInitIntersectContext(&m_context);
    m_context.flags = RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
}

void RowTracer::trace(int y, TracedRadiance& result) {
    for (int x = 0; x < m_scope.size.width; ++x) {
        cast_pixel(x, y, result);
    }
    light_senders();
    for (int x = 0; x < m_scope.size.width; ++x) {
        write_pixel(x, y, result);
    }
}

void RowTracer::cast_pixel(int x, int y, TracedRadiance& result) {
    Pixel& pixel = m_pixels[static_cast<std::size_t>(x)];
    pixel = Pixel{};
    pixel.direction =
        glm::vec3(compute_pixel_direction(m_scope.camera, m_scope.size, {x + 0.5, y + 0.5}));
    ++m_ray_count;
    const std::optional<TracedSurface> surface = find_seen_surface(
        m_scope.scene, m_scope.eye, pixel.direction, m_scope.camera, m_scope.rules);
    if (!surface) {
        return;
    }
    pixel.albedo = m_scope.albedo.look_up(*surface);
    set_pixel(result.direct, x, y, *pixel.albedo * kInversePi * compute_direct(*surface));
    const auto number = static_cast<std::uint32_t>(y * m_scope.size.width + x);
    const std::uint32_t seed = hash_words(m_scope.settings.seed, number);
    gather(*surface, pixel.halves[0], hash_words(seed, 0xau));
    gather(*surface, pixel.halves[1], hash_words(seed, 0xbu));
}

void RowTracer::write_pixel(int x, int y, TracedRadiance& result) const {
    const Pixel& pixel = m_pixels[static_cast<std::size_t>(x)];
    const bool has_parts = m_scope.settings.wants_parts;
    if (!pixel.albedo) {
        const glm::vec3 surroundings =
            compute_background_radiance(m_scope.lights, glm::dvec3(pixel.direction));
        set_pixel(result.indirect.a, x, y, surroundings);
        set_pixel(result.indirect.b, x, y, surroundings);
        if (has_parts) {
            set_pixel(result.environment, x, y, surroundings);
        }
        return;
    }
    const auto rays = static_cast<float>(m_scope.settings.rays_per_half);
    const auto& [a, b] = pixel.halves;
    const glm::vec3 share = *pixel.albedo / rays;
    set_pixel(result.indirect.a, x, y, share * (a.environment + a.bounce));
    set_pixel(result.indirect.b, x, y, share * (b.environment + b.bounce));
    result.visibility.at(x, y) = 1.0f - (a.blocked + b.blocked) / (2.0f * rays);
    if (has_parts) {
        set_pixel(result.environment, x, y, 0.5f * share * (a.environment + b.environment));
        set_pixel(result.bounce, x, y, 0.5f * share * (a.bounce + b.bounce));
    }
}

glm::vec3 RowTracer::compute_direct(const TracedSurface& surface) {
    glm::vec3 irradiance(0.0f);
    visit_lights(m_scope.lights, [&](const auto& light) {
        const glm::vec3 unblocked = light_surface(light, surface);
        if (is_dark(unblocked)) {
            return;
        }
        if (light.casts_shadow) {
            const LightWay way = find_way(light, surface.origin);
            RTCRay ray{};
            ray.org_x = surface.origin.x;
            ray.org_y = surface.origin.y;
            ray.org_z = surface.origin.z;
            ray.dir_x = way.direction.x;
            ray.dir_y = way.direction.y;
            ray.dir_z = way.direction.z;
            ray.tfar = way.length;
            ray.mask = 0xffffffffu;
            rtcOccluded1(m_scope.scene.top(), &m_context, &ray);
            ++m_ray_count;
            if (ray.tfar < 0.0f) {
                return;
            }
        }
        irradiance += unblocked;
    });
    return irradiance;
}

void RowTracer::weigh_hits(RayBundle& bundle, bool needs_hits,
                           std::array<float, kBundle>& weights) {
    RTCScene tree = m_scope.scene.top();
    const bool needs_distance = needs_hits || m_scope.weight_needs_distance;
    const bool is_near = m_scope.settings.reach == PathReach::near;
    m_ray_count += bundle.count_valid();
    weights.fill(0.0f);
    if (!needs_distance || is_near) {
        // Most rays within a radius meet nothing: the closest hit is searched for those alone that
        // meet something.
        rtcOccluded16(bundle.valid.data(), tree, &m_context, &bundle.rays.ray);
        bool any = false;
        for (unsigned lane = 0; lane < kBundle; ++lane) {
            const bool is_hit = bundle.valid[lane] != 0 && bundle.is_blocked(lane);
            bundle.valid[lane] = is_hit ? -1 : 0;
            bundle.rays.ray.tfar[lane] = m_scope.reach_m;
            weights[lane] = is_hit ? 1.0f : 0.0f;
            any = any || is_hit;
        }
        if (!any || !needs_distance) {
            return;
        }
    }
    std::fill_n(bundle.rays.hit.geomID, kBundle, RTC_INVALID_GEOMETRY_ID);
    std::fill_n(bundle.rays.hit.instID[0], kBundle, RTC_INVALID_GEOMETRY_ID);
    rtcIntersect16(bundle.valid.data(), tree, &m_context, &bundle.rays);
    for (unsigned lane = 0; lane < kBundle; ++lane) {
        const bool is_hit =
            bundle.valid[lane] != 0 && bundle.rays.hit.geomID[lane] != RTC_INVALID_GEOMETRY_ID;
        weights[lane] = 0.0f;
        if (is_hit) {
            weights[lane] =
                is_near ? compute_falloff_weight(m_scope.settings.falloff,
                                                 bundle.rays.ray.tfar[lane] / m_scope.reach_m)
                        : 1.0f;
        }
    }
}

void RowTracer::gather(const TracedSurface& surface, Gathered& gathered, std::uint32_t seed) {
    const glm::mat3 frame = make_frame(surface.normal);
    const auto rays = static_cast<unsigned>(m_scope.settings.rays_per_half);
    const bool needs_hits = m_scope.settings.bounces > 0;
    std::array<float, kBundle> weights;
    SobolBundles::Points sobol;
    RayBundle& bundle = m_receiver_rays;
    std::fill_n(bundle.rays.ray.org_x, kBundle, surface.origin.x);
    std::fill_n(bundle.rays.ray.org_y, kBundle, surface.origin.y);
    std::fill_n(bundle.rays.ray.org_z, kBundle, surface.origin.z);
    for (unsigned first = 0; first < rays; first += kBundle) {
        const unsigned count = std::min(kBundle, rays - first);
        m_scope.points.scramble(first, seed, sobol);
        const BundleDirections directions = make_directions(sobol, Weighting::cosine, frame);
        std::copy_n(directions.x.data(), kBundle, bundle.rays.ray.dir_x);
        std::copy_n(directions.y.data(), kBundle, bundle.rays.ray.dir_y);
        std::copy_n(directions.z.data(), kBundle, bundle.rays.ray.dir_z);
        std::fill_n(bundle.rays.ray.tfar, kBundle, m_scope.reach_m);
        bundle.valid.fill(0);
        std::fill_n(bundle.valid.data(), count, -1);
        weigh_hits(bundle, needs_hits, weights);
        for (unsigned lane = 0; lane < count; ++lane) {
            const float weight = weights[lane];
            const glm::vec3 direction = bundle.direction(lane);
            if (weight < 1.0f) {
                gathered.environment +=
                    (1.0f - weight) *
                    compute_surrounding_radiance(m_scope.lights, glm::dvec3(direction));
            }
            gathered.blocked += weight;
            if (weight > 0.0f && needs_hits) {
                const RTCHit16& hit = bundle.rays.hit;
                m_senders[m_sender_count++] = {
                    {hit.instID[0][lane], hit.geomID[lane], hit.primID[lane]},
                    hit.u[lane],
                    hit.v[lane],
                    direction,
                    bundle.rays.ray.tfar[lane],
                    weight,
                    &gathered,
                    hash_words(seed, 2 + first + lane)}; // 0 and 1 are the scrambles of directions
                if (m_sender_count == kBundle) {
                    light_senders();
                }
            }
        }
    }
}

template <class Light>
void RowTracer::add_light(const Light& light) {
    RayBundle& bundle = m_sender_rays;
    std::array<glm::vec3, kBundle> unblocked;
    bundle.valid.fill(0);
    for (unsigned lane = 0; lane < m_sender_count; ++lane) {
        const TracedSurface& surface = m_surfaces[lane];
        unblocked[lane] = light_surface(light, surface);
        if (light.casts_shadow && !is_dark(unblocked[lane])) {
            const LightWay way = find_way(light, surface.origin);
            bundle.set_ray(lane, surface.origin, way.direction, way.length);
        }
    }
    const unsigned count = bundle.count_valid();
    if (count > 0) {
        rtcOccluded16(bundle.valid.data(), m_scope.scene.top(), &m_context, &bundle.rays.ray);
        m_ray_count += count;
    }
    for (unsigned lane = 0; lane < m_sender_count; ++lane) {
        if (bundle.valid[lane] == 0 || !bundle.is_blocked(lane)) {
            m_received[lane] += kInversePi * unblocked[lane];
        }
    }
}

void RowTracer::add_environment() {
    RayBundle& bundle = m_sender_rays;
    bundle.valid.fill(0);
    for (unsigned lane = 0; lane < m_sender_count; ++lane) {
        // The first point of a randomisation of its own is uniform over the square.
        const glm::vec2 point = compute_scrambled_sobol(0, m_senders[lane].seed);
        bundle.set_ray(lane, m_surfaces[lane].origin,
                       make_cosine_direction(point, m_surfaces[lane].normal), m_scope.reach_m);
    }
    std::array<float, kBundle> weights;
    weigh_hits(bundle, false, weights);
    for (unsigned lane = 0; lane < m_sender_count; ++lane) {
        if (weights[lane] < 1.0f) {
            m_received[lane] +=
                (1.0f - weights[lane]) *
                compute_surrounding_radiance(m_scope.lights, glm::dvec3(bundle.direction(lane)));
        }
    }
}

void RowTracer::light_senders() {
    if (m_sender_count == 0) {
        return;
    }
    for (unsigned lane = 0; lane < m_sender_count; ++lane) {
        const Sender& sender = m_senders[lane];
        m_surfaces[lane] = find_surface(m_scope.scene.get_triangle(sender.hit), sender.u, sender.v,
                                        sender.direction, sender.distance, m_scope.rules);
    }
    m_received.fill(glm::vec3(0.0f));
    visit_lights(m_scope.lights, [this](const auto& light) { add_light(light); });
    add_environment();
    for (unsigned lane = 0; lane < m_sender_count; ++lane) {
        const Sender& sender = m_senders[lane];
        sender.receiver->bounce +=
            sender.weight * m_scope.albedo.look_up(m_surfaces[lane]) * m_received[lane];
    }
    m_sender_count = 0;
}

Lights make_relative(Lights lights, const glm::dvec3& origin) {
    for (PointLight& light : lights.points) {
        light.position -= origin;
    }
    return lights;
}

} // namespace

struct PathTracer::State {
    TracedScene scene;
    SurfaceAlbedo albedo;
};

PathTracer::PathTracer() : m_state(std::make_unique<State>()) {}

PathTracer::~PathTracer() = default;

void PathTracer::update(const PosedGeometry& geometry) {
    m_state->scene.update(geometry);
    m_state->albedo.update(geometry.scene);
}

TracedRadiance PathTracer::trace(const Camera& camera, ImageSize size, const Lights& lights,
                                 const PathSettings& settings) const {
    const TracedScene& scene = m_state->scene;
    ALCOVE_ASSERT(scene.is_built(), "update before trace");
    ALCOVE_ASSERT(settings.rays_per_half >= 1 && settings.radius_m > 0.0 &&
                      (settings.bounces == 0 || settings.bounces == 1),
                  "trace settings");
    const glm::vec3 eye(camera.position - scene.origin());
    const Lights relative = make_relative(lights, scene.origin());
    const SobolBundles points(static_cast<unsigned>(settings.rays_per_half));
    const bool is_near = settings.reach == PathReach::near;
    const Scope scope{camera,
                      size,
                      eye,
                      scene,
                      m_state->albedo,
                      relative,
                      settings,
                      points,
                      {settings.normals, settings.terminator_safe},
                      is_near ? static_cast<float>(settings.radius_m) : kFarthest,
                      is_near && settings.falloff != Falloff::none};
    TracedRadiance result{
        Image(size, 3), {Image(size, 3), Image(size, 3), 0}, Image(size, 1, 1.0f), {}, {}};
    if (settings.wants_parts) {
        result.environment = Image(size, 3);
        result.bounce = Image(size, 3);
    }
    std::atomic<int> next_row{0};
    std::atomic<std::uint64_t> ray_count{0};
    run_on_threads(settings.threads, [&] {
        RowTracer tracer(scope);
        for (int y = next_row++; y < size.height; y = next_row++) {
            tracer.trace(y, result);
        }
        ray_count += tracer.ray_count();
    });
    result.indirect.ray_count = ray_count;
    return result;
}

} // namespace alcove
