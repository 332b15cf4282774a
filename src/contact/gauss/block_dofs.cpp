#include "contact/gauss/block_dofs.hpp"

namespace signorini::contact {

namespace {

template <int D> void append_node(int node, int first, std::vector<int>& dofs) {
  for (int c = 0; c < D; ++c) dofs.push_back(first + D * node + c);
}

} // namespace

template <int D> void append_element(const Surface<D>& face, int element, int first, std::vector<int>& dofs) {
  const int* nodes = face.nodes(element);
  for (int a = 0; a < face.functions_on(element); ++a) append_node<D>(face.body_function(nodes[a]), first, dofs);
}

template <int D>
void append_master(const Master<D>& master, int element, const Offsets& offsets, std::vector<int>& dofs,
                   bool and_next) {
  if (master.rigid()) {
    for (int node = 0; node < master.functions_on(0); ++node) append_node<D>(node, offsets.master, dofs);
    return;
  }
  const Surface<D>& face = *master.surface();
  append_element(face, element, offsets.master, dofs);
  for (int alpha = 0; alpha < D - 1 && and_next; ++alpha)
    for (const bool at_end : {false, true})
      if (const int next = face.neighbor(element, alpha, at_end); next >= 0)
        append_element(face, next, offsets.master, dofs);
}

template <int D>
void append_dofs(const Faces<D>& faces, const Block& block, const Offsets& offsets, std::vector<int>& dofs) {
  const Surface<D>& slave = faces.slave;
  const Master<D>& master = faces.master;
  if (block.group >= 0) {
    for (const int node : block.slave_nodes) append_node<D>(slave.body_function(node), 0, dofs);
    for (const int node : block.master_nodes)
      append_node<D>(master.rigid() ? node : master.surface()->body_function(node), offsets.master, dofs);
  } else {
    append_element(slave, block.slave_element, 0, dofs);
    append_master(master, block.master_element, offsets, dofs);
  }
  for (const int number : block.extra) dofs.push_back(offsets.extra + number);
  if (block.group < 0 && block.slip_element >= 0) append_master(master, block.slip_element, offsets, dofs);
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template void append_dofs(const Faces<D>&, const Block&, const Offsets&, std::vector<int>&);                         \
  template void append_element(const Surface<D>&, int, int, std::vector<int>&);                                        \
  template void append_master(const Master<D>&, int, const Offsets&, std::vector<int>&, bool);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::contact
