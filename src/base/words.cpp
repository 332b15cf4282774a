#include "base/words.hpp"

#include <sstream>

namespace signorini {

std::string coordinates(const VectorX& point) {
  std::ostringstream out;
  for (Eigen::Index i = 0; i < point.size(); ++i) out << (i == 0 ? "(" : ", ") << point(i);
  out << ')';
  return out.str();
}

} // namespace signorini
