#pragma once
// A configuration of a method, as cases make it anew for every severity.

#include "core/contract/method.hpp"
#include "harness/run/experiment.hpp"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace alcove {

class StabilitySubject {
  public:
    /// The unit and the context must outlive it. Throws InputError on an unknown preset or
    /// parameter or a value out of range.
    StabilitySubject(gl::Context& context, const MethodUnit& unit, MethodSpec spec);

    [[nodiscard]] gl::Context& context() const noexcept { return m_context; }
    [[nodiscard]] const MethodUnit& unit() const noexcept { return m_unit; }
    [[nodiscard]] const MethodSpec& spec() const noexcept { return m_spec; }
    [[nodiscard]] const Preset& preset() const { return m_unit.find_preset(m_spec.preset); }

    /// A fresh instance for images of this size. The radius stands above what the specification
    /// says, `forced` above both.
    [[nodiscard]] std::unique_ptr<Method>
    create(double radius_m, ImageSize size,
           const std::vector<ParameterOverride>& forced = {}) const;
    /// The same with the method's own limit of many samples. Asserts that it has one.
    [[nodiscard]] std::unique_ptr<Method> create_converged(double radius_m, ImageSize size) const;

    /// The parameter with this symbol of its paper.
    [[nodiscard]] std::optional<std::string> find_symbol(std::string_view symbol) const;
    /// A radius reaches it.
    [[nodiscard]] bool has_radius() const;
    [[nodiscard]] bool has_history() const;
    /// What it reads.
    [[nodiscard]] MethodRequests get_requests() const;
    /// Frames of a still camera that show it at work: 1 without history, a few with one.
    [[nodiscard]] int frames() const { return has_history() ? 4 : 1; }

  private:
    [[nodiscard]] ResolvedParameters resolve(double radius_m,
                                             const std::vector<ParameterOverride>& forced) const;

    gl::Context& m_context;
    const MethodUnit& m_unit;
    MethodSpec m_spec;
};

} // namespace alcove
