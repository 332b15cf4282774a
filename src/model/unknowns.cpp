#include "model/unknowns.hpp"

#include "base/error.hpp"

#include <algorithm>

namespace signorini::model {

std::string component_name(int component) {
  return std::string(1, static_cast<char>('x' + component));
}

template <int D> Unknowns<D>::Unknowns(const Scene<D>& scene) {
  int count = 0;
  for (const auto& body : scene.bodies) {
    offsets_.push_back(count);
    count += D * body.body->functions();
  }

  // Who holds each degree of freedom, and how
  std::vector<const Support<D>*> holder(static_cast<std::size_t>(count), nullptr);
  for (const Support<D>& support : scene.supports)
    for (int c = 0; c < D; ++c) {
      const Hold hold = support.hold[static_cast<std::size_t>(c)];
      std::vector<int> list;
      for (const Held& held : support.on)
        for (int function : held.functions) list.push_back(offset(held.body) + D * function + c);
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
      if (hold != Hold::free)
        for (int dof : list) {
          const Support<D>*& other = holder[static_cast<std::size_t>(dof)];
          const bool both_fixed = hold == Hold::fixed && (!other || other->hold[static_cast<std::size_t>(c)] == hold);
          require(!other || both_fixed, "supports: '", support.name, "' ", hold == Hold::driven ? "drives " : "fixes ",
                  component_name(c), " of a control point that '", other ? other->name : "", "' already ",
                  other && other->hold[static_cast<std::size_t>(c)] == Hold::driven ? "drives" : "fixes",
                  "; a component is held by one support: take it out of one of the two");
          other = &support;
        }
      of_support_.push_back(list);
      driven_.push_back(hold == Hold::driven ? std::move(list) : std::vector<int>{});
    }

  for (int dof = 0; dof < count; ++dof) {
    const bool held = holder[static_cast<std::size_t>(dof)] != nullptr;
    unknown_.push_back(held ? -1 : static_cast<int>(free_.size()));
    (held ? prescribed_ : free_).push_back(dof);
  }
}

template class Unknowns<2>;
template class Unknowns<3>;

} // namespace signorini::model
