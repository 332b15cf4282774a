#pragma once
// Input of the prompt as executable code: an expression, statements, or commands such as %run and ?name.

#include <lua.hpp>

#include <string>
#include <vector>

namespace signorini::repl {

enum class Chunk { unfinished, statements, expression };

/// Loads the lines so far as an expression or as statements, in which lines may be commands ("?sg.body", "%who", "!ls":
/// lua/signorini/prompt/commands.lua), and leaves a function, or an error message, as the only stack entry. An
/// expression returns nil as its first result, so that a call in it is not a tail call, which would lose its position
/// in errors. `name`: of the code in messages.
Chunk load(lua_State* L, std::string code, const std::string& name = "prompt");

/// Likewise a cell of a notebook, whose value is that of an expression at its end.
Chunk load_cell(lua_State* L, std::string code, const std::string& name);

/// The parts of load(): replaces commands by calls on the same lines, or pushes an error message and returns false; and
/// loads code without commands onto an empty stack.
bool translate_commands(lua_State* L, std::string& code);
Chunk load_lua(lua_State* L, const std::string& code, const std::string& name);

/// Divides lines into statements, each of one or several lines, as they are entered one after the other; of lines with
/// a syntax error the rest is one. For the history.
std::vector<std::string> statements(lua_State* L, const std::string& code);

/// True if a line ends the prompt: exit or quit, also as a call, unless the user has a variable of that name.
bool asks_to_leave(lua_State* L, const std::string& line);

/// Pushes a function from a module of the library.
void push_library_function(lua_State* L, const char* module, const char* name);

} // namespace signorini::repl
