#pragma once
// Bytes as text, for XML, HTML and terminals.

#include <string>
#include <string_view>

namespace signorini {

/// The Base64 encoding of bytes (RFC 4648), padded, on one line.
std::string base64(std::string_view bytes);

} // namespace signorini
