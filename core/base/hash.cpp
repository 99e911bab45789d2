#include "core/base/hash.hpp"

#include <array>
#include <cstdio>

#include <xxhash.h>

namespace alcove {

struct Hasher::State {
    XXH3_state_t* xxh = XXH3_createState();
};

Hasher::Hasher() : m_state(std::make_unique<State>()) {
    XXH3_128bits_reset(m_state->xxh);
}

Hasher::~Hasher() {
    XXH3_freeState(m_state->xxh);
}

Hasher& Hasher::add_bytes(std::span<const std::byte> bytes) {
    XXH3_128bits_update(m_state->xxh, bytes.data(), bytes.size());
    return *this;
}

Hasher& Hasher::add(std::string_view text) {
    add(static_cast<std::uint64_t>(text.size()));
    return add_bytes(std::as_bytes(std::span(text.data(), text.size())));
}

std::uint64_t Hasher::finish64() const {
    return XXH3_128bits_digest(m_state->xxh).low64;
}

std::string Hasher::finish_hex() const {
    const XXH128_hash_t digest = XXH3_128bits_digest(m_state->xxh);
    return to_hex(digest.high64) + to_hex(digest.low64);
}

std::string to_hex(std::uint64_t value) {
    std::array<char, 17> text{};
    std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(value));
    return text.data();
}

} // namespace alcove
