#include "scenes/common/solids.hpp"
#include "scenes/factory/elements.hpp"

namespace alcove::factory {
namespace {

// The walkway lies above the machines of the south side.
constexpr double kInner = -2.9; ///< z of its edges
constexpr double kOuter = -4.1;
constexpr double kDeck = 3.1;
constexpr double kField = 2.5; ///< length of one field, of which the walkway has ten

/// Of one field, from x = 0: grating, stringers, railings on both sides.
Mesh make_field(const Fineness& fineness) {
    MeshBuilder builder;
    for (const double z : {kInner, kOuter}) {
        add_box(builder, {-0.01, kDeck - 0.2, z - 0.04}, {kField - 0.02, kDeck + 0.03, z + 0.04});
    }
    const int bars = fineness.count(22);
    for (int i = 0; i < bars; ++i) {
        const double x = kField * (i + 0.5) / bars;
        const double half = 0.18 * kField / bars;
        add_box(builder, {x - half, kDeck - 0.04, kOuter}, {x + half, kDeck, kInner});
    }
    for (const double z : {-3.3, -3.7}) {
        add_box(builder, {0.0, kDeck - 0.05, z - 0.01}, {kField - 0.03, kDeck - 0.01, z + 0.01});
    }
    const int around = fineness.segments(6);
    for (const double z : {kInner, kOuter}) {
        for (const double y : {0.4, 0.75, 1.1}) {
            add_bar(builder, {-0.004, kDeck + y, z}, {kField - 0.015, kDeck + y, z}, 0.022, around);
        }
        for (const double x : {0.05, 0.5 * kField}) {
            add_bar(builder, {x, kDeck - 0.1, z}, {x, kDeck + 1.1, z}, 0.024, around);
        }
    }
    return builder.finish("walkway", {0.6f, 0.5f, 0.16f}, 40.0);
}

/// Two posts and a beam between them.
Mesh make_support(const Fineness& fineness) {
    MeshBuilder builder;
    for (const double z : {kInner, kOuter}) {
        add_bar(builder, {0.0, -kSink, z}, {0.0, kDeck - 0.1, z}, 0.07, fineness.segments(10));
        add_box(builder, {-0.16, -kSink, z - 0.16}, {0.16, 0.03, z + 0.16});
    }
    add_box(builder, {-0.06, kDeck - 0.34, kOuter - 0.1}, {0.06, kDeck - 0.18, kInner + 0.1});
    return builder.finish("support", {0.42f, 0.44f, 0.46f}, 40.0);
}

/// Down to the floor in the direction of x, at the walkway's east end.
Mesh make_stairs(const Fineness& fineness) {
    constexpr int kSteps = 14;
    constexpr double kRun = 2.6;
    MeshBuilder builder;
    for (int i = 0; i < kSteps; ++i) {
        const double along = (i + 0.5) / kSteps;
        add_box(builder, {kRun * along - 0.12, kDeck * (1.0 - along) - 0.02, kOuter + 0.02},
                {kRun * along + 0.12, kDeck * (1.0 - along) + 0.01, kInner - 0.02});
    }
    for (const double z : {kInner, kOuter}) {
        add_bar(builder, {-0.05, kDeck, z}, {kRun + 0.1, -0.1, z}, 0.07, fineness.segments(6));
        add_bar(builder, {-0.02, kDeck + 1.1, z}, {kRun, 1.0, z}, 0.024, fineness.segments(6));
        for (const double along : {0.05, 0.5, 0.97}) {
            const double y = kDeck * (1.0 - along);
            add_bar(builder, {kRun * along, y, z}, {kRun * along, y + 1.08, z}, 0.022,
                    fineness.segments(6));
        }
    }
    return builder.finish("stairs", {0.6f, 0.5f, 0.16f}, 40.0);
}

} // namespace

void add_gantry(SceneKit& kit, const Fineness& fineness) {
    const std::size_t field = kit.add_mesh(make_field(fineness));
    const std::size_t support = kit.add_mesh(make_support(fineness));
    constexpr int kFields = 10;
    for (int i = 0; i < kFields; ++i) {
        kit.place(field, make_place({-kHalfLength + 0.3 + kField * i, 0.0, 0.0}));
        if (i % 2 == 0) {
            kit.place(support, make_place({-kHalfLength + 1.0 + kField * i, 0.0, 0.0}));
        }
    }
    kit.add(make_stairs(fineness), make_place({-kHalfLength + 0.3 + kField * kFields, 0.0, 0.0}));
}

} // namespace alcove::factory
