#include "methods/common/run_on_threads.hpp"

#include <algorithm>
#include <thread>
#include <vector>

namespace alcove {

void run_on_threads(int threads, const std::function<void()>& work) {
    const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
    const unsigned count = threads > 0 ? static_cast<unsigned>(threads) : cores;
    std::vector<std::jthread> others;
    for (unsigned i = 1; i < count; ++i) {
        others.emplace_back(work);
    }
    work();
}

} // namespace alcove
