#include "terminal/answers.hpp"

#include <algorithm>
#include <sstream>
#include <string_view>

namespace signorini::terminal {
namespace {

/// The numbers of "4;600;800".
std::vector<int> numbers_of(const std::string& parameters) {
  std::vector<int> numbers;
  std::istringstream words(parameters);
  for (std::string word; std::getline(words, word, ';');) numbers.push_back(std::atoi(word.c_str()));
  return numbers;
}

/// True if a control sequence, "\033[" with parameters and a final character, is an answer; then reads it.
bool read_sequence(std::string_view parameters, char last, Answers& answers) {
  const bool is_private = parameters.starts_with('?');
  const std::vector<int> numbers = numbers_of(std::string(parameters.substr(is_private)));
  const bool three = numbers.size() == 3;
  if (last == 'c' && is_private) {
    answers.attributes = numbers;
  } else if (last == 't' && !is_private && three && (numbers[0] == 4 || numbers[0] == 6)) {
    if (numbers[1] > 0 && numbers[2] > 0) (numbers[0] == 4 ? answers.area : answers.cell) = {numbers[2], numbers[1]};
  } else if (last == 'S' && is_private) { // item, status (0: success), values
    if (numbers.size() == 4 && numbers[0] == 2 && numbers[1] == 0) answers.largest_sixel = {numbers[2], numbers[3]};
  } else {
    return false;
  }
  return true;
}

/// The length of the answer at the beginning of the text; 0 if there is none.
std::size_t read_answer(std::string_view text, Answers& answers) {
  if (text.starts_with("\033_G")) {
    const std::size_t end = text.find("\033\\");
    if (end == std::string::npos) return 0;
    answers.kitty |= text.substr(0, end).ends_with(";OK");
    return end + 2;
  }
  if (!text.starts_with("\033[")) return 0;
  const std::size_t last = text.find_first_not_of("?0123456789;", 2);
  const bool taken = last != std::string::npos && read_sequence(text.substr(2, last - 2), text[last], answers);
  return taken ? last + 1 : 0;
}

} // namespace

void take_answers(std::string& input, Answers& answers) {
  const std::string_view text = input;
  std::string rest; // what is not an answer; pasted text may contain any number of escape characters
  std::size_t place = 0;
  while (place < text.size()) {
    const std::size_t escape = std::min(text.find('\033', place), text.size());
    rest += text.substr(place, escape - place);
    const std::size_t length = escape < text.size() ? read_answer(text.substr(escape), answers) : 0;
    if (length == 0 && escape < text.size()) rest += text[escape];
    place = escape + std::max<std::size_t>(length, 1);
  }
  input = std::move(rest);
}

} // namespace signorini::terminal
