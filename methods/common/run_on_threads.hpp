#pragma once
// The same work on several threads, which share it out among themselves.

#include <functional>

namespace alcove {

/// `work` on this thread and on others, all of which have ended on return; 0: as many as there are
/// cores.
void run_on_threads(int threads, const std::function<void()>& work);

} // namespace alcove
