#pragma once
// Actors for coloured triangles, in the plane and in space.

#include "view/relief.hpp"

#include <vtkActor.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

namespace signorini::view {

/// Shows the mapper's triangles without light.
vtkSmartPointer<vtkActor> flat_actor(vtkPolyDataMapper& mapper);

/// Values are interpolated, then coloured; those outside the range take its end colours.
void colour_by_value(vtkPolyDataMapper& mapper, const std::array<double, 2>& range, const std::vector<Rgb>& colours);

/// Adds the relief beneath z = 0 and a light for it; nothing when it is empty.
void add_relief(vtkRenderer& renderer, const Relief& relief);

} // namespace signorini::view
