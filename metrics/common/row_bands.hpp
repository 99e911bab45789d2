#pragma once
// An image's rows shared out over the cores.

#include <functional>

namespace alcove {

/// Calls `work(begin, end)` for bands [begin, end) that together cover rows 0..rows, each on a
/// thread of its own; no more bands than cores, none under 64 rows. `work` writes each row's result
/// to a place of that row and throws nothing, so that the result does not depend on how many cores
/// there are.
void for_row_bands(int rows, const std::function<void(int begin, int end)>& work);

} // namespace alcove
