#pragma once
// Sentences for the codes and data of messages from the modules left of bind.
//
// The files *.def have a row for each code: a sentence with the names of the data in braces. Formats after a colon:
// {n:element} counts ("1 element", "2 elements"), {i:+1} counts from 1, {x:6} prints six digits instead of ten,
// {names:and} ends with "b and c", {names:quoted} quotes each text of a list, {factors:·} replaces the comma between
// them, {range:list} has braces instead of a point's parentheses. Messages among the data become sentences too, joined
// by semicolons.

#include "base/error.hpp"

#include <string>
#include <vector>

namespace signorini::bind {

/// A message as a sentence; code and data if it has no row.
std::string worded(const Message& message);
std::vector<std::string> worded(const std::vector<Message>& messages);
/// The message of an exception; for an Error, its sentence.
std::string worded(const std::exception& error);
/// Sentences joined by semicolons.
std::string worded_in_one(const std::vector<Message>& messages);

/// Prints a warning to standard error, each one once, unless they are muted.
void warn(const std::string& sentence);
/// Mutes warnings, or not: those of scenes that the program makes again are not the user's. Returns whether they were.
bool mute_warnings(bool muted);
/// From now on prints warnings of the modules left of bind as sentences.
void word_warnings();

} // namespace signorini::bind
