#pragma once
// The history of the prompt on disk: a file of statements, in which further lines of one begin with "..> ", as on the
// screen.

#include <string>
#include <vector>

namespace signorini::repl {

/// $XDG_STATE_HOME/signorini/history, ~/.local/state/signorini/history, or empty without a home folder. Creates the
/// folder.
std::string find_history();

/// The last `most` statements of a file, the oldest first; none if it cannot be read.
std::vector<std::string> load_history(const std::string& file, std::size_t most);

/// Appends a statement by a single write, so that prompts that run at the same time do not mix theirs. A file that
/// cannot be written is left alone.
void save_statement(const std::string& file, const std::string& statement);

} // namespace signorini::repl
