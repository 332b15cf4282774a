#pragma once
// Completeness of films in Ogg.

#include <string_view>

namespace signorini::view {

/// Whether the bytes are all pages of one Ogg stream, to the one that is marked as the last (RFC 3533, section 6).
bool is_whole_ogg(std::string_view bytes);

} // namespace signorini::view
