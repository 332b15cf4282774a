#include "repl/kernel/history.hpp"

#include <algorithm>
#include <fnmatch.h>
#include <set>

namespace signorini::repl::kernel {

namespace {

/// A reply with (session, number, code); with `output`, (session, number, (code, none)), because outputs are not kept.
template <class Cells> nl::json reply_with(const Cells& cells, bool output) {
  nl::json list = nl::json::array();
  for (const auto& cell : cells) {
    const nl::json code = output ? nl::json::array({cell.code, nullptr}) : nl::json(cell.code);
    list.push_back(nl::json::array({0, cell.number, code}));
  }
  return {{"status", "ok"}, {"history", std::move(list)}};
}

template <class Cells> Cells last(Cells cells, int n) {
  const auto excess = static_cast<std::ptrdiff_t>(cells.size()) - std::max(n, 0);
  if (excess > 0) cells.erase(cells.begin(), cells.begin() + excess);
  return cells;
}

} // namespace

nl::json History::get_tail_impl(int n, bool, bool output) const {
  return reply_with(last(cells_, n), output);
}

/// Cells with numbers from `start` to before `stop` of this session, 0; there are no others.
nl::json History::get_range_impl(int session, int start, int stop, bool, bool output) const {
  std::vector<Cell> found;
  for (const Cell& cell : cells_)
    if (session == 0 && cell.number >= start && cell.number < stop) found.push_back(cell);
  return reply_with(found, output);
}

nl::json History::search_impl(const std::string& pattern, bool, bool output, int n, bool unique) const {
  std::vector<Cell> found;
  std::set<std::string> known;
  for (auto cell = cells_.rbegin(); cell != cells_.rend(); ++cell)
    if (fnmatch(pattern.c_str(), cell->code.c_str(), 0) == 0 && (known.insert(cell->code).second || !unique))
      found.push_back(*cell);
  std::reverse(found.begin(), found.end());
  return reply_with(last(std::move(found), n), output);
}

} // namespace signorini::repl::kernel
