#pragma once
// Where results have kinks: points that change between open, stick and slip, next to the run and farther away.

#include "model/steps/model.hpp"

namespace signorini::model {

template <int D> struct Neighbors;

template <int D> struct Kinks {
  int points = 0;                ///< whose states differ between the neighbors and the run
  double share = 0;              ///< of them in the forces of all contacts, without sign
  int contact = -1;              ///< of the one with the largest force
  Vec<D> place = Vec<D>::Zero(); ///< of it, in the reference configuration
  /// The relative change of the parameter at which, by the derivatives of pressure and friction, touching points with
  /// the share `heavy` of the forces open or begin to slip; infinite if none do.
  double reach = 0;
};

template <int D> Kinks<D> find_kinks(const Model<D>& run, const Neighbors<D>& neighbors);

} // namespace signorini::model
