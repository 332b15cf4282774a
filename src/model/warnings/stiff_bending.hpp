#pragma once
// Bodies that bend although their elements, of degree 1 in some direction, cannot.

#include "model/steps/model.hpp"

namespace signorini::model {

/// Warns of bodies whose elements of degree 1 have much of their strain energy in tractions that vary along the
/// directions of degree 1.
///
/// An element that is linear along direction d has no curvature in it. Where it should bend, it shears instead: γ = κ ξ
/// over its length h, with the energy ½ G κ² h²/12 per volume, next to ½ E κ² t²/12 of the bending itself over a
/// thickness t; a cantilever of such elements is by 1 + (G/E)(h/t)² too stiff (T. J. R. Hughes, The Finite Element
/// Method, 1987, section 4.4). If it is linear across the thickness, its transverse strain cannot follow Poisson's
/// effect, and the transverse stress λ ε is not relieved. In both cases the traction on planes ξ_d = const varies along
/// d within the element, with zero mean; its energy, over that of the body, is the part of the stiffness that is too
/// much, exactly so in pure bending. Elsewhere tractions vary within elements by O(h), their energy by O(h²).
template <int D> void warn_of_stiff_bending(const Model<D>& model, std::vector<Message>& warnings);

/// That part of a body's energy, for displacements of its control points, D × functions. Stresses are those of the
/// small-strain constants with Green's strain, or with the linear one of linear elastic bodies.
template <int D> double locked_part(const solid::Body<D>& body, const MatrixX& displacements);

} // namespace signorini::model
