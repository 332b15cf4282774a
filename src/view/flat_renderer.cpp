#include "view/flat_renderer.hpp"

#include "view/module.hpp"
#include "view/text.hpp"

namespace signorini::view {

const FlatRenderer& flat_renderer() {
  static const FlatRenderer& loaded =
      *static_cast<const FlatRenderer*>(module_table("signorini_flat.so", "signorini_flat"));
  return loaded;
}

double text_width(std::string_view utf8, double size) {
  return flat_renderer().text_width(std::string(utf8), size);
}

} // namespace signorini::view
