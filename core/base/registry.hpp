#pragma once
// The list of a room's units (methods, metrics, scenes), made from the room's CMakeLists.txt. A
// value, not a global.

#include "core/base/error.hpp"
#include "core/base/nearest_name.hpp"

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace alcove {

/// `Unit` has `std::string name`.
template <class Unit>
class Registry {
  public:
    /// `room` is the plural used in errors and listings, e.g. "methods".
    Registry(std::string room, std::vector<Unit> units)
        : m_room(std::move(room)), m_units(std::move(units)) {}

    [[nodiscard]] std::span<const Unit> units() const& noexcept { return m_units; }
    /// A loop over a temporary registry's units would read freed memory.
    std::span<const Unit> units() && = delete;

    /// Throws InputError with the nearest name if there is no such unit.
    [[nodiscard]] const Unit& find(std::string_view name) const {
        for (const Unit& unit : m_units) {
            if (unit.name == name) {
                return unit;
            }
        }
        throw InputError("unknown name in " + m_room, "", name,
                         describe_choices(name, get_names()));
    }

    [[nodiscard]] std::vector<std::string> get_names() const {
        std::vector<std::string> names;
        for (const Unit& unit : m_units) {
            names.push_back(unit.name);
        }
        return names;
    }

  private:
    std::string m_room;
    std::vector<Unit> m_units;
};

} // namespace alcove
