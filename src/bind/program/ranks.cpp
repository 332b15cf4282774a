#include "bind/program/ranks.hpp"

#include "solve/mumps.hpp"

namespace signorini::bind {

bool leads_ranks() {
  return solve::leads_ranks(SIGNORINI_VERSION);
}

} // namespace signorini::bind
