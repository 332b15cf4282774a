#include "base/error.hpp"

namespace signorini {

void fail(const char* code, std::initializer_list<Datum> data) {
  throw Error(Message(code, data));
}

} // namespace signorini
