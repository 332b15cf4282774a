// Which degrees of freedom contacts act on.
#include "model/assembly.hpp"

namespace signorini::model {

template <int D>
void Assembly<D>::append_dofs(int body, const contact::Surface<D>& surface, int element, Nodes& dofs) const {
  const int* nodes = surface.nodes(element);
  for (int a = 0; a < surface.functions_on(element); ++a)
    for (int c = 0; c < D; ++c) dofs.push_back(unknowns_.offset(body) + D * surface.body_function(nodes[a]) + c);
}

template <int D>
void Assembly<D>::append_master_dofs(std::size_t k, const contact::Pair<D>& pair, int element, Nodes& dofs) const {
  const Contact<D>& contact = scene_.contacts[k];
  if (const auto* face = std::get_if<FaceReference>(&contact.master))
    append_dofs(face->body, *pair.master().surface(), element, dofs);
  else
    for (int c = 0; c < D; ++c) dofs.push_back(master_offset(contact) + c);
}

/// First degree of freedom of a contact's master body or obstacle.
template <int D> int Assembly<D>::master_offset(const Contact<D>& contact) const {
  if (const auto* face = std::get_if<FaceReference>(&contact.master)) return unknowns_.offset(face->body);
  return unknowns_.obstacle_offset(std::get<ObstacleReference>(contact.master).obstacle);
}

template <int D>
typename Assembly<D>::Nodes Assembly<D>::columns(std::size_t k, const contact::Pair<D>& pair,
                                                 const contact::Group& group) const {
  Nodes dofs;
  append_dofs(scene_.contacts[k].slave.body, pair.slave(), group.slave_element, dofs);
  append_master_dofs(k, pair, group.master_element, dofs);
  if (group.slip_element >= 0) append_master_dofs(k, pair, group.slip_element, dofs);
  return dofs;
}

template <int D> void Assembly<D>::move(std::vector<contact::Pair<D>>& pairs, const VectorX& displacement) const {
  for (std::size_t k = 0; k < pairs.size(); ++k)
    pairs[k].move(displacement.data() + unknowns_.offset(scene_.contacts[k].slave.body),
                  displacement.data() + master_offset(scene_.contacts[k]));
}

template void Assembly<2>::append_dofs(int, const contact::Surface<2>&, int, Nodes&) const;
template void Assembly<2>::append_master_dofs(std::size_t, const contact::Pair<2>&, int, Nodes&) const;
template int Assembly<2>::master_offset(const Contact<2>&) const;
template Assembly<2>::Nodes Assembly<2>::columns(std::size_t, const contact::Pair<2>&, const contact::Group&) const;
template void Assembly<2>::move(std::vector<contact::Pair<2>>&, const VectorX&) const;
template void Assembly<3>::append_dofs(int, const contact::Surface<3>&, int, Nodes&) const;
template void Assembly<3>::append_master_dofs(std::size_t, const contact::Pair<3>&, int, Nodes&) const;
template int Assembly<3>::master_offset(const Contact<3>&) const;
template Assembly<3>::Nodes Assembly<3>::columns(std::size_t, const contact::Pair<3>&, const contact::Group&) const;
template void Assembly<3>::move(std::vector<contact::Pair<3>>&, const VectorX&) const;

} // namespace signorini::model
