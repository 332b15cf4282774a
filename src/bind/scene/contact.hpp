#pragma once
// Contacts of a scene while sg.model reads it.

#include "bind/scene/scene_builder.hpp"

namespace signorini::bind {

/// Names become columns ("grip.fx") and stage keys, so they must be unique and different from the keys of a stage.
template <int D>
void check_name(const Arguments& a, const model::Scene<D>& scene, const std::string& name, const std::string& path);
template <int D> model::Faces read_faces(const SceneBuilder<D>& builder, const Arguments& a, const char* key);
contact::MultiplierSpace read_multipliers(const Arguments& a);
/// Law and method of a contact.
contact::Method read_method(const Arguments& a, int dimension);
/// Adds the contacts of an entry of `contacts`: one, or the two half passes of a pair of faces; of a set one, one for
/// each obstacle, and those of its pairs with laws of their own.
template <int D> void add_contact(SceneBuilder<D>& builder, const Arguments& a, const std::string& name);

} // namespace signorini::bind
