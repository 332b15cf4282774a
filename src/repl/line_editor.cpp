#include "repl/line_editor.hpp"

#include "bind/lua/arguments.hpp"
#include "os/interrupt.hpp"
#include "repl/history.hpp"
#include "repl/interrupt.hpp"
#include "terminal/dialogue.hpp"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>
#include <poll.h>
#include <string_view>
#include <vector>

#include <readline/history.h>
#include <readline/readline.h>

namespace signorini::repl {

namespace {

constexpr int most_statements = 2000; ///< in the history in memory

lua_State* state = nullptr;
std::string above; ///< the lines of the unfinished statement

/// All completions of `word` after `before` by signorini.complete; none if Ctrl-C interrupts the search.
std::vector<std::string> completions(const char* word, const std::string& before) {
  const InterruptsLibrary scope;
  const int top = lua_gettop(state);
  std::vector<std::string> list;
  signorini::bind::push_require(state);
  lua_pushstring(state, "signorini.prompt.complete");
  if (lua_pcall(state, 1, 1, 0) == LUA_OK) {
    lua_pushstring(state, word);
    lua_pushlstring(state, before.data(), before.size());
    if (lua_pcall(state, 2, 1, 0) == LUA_OK) list = bind::to<std::vector<std::string>>(state, -1);
  }
  lua_settop(state, top);
  return list;
}

std::string before_word; ///< the text before the completed word

/// Readline calls this repeatedly, with first = 0 for the first one.
char* completion_entry(const char* word, int first) {
  static std::vector<std::string> list;
  static std::size_t next = 0;
  if (first == 0) {
    list = completions(word, before_word);
    next = 0;
  }
  return next < list.size() ? strdup(list[next++].c_str()) : nullptr;
}

char** complete(const char* word, int start, int) {
  rl_completion_append_character = '\0';
  before_word = above + "\n" + std::string(rl_line_buffer, start);
  char** matches = rl_completion_matches(word, completion_entry);
  // Inside quotes without known texts, readline's completion of file names is used.
  rl_attempted_completion_over = matches || !rl_completion_quote_character;
  return matches;
}

/// Tab completes; at the beginning of a line it inserts a tab, as in pasted lines.
int tab(int count, int key) {
  const std::string_view left(rl_line_buffer, rl_point);
  if (left.find_first_not_of(" \t") == std::string_view::npos) return rl_insert(count, key);
  if (rl_last_func == tab) rl_last_func = rl_complete; // a second Tab lists the completions
  return rl_complete(count, key);
}

/// Where the line of a position begins in the buffer, which may hold several.
int line_start(int position) {
  while (position > 0 && rl_line_buffer[position - 1] != '\n') --position;
  return position;
}

int line_end(int position) {
  while (position < rl_end && rl_line_buffer[position] != '\n') ++position;
  return position;
}

/// The position in the line from `start` that is as far from its beginning as the cursor is from that of its own line.
int below_or_above(int start) {
  return std::min(start + rl_point - line_start(rl_point), line_end(start));
}

/// Up moves to the line above in a block of several lines, otherwise to the previous statement of the history.
int up(int count, int key) {
  const int start = line_start(rl_point);
  if (start == 0) return rl_get_previous_history(count, key);
  rl_point = below_or_above(line_start(start - 1));
  return 0;
}

int down(int count, int key) {
  const int end = line_end(rl_point);
  if (end == rl_end) return rl_get_next_history(count, key);
  rl_point = below_or_above(end + 1);
  return 0;
}

/// Home and End of the line in a block.
template <int (*place)(int)> int move_to(int, int) {
  rl_point = place(rl_point);
  return 0;
}

/// Replaces a function of readline on its keys, except on those that ~/.inputrc has given another one.
void replace(std::initializer_list<const char*> keys, rl_command_func_t* usual, rl_command_func_t* own) {
  for (const char* key : keys)
    if (rl_function_of_keyseq(key, nullptr, nullptr) == usual) rl_bind_keyseq(key, own);
}

bool finished = false;
char* typed = nullptr; ///< the finished line; nullptr at the end of input

void on_line(char* line) {
  rl_callback_handler_remove();
  finished = true;
  typed = line;
}

std::string typed_ahead; ///< keys that came between answers of the terminal

int next_key(FILE* input) {
  if (typed_ahead.empty()) return rl_getc(input);
  const auto key = static_cast<unsigned char>(typed_ahead.front());
  typed_ahead.erase(0, 1);
  return key;
}

volatile std::sig_atomic_t continued = 0, resized = 0;

void note_signal(int signal) {
  (signal == SIGCONT ? continued : resized) = 1;
}

/// Waits for a key or a signal; returns which. Ctrl-C is unblocked only while waiting, so that none is missed between
/// the check and the wait.
bool wait_for_key() {
  if (!typed_ahead.empty()) return !interrupted();
  sigset_t interrupt, others;
  sigemptyset(&interrupt);
  sigaddset(&interrupt, SIGINT);
  sigprocmask(SIG_BLOCK, &interrupt, &others);
  pollfd input{fileno(rl_instream ? rl_instream : stdin), POLLIN, 0};
  const bool key = !interrupted() && ppoll(&input, 1, nullptr, &others) > 0;
  sigprocmask(SIG_SETMASK, &others, nullptr);
  return key;
}

/// Handles signals for readline; after a pause (Ctrl-Z, fg) restores the terminal mode.
void handle_signals() {
  rl_check_signals();
  if (resized) rl_resize_terminal();
  resized = 0;
  if (!continued) return;
  continued = 0;
  rl_deprep_terminal();
  rl_prep_terminal(1);
  rl_forced_update_display();
}

} // namespace

std::string readline_version() {
  return rl_library_version;
}

LineEditor::LineEditor(lua_State* L) : history_file_(find_history()) {
  state = L;
  rl_readline_name = "signorini";
  // Without the slash, because file names contain it; signorini.complete treats it as division.
  rl_basic_word_break_characters = " \t\n\"'`@$><=;|&{}()[],+-*^%#~?!";
  rl_completer_quote_characters = "\"'";
  rl_attempted_completion_function = complete;
  rl_initialize(); // reads ~/.inputrc
  rl_bind_key('\t', tab);
  replace({"\033[A", "\033OA"}, rl_get_previous_history, up);
  replace({"\033[B", "\033OB"}, rl_get_next_history, down);
  replace({"\001", "\033[H", "\033OH", "\033[1~"}, rl_beg_of_line, move_to<line_start>); // Ctrl-A, Home
  replace({"\005", "\033[F", "\033OF", "\033[4~"}, rl_end_of_line, move_to<line_end>);   // Ctrl-E, End
  rl_getc_function = next_key;
  terminal::keep_typed([](const std::string& keys) { typed_ahead += keys; });
  rl_catch_sigwinch = 0; // readline would handle it only with the next key
  std::signal(SIGWINCH, note_signal);
  std::signal(SIGCONT, note_signal);
  using_history();
  stifle_history(most_statements);
  for (const std::string& statement : load_history(history_file_, most_statements)) add_history(statement.c_str());
}

// readline() would discard keys that follow a Ctrl-C, hence this loop over keys.
Input LineEditor::read(const char* prompt, const std::string& before, std::string& line) {
  finished = false;
  above = before;
  rl_callback_handler_install(prompt, on_line);
  while (!finished) {
    const bool key = wait_for_key();
    handle_signals();
    if (interrupted()) {
      rl_echo_signal_char(SIGINT);
      rl_callback_sigcleanup();
      rl_callback_handler_remove();
      forget_interrupt(state);
      std::puts("");
      return Input::interrupted;
    }
    if (key) rl_callback_read_char();
  }
  if (!typed) {
    std::puts("");
    return Input::end;
  }
  line = typed;
  std::free(typed);
  return Input::line;
}

void LineEditor::remember(const std::string& statement) {
  if (statement.find_first_not_of(" \t\n") == std::string::npos) return;
  const HIST_ENTRY* last = history_get(history_base + history_length - 1);
  if (last && statement == last->line) return;
  add_history(statement.c_str());
  if (!history_file_.empty()) save_statement(history_file_, statement);
}

} // namespace signorini::repl
