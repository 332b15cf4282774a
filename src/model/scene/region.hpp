#pragma once
// Regions of contacts as lists of their points, for files and for models with other rows.

#include "contact/gauss/formulation.hpp"
#include "model/scene/scene.hpp"

namespace signorini::model {

template <int D> using RegionPoints = Eigen::Matrix<double, D, Eigen::Dynamic>;

/// Reference positions of the contact points in the region; no columns if it contains all.
template <int D> RegionPoints<D> points_of_region(const contact::Formulation<D>& formulation);
/// Reference positions of the bonded points of a cohesive contact; no columns if all are bonded.
template <int D> RegionPoints<D> bonded_points(const contact::Formulation<D>& formulation);
/// The region of the points whose coordinates differ from these by at most `tolerance`; everywhere if there are none.
template <int D> contact::Region<D> region_of(const RegionPoints<D>& points, double tolerance = 0);
/// A contact of a model with its regions, which the model's scene does not keep. `size`: of coordinates.
template <int D> Contact<D> with_regions(Contact<D> contact, const contact::Formulation<D>& formulation, double size);

} // namespace signorini::model
