#include "scenes/city/elements.hpp"
#include "scenes/city/storeys.hpp"

#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace alcove::city {
namespace {

/// Of the reach. Courtyards are seen from the roofs only.
constexpr double kCourtReach = 0.7;
/// Of the reach: nearer houses have the finest storeys.
constexpr double kFineReach = 0.35;
constexpr double kBalconyReach = 0.9;

/// An end wall is lower than the front by this much: where they meet, within the quoin, no faces
/// share a plane. Metres.
constexpr double kEndDrop = 0.013;

using Meshes = std::vector<std::size_t>;

/// What one style needs, made when the first house asks for it.
class Wardrobe {
  public:
    Wardrobe(Kit& kit, const std::vector<Style>& styles) : m_kit(kit), m_styles(styles) {}

    const Meshes& get_storey(const Lot& lot, StoreyKind kind, int bays) {
        const int steps = lot.distance_m < kFineReach * m_kit.reach_m() ? m_kit.steps() : 1;
        Meshes& meshes = m_storeys[{lot.style, static_cast<int>(kind), bays, steps}];
        if (meshes.empty()) {
            meshes = add_storey(m_kit, get_style(lot.style), kind, bays, steps);
        }
        return meshes;
    }
    std::size_t get_cornice(int style, int bays) {
        return find(m_cornices, {style, bays},
                    [&] { return add_cornice(m_kit, get_style(style), bays); });
    }
    std::size_t get_quoin(int style, int storeys) {
        return find(m_quoins, {style, storeys},
                    [&] { return add_quoin(m_kit, get_style(style), storeys); });
    }
    std::size_t get_balcony(int style) {
        return find(m_balconies, {style, 0}, [&] { return add_balcony(m_kit, get_style(style)); });
    }
    [[nodiscard]] const Style& get_style(int style) const {
        return m_styles[static_cast<std::size_t>(style)];
    }

  private:
    using Found = std::map<std::pair<int, int>, std::size_t>;

    template <class Make>
    static std::size_t find(Found& found, std::pair<int, int> key, const Make& make) {
        const auto known = found.find(key);
        return known != found.end() ? known->second : found.emplace(key, make()).first->second;
    }

    Kit& m_kit;
    const std::vector<Style>& m_styles;
    std::map<std::array<int, 4>, Meshes> m_storeys; ///< by style, kind, bays and steps
    Found m_cornices;
    Found m_quoins;
    Found m_balconies;
};

void place_all(Kit& kit, const Meshes& meshes, const glm::dmat4& frame) {
    for (const std::size_t mesh : meshes) {
        kit.place(mesh, frame);
    }
}

double get_floor(const Lot& lot, int storey) {
    return lot.lift + kGroundFloor + kStorey * (storey - 1);
}

/// A wall to a street, all storeys; `frame` as a lot's.
void dress_street(Kit& kit, Wardrobe& wardrobe, const Lot& lot, const glm::dmat4& frame, int bays) {
    place_all(kit, wardrobe.get_storey(lot, StoreyKind::ground, bays), frame);
    for (int storey = 1; storey < lot.storeys; ++storey) {
        const StoreyKind kind = storey == 1 ? StoreyKind::noble : StoreyKind::upper;
        place_all(kit, wardrobe.get_storey(lot, kind, bays),
                  shift(frame, {0.0, get_floor(lot, storey), 0.0}));
    }
    kit.place(wardrobe.get_cornice(lot.style, bays),
              shift(frame, {0.0, lot.lift + get_wall_height(lot.storeys), 0.0}));
}

void dress_court(Kit& kit, Wardrobe& wardrobe, const Lot& lot) {
    const glm::dmat4 frame =
        shift(lot.frame, {0.0, 0.0, -kLotDepth}) * make_frame(glm::dvec3(0.0), 2);
    place_all(kit, wardrobe.get_storey(lot, StoreyKind::court, kFrontBays),
              shift(frame, {0.0, 0.9, 0.0}));
    for (int storey = 1; storey < lot.storeys; ++storey) {
        place_all(kit, wardrobe.get_storey(lot, StoreyKind::court, kFrontBays),
                  shift(frame, {0.0, get_floor(lot, storey), 0.0}));
    }
}

} // namespace

void add_facades(Kit& kit, const Plan& plan, const std::vector<Style>& styles) {
    Wardrobe wardrobe(kit, styles);
    for (const Lot& lot : plan.lots) {
        if (lot.distance_m > kit.reach_m()) {
            continue;
        }
        dress_street(kit, wardrobe, lot, lot.frame, kFrontBays);
        const double edge = -0.5 * kLotWidth;
        kit.place(wardrobe.get_quoin(lot.style, lot.storeys),
                  shift(lot.frame, {edge, lot.lift, 0.0}));
        if (lot.is_corner) {
            dress_street(kit, wardrobe, lot,
                         shift(lot.frame, {edge, -kEndDrop, -0.5 * kLotDepth}) *
                             make_frame(glm::dvec3(0.0), 3),
                         kEndBays);
            kit.place(wardrobe.get_quoin(lot.style, lot.storeys),
                      shift(lot.frame, {edge, lot.lift - kEndDrop, -kLotDepth}) *
                          make_frame(glm::dvec3(0.0), 3));
        }
        if (wardrobe.get_style(lot.style).has_balcony &&
            lot.distance_m < kBalconyReach * kit.reach_m()) {
            kit.place(wardrobe.get_balcony(lot.style),
                      shift(lot.frame, {0.0, get_floor(lot, 1), 0.0}));
            if (lot.storeys > 4) {
                kit.place(wardrobe.get_balcony(lot.style),
                          shift(lot.frame, {0.0, get_floor(lot, 3), 0.0}));
            }
        }
        if (lot.distance_m < kCourtReach * (kit.reach_m() - kLotDepth)) {
            dress_court(kit, wardrobe, lot);
        }
    }
}

} // namespace alcove::city
