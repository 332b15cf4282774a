#pragma once
// What is typed at the prompt, as something that can be run: an expression, statements, or a query for help.

#include <lua.hpp>

#include <string>

namespace signorini::repl {

enum class Chunk { unfinished, statements, expression };

/// Loads the lines so far as an expression or as statements, or as a query for help ("?sg.body"), and leaves a function
/// and its arguments, or an error message, alone on the stack. An expression stands behind a nil, its first result, so
/// that a call in it is no tail call, which would lose its place in errors.
Chunk load(lua_State* L, const std::string& code);

/// Whether a line asks to leave the prompt: exit or quit, also as a call, unless the user has a variable of that name.
bool asks_to_leave(lua_State* L, const std::string& line);

/// Pushes a function of a module of the library.
void push_library_function(lua_State* L, const char* module, const char* name);

} // namespace signorini::repl
