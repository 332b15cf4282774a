#pragma once
// Sentences for what the modules left of bind have to tell in codes and data.
//
// The files *.def have a row for each code: a sentence with the data in braces by name. What may follow a colon there:
// {n:element} counts ("1 element", "2 elements"), {i:+1} counts from 1, {x:6} shows six digits instead of ten,
// {names:and} ends with "b and c", {names:quoted} quotes each text of a list, {factors:·} puts a sign other than the
// comma between them, {range:list} has braces instead of a point's parentheses. Messages among the data are worded,
// too, and joined by semicolons.

#include "base/error.hpp"

#include <string>
#include <vector>

namespace signorini::bind {

/// A message as a sentence; without a wording of its own as code and data.
std::string worded(const Message& message);
std::vector<std::string> worded(const std::vector<Message>& messages);
/// What an exception says, of an Error in words.
std::string worded(const std::exception& error);
/// Sentences one behind the other, with semicolons between.
std::string worded_in_one(const std::vector<Message>& messages);

/// Prints a warning to the standard error, each one once.
void warn(const std::string& sentence);
/// From now on warnings of the modules left of bind are printed, too, in words.
void word_warnings();

} // namespace signorini::bind
