#include "base/text.hpp"

#include <sstream>

namespace signorini {

std::string joined(std::initializer_list<TextPart> parts) {
  std::ostringstream out;
  out.precision(10);
  for (const TextPart& part : parts) out << part;
  return out.str();
}

} // namespace signorini
