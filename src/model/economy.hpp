#pragma once
// What a scene models with more than it may need: bodies that hardly deform, high degrees far from contact, contact
// points beyond what a face's degree asks for.

#include "model/model.hpp"

namespace signorini::model {

/// A body that might be a rigid obstacle: at least 100 times as stiff (E) as every body that it is in contact with, and
/// one support prescribes how it moves, without turning it.
struct StiffBody {
  int body, partner; ///< the stiffest of those it touches
  double ratio;      ///< of the two moduli
  int unknowns;      ///< what the obstacle would save
};
template <int D> std::vector<StiffBody> find_stiff_bodies(const Model<D>& model);

/// Another label for a body.
struct LabelChoice {
  int body;
  std::vector<std::string> labels; ///< along each direction of the contact face
  int unknowns;                    ///< the body's with these
  std::optional<int> through = {}; ///< the present degree in the thickness direction, unless these labels imply it
};
/// Uniform degrees above 2 where only the contact face may need them: the same row there, N2 elsewhere, where N2 holds
/// the shape.
template <int D> std::vector<LabelChoice> find_layers(const Model<D>& model);
/// Layers on faces that are in no contact: the label of the bulk.
template <int D> std::vector<LabelChoice> find_idle_layers(const Model<D>& model);

/// A contact with more than twice 3(p+1) points per element and direction, p the highest degree along its slave face.
/// Contacts that a region limits are passed over.
struct DenseContact {
  int contact;
  int enough; ///< 3(p+1)
  int points; ///< in all, with these
};
template <int D> std::vector<DenseContact> find_dense_contacts(const Model<D>& model);

} // namespace signorini::model
