#include "base/match.hpp"

#include <regex.h>

namespace signorini {

std::vector<std::string> match(const std::string& text, const char* expression) {
  regex_t compiled;
  if (regcomp(&compiled, (std::string("^(") + expression + ")$").c_str(), REG_EXTENDED) != 0) return {};
  std::vector<regmatch_t> found(compiled.re_nsub + 1);
  const bool matches =
      text.find('\0') == std::string::npos && regexec(&compiled, text.c_str(), found.size(), found.data(), 0) == 0;
  regfree(&compiled);
  std::vector<std::string> groups;
  if (matches)
    for (std::size_t i = 1; i < found.size(); ++i)
      groups.push_back(found[i].rm_so < 0 ? ""
                                          : text.substr(static_cast<std::size_t>(found[i].rm_so),
                                                        static_cast<std::size_t>(found[i].rm_eo - found[i].rm_so)));
  return groups;
}

} // namespace signorini
