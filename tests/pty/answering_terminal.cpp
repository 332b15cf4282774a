// A terminal that answers queries as real ones do: runs a command of the shell on a pseudo-terminal, passes standard
// input on to it as keys, and writes what it shows to a file.
//   answering_terminal <kind> <columns>x<rows> <cell width>x<cell height> <keys> <command> <file>
// kind: kitty, iterm, sixel (xterm), plain, or kitty_pixels, which tells its pixels by answers only. keys: typed while
// it answers, before the last answer.

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <poll.h>
#include <pty.h>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>
#include <vector>

namespace {

using Answers = std::vector<std::pair<std::string, std::string>>; // by query

Answers answers_of(const std::string& kind, const std::string& keys) {
  const std::string kitty = "\033_Gi=31,s=1,v=1,a=q,t=d,f=24;AAAA\033\\", attributes = "\033[c", version = "\033[>q";
  if (kind == "kitty" || kind == "kitty_pixels")
    return {{kitty, "\033_Gi=31;OK\033\\"},
            {attributes, keys + "\033[?62;c"},
            {version, "\033P>|kitty(0.26.5)\033\\"},
            {"\033[16t", "\033[6;18;9t"},
            {"\033[14t", "\033[4;360;720t"}};
  if (kind == "iterm") return {{attributes, keys + "\033[?62;4c"}, {"\033[14t", "\033[4;480;800t"}};
  if (kind == "sixel")
    return {{attributes, keys + "\033[?63;1;2;4;6;9;15;22c"},
            {"\033[?1;3;256S", "\033[?1;0;256S"},
            {"\033[?2;1;0S", "\033[?2;0;500;300S"}};
  return {{attributes, keys + "\033[?1;2c"}};
}

std::pair<int, int> size_of(const std::string& word) {
  const std::size_t times = word.find('x');
  return {std::atoi(word.c_str()), std::atoi(word.c_str() + times + 1)};
}

void write_all(int file, const std::string& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t count = ::write(file, bytes.data() + done, bytes.size() - done);
    if (count <= 0) return;
    done += static_cast<std::size_t>(count);
  }
}

/// Answers the queries in the output so far, from `from` on, and returns where the next one may begin.
std::size_t answer(const std::string& shown, std::size_t from, const Answers& answers, int terminal) {
  for (std::size_t at = shown.find('\033', from); at != std::string::npos; at = shown.find('\033', at + 1))
    for (const auto& [query, reply] : answers) {
      const std::string there = shown.substr(at, query.size());
      if (there == query) write_all(terminal, reply);
      if (there.size() < query.size() && query.starts_with(there)) return at; // not complete yet
    }
  return shown.size();
}

} // namespace

int main(int count, char** words) {
  if (count != 7) return 2;
  const auto [columns, rows] = size_of(words[2]);
  const auto [width, height] = size_of(words[3]);
  const winsize size{static_cast<unsigned short>(rows), static_cast<unsigned short>(columns),
                     static_cast<unsigned short>(columns * width), static_cast<unsigned short>(rows * height)};
  int terminal = 0;
  const pid_t child = ::forkpty(&terminal, nullptr, nullptr, &size);
  if (child == 0) {
    ::execl("/bin/sh", "sh", "-c", words[5], nullptr);
    _exit(127);
  }
  const Answers answers = answers_of(words[1], words[4]);
  std::ofstream file(words[6], std::ios::binary);
  std::string shown;
  std::size_t from = 0;
  std::array<pollfd, 2> ready = {{{terminal, POLLIN, 0}, {STDIN_FILENO, POLLIN, 0}}};
  std::array<char, 65536> bytes;
  while (::poll(ready.data(), ready.size(), -1) > 0) {
    if (ready[0].revents) {
      const ssize_t got = ::read(terminal, bytes.data(), bytes.size());
      if (got <= 0) break; // the command has ended
      shown.append(bytes.data(), static_cast<std::size_t>(got));
      file.write(bytes.data(), got).flush();
      from = answer(shown, from, answers, terminal);
    }
    if (ready[1].revents) {
      const ssize_t got = ::read(STDIN_FILENO, bytes.data(), bytes.size());
      if (got > 0)
        write_all(terminal, std::string(bytes.data(), static_cast<std::size_t>(got)));
      else
        ready[1].fd = -1; // no more keys
    }
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}
