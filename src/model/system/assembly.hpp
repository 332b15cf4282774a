#pragma once
// Assembly of the elements' and contacts' contributions into one residual and one sparse tangent.

#include "model/system/follower_loads.hpp"
#include "model/system/partition.hpp"
#include "model/system/springs.hpp"
#include "model/system/state.hpp"
#include "model/system/tie_terms.hpp"
#include "solid/internal.hpp"
#include "solve/symmetric_blocks.hpp"

#include <optional>
#include <unordered_map>

namespace signorini::model {

/// An inverted element of a body.
struct BodyInversion {
  int body;
  solid::Inversion inversion;
};

/// Seconds spent, summed over a model's lifetime.
struct Timings {
  double bulk = 0, contact = 0, linear = 0;
  double factorization = 0, solution = 0; ///< parts of `linear`, without some vector operations
};

/// A trial state and the accepted state.
template <int D> struct States {
  State<D>& present;
  const State<D>& accepted;
  const std::vector<contact::Controls>& controls; ///< by contact
  const VectorX& loads;                           ///< targets at which the loads act
};

template <int D> class Assembly {
public:
  Assembly(const Scene<D>& scene, const Unknowns<D>& unknowns, const contact::Formulations<D>& contacts,
           const contact::Ties<D>& ties, const FollowerLoads<D>& followers, const Springs<D>& springs);

  /// Assembles the force f_int + f_c of all degrees of freedom, into the present state, and the tangent of the
  /// unknowns, with that of the loads that follow the deformation. Contacts write foot points and results into the
  /// present state. product() becomes the full tangent times `direction` (all degrees of freedom, may be null), by
  /// which prescribed displacements enter a linear solve. If an element is inverted, returns it, and the results are
  /// undefined.
  ///
  /// Without `tangent` only the force is computed, values() are not updated, and `direction` must be null.
  std::optional<BodyInversion> assemble(const States<D>& states, const VectorX* direction, bool tangent,
                                        Timings& timings);

  /// Moves the contacts' faces to the positions of bodies and obstacles at `displacement`.
  void move(const VectorX& displacement) const;
  /// Resets the pattern to that of bodies and ties, without contact unknowns, as after construction.
  void forget_contacts();

  const VectorX& product() const { return product_; }
  /// Values of the tangent in the order of pattern(), followed by unused values.
  const std::vector<double>& values() const { return values_; }
  const solve::Pattern& pattern() const { return pattern_; }
  /// Incremented whenever the pattern changes.
  int pattern_version() const { return version_; }
  /// Energy stored in the bodies at a displacement and internal variables, see solid::stored_energy().
  double stored_energy(const VectorX& displacement, const std::vector<std::vector<double>>& internal) const;
  /// The same of one body.
  double stored_energy(int body, const VectorX& displacement, const std::vector<std::vector<double>>& internal) const;
  /// The constant tangent of bodies, springs and ties if all bodies are linear elastic; otherwise empty.
  const std::vector<double>& constant_values() const { return constant_; }
  /// The unknowns on which contacts act or may soon act, sorted. The list is extended in large pieces, each with a new
  /// contact_version(). It contains tie_border() and the unknowns of obstacles.
  const std::vector<int>& contact_unknowns() const { return contact_unknowns_; }
  int contact_version() const { return contact_version_; }
  /// 2-norm of the last tangent's diagonal; 0 before the first.
  double diagonal_norm() const { return diagonal_norm_; }
  /// The last tangent's diagonal, by unknown.
  VectorX diagonal() const;
  /// Adds a vector, by unknown, to the tangent's diagonal.
  void add_diagonal(const VectorX& shift);
  /// Bytes of the tangent, its patterns, the positions of the elements' entries and the stiffness of linear bodies.
  double memory() const;

private:
  using Nodes = std::vector<int>;
  void build_bulk();
  void build_stiffness();
  void build_constant();
  void move_constant(std::vector<int> moved);
  void list_contact_unknowns();
  void forget_contact_unknowns();
  void add_ties(double* values) const;
  void cover(bool contacts);
  bool locate();
  void watch_contacts();
  /// Arguments of assemble().
  struct Request {
    const States<D>& states;
    const VectorX* direction;
    bool tangent;
  };
  struct Task;
  std::optional<BodyInversion> add_bulk(const Request& request, Timings& timings);
  void clear(const Request& request);
  void set_values(const Request& request);
  void add_elements(const std::vector<int>& elements, const Request& request, Task& task);
  void add_element(int e, const Request& request, Task& task);
  void add_linear_body(const Request& request, Task& task);
  void scatter(int body, int e, const solid::ElementArrays<D>& arrays);
  void multiply(int body, int e, const solid::ElementArrays<D>& arrays, const VectorX& direction);
  void add_contacts(const Request& request);
  void add_angles(const Request& request);
  void locate_face_terms();
  void add_springs(double* values) const;
  void add_followers(const Request& request);
  void find_diagonal_norm();

  struct Support {
    bool any;   ///< an element has supported degrees of freedom
    bool whole; ///< see whole_nodes()
  };
  /// Rows of a contact block with consecutive unknowns, whose entries follow each other in every column of the tangent.
  struct RowRun {
    int first, count;
  };
  /// Positions of a contact block's entries, determined once per pattern.
  struct Placement {
    Nodes rows, columns;        ///< degrees of freedom
    std::vector<int> positions; ///< in values_, run by run: of the first row in every column, −1 without unknown
    std::vector<RowRun> runs;
  };

  const Scene<D>& scene_;
  const Unknowns<D>& unknowns_;
  const contact::Formulations<D>& contacts_;
  const FollowerLoads<D>& followers_;
  const Springs<D>& springs_;
  TieTerms ties_;
  std::vector<int> border_; ///< of ties, and the unknowns of obstacles
  solve::Pattern bulk_pattern_, pattern_;
  std::vector<int> bulk_positions_, positions_;          ///< see scatter(): in bulk_pattern_, in pattern_
  std::vector<std::vector<std::size_t>> first_position_; ///< [body][element]
  std::vector<std::vector<Support>> supports_;           ///< [body][element]
  std::vector<std::unordered_map<std::uint64_t, Placement>> placements_; ///< per contact, by Block::key()
  std::vector<Partition> partitions_;                                    ///< per body, unless linear_
  std::vector<solid::ElementArrays<D>> arrays_;                          ///< per body and share of its partition
  std::vector<int> tie_positions_; ///< in values_, of each coupling and its transpose; −1 without unknown
  std::vector<int> follower_positions_, spring_positions_;
  std::vector<int> diagonal_;
  std::vector<double> values_;          ///< after the entries D per share, for those of prescribed degrees of freedom
  std::vector<double> constant_;        ///< bulk values of linear bodies, in the order of pattern_
  std::vector<int> constant_positions_; ///< of the entries of bulk_pattern_ in constant_
  std::optional<std::vector<int>> changed_; ///< of linear bodies: entries of values_ that may differ from constant_;
                                            ///< nothing: any
  bool linear_ = true; ///< whether all bodies are; if so, no elements are assembled after construction
  std::vector<solve::SymmetricBlocks<D>> stiffness_; ///< of all degrees of freedom of each body, if linear_
  std::vector<int> contact_unknowns_;
  std::vector<char> is_contact_unknown_;
  int contact_version_ = 0;
  VectorX product_;
  /// Of each nonlinear body the energy that stored_energy() computed last: at the end of a stage it is needed twice.
  struct KnownEnergy {
    VectorX displacement;
    std::vector<double> internal;
    double energy = 0;
  };
  mutable std::vector<KnownEnergy> energies_;
  double diagonal_norm_ = 0;
  int version_ = 0;
};

} // namespace signorini::model
