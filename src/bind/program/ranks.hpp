#pragma once
// The processes that mpirun has started.

namespace signorini::bind {

/// See solve::leads_ranks().
bool leads_ranks();

} // namespace signorini::bind
