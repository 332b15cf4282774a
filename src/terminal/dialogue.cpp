#include "terminal/dialogue.hpp"

#include "os/interrupt.hpp"
#include "os/timer.hpp"

#include <array>
#include <cstdio>
#include <iostream>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

namespace signorini::terminal {
namespace {

constexpr double longest_wait = 2; // s; a terminal far away answers within a few tenths

/// C's library takes any number of bytes back, the last one first.
void push_back(const std::string& keys) {
  for (auto key = keys.rbegin(); key != keys.rend(); ++key) std::ungetc(static_cast<unsigned char>(*key), stdin);
}

std::function<void(const std::string&)> keep = push_back;

/// During its lifetime keys are readable one by one and not shown.
class KeyByKey {
public:
  KeyByKey() {
    ::tcgetattr(STDIN_FILENO, &before_);
    termios now = before_;
    now.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
    now.c_cc[VMIN] = 1;
    now.c_cc[VTIME] = 0;
    ::tcsetattr(STDIN_FILENO, TCSANOW, &now);
  }
  ~KeyByKey() { ::tcsetattr(STDIN_FILENO, TCSANOW, &before_); }
  KeyByKey(const KeyByKey&) = delete;
  KeyByKey& operator=(const KeyByKey&) = delete;

private:
  termios before_;
};

const pid_t this_process = ::getpid();

} // namespace

bool can_ask() {
  return ::isatty(STDIN_FILENO) == 1 && ::isatty(STDOUT_FILENO) == 1 && ::getpid() == this_process &&
         ::tcgetpgrp(STDIN_FILENO) == ::getpgrp();
}

void ask(const std::string& queries, Answers& answers) {
  answers.attributes.reset();
  std::string input;
  {
    const KeyByKey mode;
    put(queries + ask_attributes);
    const Stopwatch watch;
    while (!answers.attributes && !interrupted()) {
      const double left = longest_wait - watch.seconds();
      pollfd keys{STDIN_FILENO, POLLIN, 0};
      if (left <= 0 || ::poll(&keys, 1, static_cast<int>(1000 * left) + 1) == 0) break;
      std::array<char, 4096> bytes;
      const ssize_t got = keys.revents ? ::read(STDIN_FILENO, bytes.data(), bytes.size()) : 0;
      if (keys.revents && got <= 0) break;
      input.append(bytes.data(), got);
      take_answers(input, answers);
    }
  }
  if (!input.empty()) keep(input);
}

void keep_typed(std::function<void(const std::string&)> own) {
  keep = std::move(own);
}

void put(const std::string& bytes) {
  std::cout.write(bytes.data(), static_cast<std::streamsize>(bytes.size())).flush();
  std::fflush(stdout);
}

} // namespace signorini::terminal
