#include "harness/stability/stability_subject.hpp"

#include <utility>

namespace alcove {
namespace {

constexpr double kAnyRadius = 0.5;

} // namespace

StabilitySubject::StabilitySubject(gl::Context& context, const MethodUnit& unit, MethodSpec spec)
    : m_context(context), m_unit(unit), m_spec(std::move(spec)) {
    static_cast<void>(resolve(kAnyRadius, {}));
}

ResolvedParameters StabilitySubject::resolve(double radius_m,
                                             const std::vector<ParameterOverride>& forced) const {
    std::vector<ParameterOverride> overrides = preset().overrides;
    overrides.insert(overrides.end(), m_spec.overrides.begin(), m_spec.overrides.end());
    Target target;
    target.radius_m = radius_m;
    for (ParameterOverride mapped : m_unit.map_target(target).overrides) {
        mapped.provenance = Provenance::command_line;
        overrides.push_back(std::move(mapped));
    }
    overrides.insert(overrides.end(), forced.begin(), forced.end());
    return m_unit.parameters.resolve(overrides, {{"scene_radius", radius_m}});
}

std::unique_ptr<Method>
StabilitySubject::create(double radius_m, ImageSize size,
                         const std::vector<ParameterOverride>& forced) const {
    std::unique_ptr<Method> method = m_unit.create(m_context, resolve(radius_m, forced));
    method->resize(size);
    return method;
}

std::unique_ptr<Method> StabilitySubject::create_converged(double radius_m, ImageSize size) const {
    ALCOVE_ASSERT(m_unit.converged_preset, "a method with a limit of many samples");
    std::vector<ParameterOverride> forced = m_unit.find_preset(*m_unit.converged_preset).overrides;
    for (ParameterOverride& override_value : forced) {
        override_value.provenance = Provenance::command_line;
    }
    return create(radius_m, size, forced);
}

std::optional<std::string> StabilitySubject::find_symbol(std::string_view symbol) const {
    for (const ParameterTable::Entry& entry : m_unit.parameters.entries()) {
        if (entry.info.symbol == symbol) {
            return entry.info.name;
        }
    }
    return std::nullopt;
}

bool StabilitySubject::has_radius() const {
    return !m_unit.map_target(Target{}).overrides.empty();
}

bool StabilitySubject::has_history() const {
    return m_unit.warm_frames(resolve(kAnyRadius, {})) > 0;
}

MethodRequests StabilitySubject::get_requests() const {
    return m_unit.create(m_context, resolve(kAnyRadius, {}))->get_requests();
}

} // namespace alcove
