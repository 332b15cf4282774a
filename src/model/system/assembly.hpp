#pragma once
// Residual and tangent of a system: the bodies' (bulk_assembly.hpp), the contacts' (contact_assembly.hpp), and those of
// ties, springs, and loads that follow the deformation.

#include "model/system/constant_tangent.hpp"
#include "model/system/contact_assembly.hpp"
#include "model/system/follower_loads.hpp"

namespace signorini::model {

/// Seconds spent, summed over a model's lifetime.
struct Timings {
  double bulk = 0, contact = 0, linear = 0;
  double factorization = 0, solution = 0; ///< parts of `linear`, without some vector operations
};

template <int D> class Assembly {
public:
  Assembly(const Scene<D>& scene, const Unknowns<D>& unknowns, const contact::Formulations<D>& contacts,
           const contact::Ties<D>& ties, const FollowerLoads<D>& followers, const Springs<D>& springs);
  Assembly(const Assembly&) = delete; // its parts refer to each other
  Assembly& operator=(const Assembly&) = delete;

  /// Assembles the force f_int + f_c of all degrees of freedom, into the present state, and the tangent of the
  /// unknowns, with that of the loads that follow the deformation. Contacts write foot points and results into the
  /// present state. product() becomes the full tangent times `direction` (all degrees of freedom, may be null), by
  /// which prescribed displacements enter a linear solve. If an element is inverted, returns it, and the results are
  /// undefined.
  ///
  /// Without `tangent` only the force is computed, tangent() is not updated, and `direction` must be null.
  std::optional<BodyInversion> assemble(const States<D>& states, const VectorX* direction, bool tangent,
                                        Timings& timings);

  /// Moves the contacts' faces to the positions of bodies and obstacles at `displacement`.
  void move(const VectorX& displacement) const;
  /// Resets the pattern to that of bodies and ties, without contact unknowns, as after construction.
  void forget_contacts();
  /// Adds a vector, by unknown, to the tangent's diagonal.
  void add_diagonal(const VectorX& shift) { tangent_.add_diagonal(shift); }

  const VectorX& product() const { return product_; }
  const SparseTangent& tangent() const { return tangent_; }
  const BulkAssembly<D>& bulk() const { return bulk_; }
  const ConstantTangent<D>& constant() const { return constant_; }
  /// With the unknowns of ties and obstacles in the list of those of contacts.
  const ContactAssembly<D>& contact() const { return contact_; }
  /// Bytes of the tangent, its patterns, the positions of the elements' entries and the stiffness of linear bodies.
  double memory() const;

private:
  std::optional<BodyInversion> add_bodies_and_evaluate_contacts(const Evaluation<D>& evaluation, Timings& timings);
  void set_pattern(const std::vector<std::vector<int>>& groups);
  void add_followers(const Evaluation<D>& evaluation);

  const Unknowns<D>& unknowns_;
  const contact::Formulations<D>& contacts_;
  const FollowerLoads<D>& followers_;
  const Springs<D>& springs_;
  const TieTerms ties_;
  BulkAssembly<D> bulk_;
  ConstantTangent<D> constant_;
  ContactAssembly<D> contact_;
  SparseTangent tangent_;
  std::vector<int> follower_positions_; ///< in the tangent
  VectorX product_;
};

} // namespace signorini::model
