#pragma once
// Input of the prompt as executable code: an expression, statements, or a query for help.

#include <lua.hpp>

#include <string>

namespace signorini::repl {

enum class Chunk { unfinished, statements, expression };

/// Loads the lines so far as an expression or as statements, or as a query for help ("?sg.body"), and leaves a function
/// and its arguments, or an error message, as the only stack entries. An expression returns nil as its first result, so
/// that a call in it is not a tail call, which would lose its position in errors. `name`: of the code in messages.
Chunk load(lua_State* L, const std::string& code, const std::string& name = "prompt");

/// The same for a cell of a notebook, whose value is that of an expression at its end.
Chunk load_cell(lua_State* L, const std::string& code, const std::string& name);

/// Whether a line ends the prompt: exit or quit, also as a call, unless the user has a variable of that name.
bool asks_to_leave(lua_State* L, const std::string& line);

/// Pushes a function from a module of the library.
void push_library_function(lua_State* L, const char* module, const char* name);

} // namespace signorini::repl
