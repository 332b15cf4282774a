#include "model/warnings/deep_wear.hpp"

#include "model/constants.hpp"
#include "model/scene/thickness.hpp"

#include <cmath>

namespace signorini::model {

template <int D> void warn_of_deep_wear(const Model<D>& model, std::vector<Message>& warnings) {
  const Scene<D>& scene = model.system.scene;
  for (std::size_t k = 0; k < scene.contacts.size(); ++k) {
    const double depth = contact::resultant(model.present.contacts[k]).max_wear;
    const double part = depth / thickness(scene, scene.contacts[k].slave);
    if (part > much_wear)
      warnings.push_back(
          Message("model.warning.deep_wear",
                  {{"contact", scene.contacts[k].name}, {"depth", depth}, {"percent", std::round(100 * part)}}));
  }
}

template void warn_of_deep_wear(const Model<2>&, std::vector<Message>&);
template void warn_of_deep_wear(const Model<3>&, std::vector<Message>&);

} // namespace signorini::model
