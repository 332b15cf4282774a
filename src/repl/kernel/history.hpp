#pragma once
// The cells of this session, for history requests.

#include <xeus/xhistory_manager.hpp>

namespace signorini::repl::kernel {

class History final : public xeus::xhistory_manager {
public:
  /// Adds a cell. Xeus' own calls lack its number and are ignored.
  void add(int number, const std::string& code) { cells_.push_back({number, code}); }

private:
  struct Cell {
    int number;
    std::string code;
  };
  void configure_impl() override {}
  void store_inputs_impl(int, int, const std::string&, const std::string&) override {}
  nl::json get_tail_impl(int n, bool raw, bool output) const override;
  nl::json get_range_impl(int session, int start, int stop, bool raw, bool output) const override;
  nl::json search_impl(const std::string& pattern, bool raw, bool output, int n, bool unique) const override;

  std::vector<Cell> cells_;
};

} // namespace signorini::repl::kernel
