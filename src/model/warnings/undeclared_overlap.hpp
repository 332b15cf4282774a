#pragma once
// Bodies that pass through each other, through themselves or through obstacles where no contact is declared.

#include "model/checks/constants.hpp"
#include "model/checks/outline.hpp"
#include "model/steps/model.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace signorini::model {

/// The outlines of a model's bodies in the present state, and what their contacts declare.
template <int D> class PresentOutlines {
public:
  explicit PresentOutlines(const Model<D>& model);

  const Scene<D>& scene() const { return scene_; }
  int bodies() const { return std::ssize(outlines_); }
  const Outline<D>& operator[](int body) const { return outlines_[body]; }
  /// True if a face is joined with another one, closes its own patch or is on the axis of revolution, and so lies
  /// within a body.
  bool within(int body, nurbs::Side side) const { return within_[body][number_of(side)]; }
  /// True if bodies are parts of one: equal, or joined.
  bool joined(int first, int second) const { return part(first) == part(second); }
  /// The first of a body and those joined with it.
  int part(int body) const { return parts_[body]; }
  /// The depth up to which a place of a body may penetrate without a contact: 1 % of its thickness, the error of the
  /// outline there, and what is declared for its faces in contact.
  double allowed(int body, const Facet<D>& facet) const {
    return std::max({small_overlap * outlines_[body].thickness(), declared_[body], 2 * facet.sagitta});
  }

private:
  const Scene<D>& scene_;
  std::vector<Outline<D>> outlines_;
  std::vector<Sides<D>> within_;
  std::vector<int> parts_;
  std::vector<double> declared_;
};

/// Contacts of a scene for which `declares` returns true.
struct DeclaredContacts {
  std::string first;       ///< name; empty if there is none
  bool everywhere = false; ///< one is switched on and has no region
  int active = 0;          ///< points
};
template <int D, class Declares> DeclaredContacts declared_contacts(const Model<D>& model, const Declares& declares) {
  DeclaredContacts declared;
  for (std::size_t k = 0; k < model.system.contacts.size(); ++k) {
    const Contact<D>& contact = model.system.scene.contacts[k];
    if (!declares(contact)) continue;
    if (declared.first.empty()) declared.first = contact.name;
    const contact::Formulation<D>& formulation = *model.system.contacts[k]; // the scene does not keep regions
    if (formulation.points().whole && formulation.parameters().active(model.present.contacts[k].changes))
      declared.everywhere = true;
    declared.active += contact::resultant(model.present.contacts[k]).active;
  }
  return declared;
}

/// Appends a warning for each two bodies that overlap deeper than allowed(), and for each body that overlaps itself, at
/// the deepest place on faces between which there is neither a contact nor a tie, if it is deeper than the places of
/// faces with one. Contacts that are switched off and regions without contact count as declared. Between faces with a
/// contact an overlap is reported if none of its points is active. Places are the middles of the outlines' pieces: in
/// space a penetration narrower than these is not found.
template <int D>
void warn_of_overlaps(const Model<D>& model, const PresentOutlines<D>& outlines, std::vector<Message>& warnings);

/// Appends a warning for each body that overlaps itself in the shape in which it starts, if a set of faces is in
/// contact with itself there: it takes what lies behind its own faces for the back of a wall [theory 8.4].
template <int D> void warn_of_folded_shapes(const Model<D>& model, std::vector<Message>& warnings);

} // namespace signorini::model
