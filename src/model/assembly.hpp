#pragma once
// Puts the elements' and contacts' contributions into one residual and one tangent of fixed sparse pattern.

#include "model/partition.hpp"
#include "model/state.hpp"
#include "solid/internal.hpp"
#include "solve/pattern.hpp"

#include <optional>
#include <unordered_map>

namespace signorini::model {

/// Which element of which body turned inside out.
struct BodyInversion {
  int body;
  solid::Inversion inversion;
};

/// Seconds spent, summed over a model's life.
struct Timings {
  double bulk = 0, contact = 0, linear = 0;
  double factorization = 0, solution = 0; ///< what linear consists of, but for a few vectors
};

/// A state that is tried out, next to the accepted one that it started from.
template <int D> struct States {
  State<D>& present;
  const State<D>& accepted;
  const std::vector<contact::Controls>& controls; ///< by contact
};

template <int D> class Assembly {
public:
  Assembly(const Scene<D>& scene, const Unknowns<D>& unknowns, const contact::Formulations<D>& contacts);

  /// Force f_int + f_c of all degrees of freedom, into the present state, and tangent of the unknowns there. Contacts
  /// write into it where their searches ended and what their points did. The full tangent times `direction` (all
  /// degrees of freedom, may be null) goes to product(): how prescribed displacements enter a linear solve. Returns
  /// where an element is inverted; the results are then meaningless.
  ///
  /// Without `tangent` the residual alone is computed, and values() no longer belong to it; there must be no direction.
  std::optional<BodyInversion> assemble(const States<D>& states, const VectorX* direction, bool tangent,
                                        Timings& timings);

  /// Moves the contacts' faces to where the bodies and obstacles are at `displacement`.
  void move(const VectorX& displacement) const;
  /// Goes back to the pattern of the bodies alone, and to no contact unknowns: as newly made.
  void forget_contacts();

  const VectorX& product() const { return product_; }
  /// Values of the tangent in the order of pattern(), and others behind them.
  const std::vector<double>& values() const { return values_; }
  const solve::Pattern& pattern() const { return pattern_; }
  /// Grows by one whenever the pattern is a new one.
  int pattern_version() const { return version_; }
  /// The tangent of bodies that are all linear elastic, to which contacts add; otherwise empty.
  const std::vector<double>& constant_values() const { return constant_; }
  /// The unknowns that contacts have added to or may soon, sorted; they grow in leaps, each with a new version. Kept
  /// where bodies are linear, and in space.
  const std::vector<int>& contact_unknowns() const { return contact_unknowns_; }
  int contact_version() const { return contact_version_; }
  /// 2-norm of the last tangent's diagonal; 0 before the first.
  double diagonal_norm() const { return diagonal_norm_; }
  /// The last tangent's diagonal, by unknown.
  VectorX diagonal() const;
  /// Adds to it.
  void add_diagonal(const VectorX& shift);
  /// Bytes of the tangent, its patterns and the places of the elements' entries in it.
  double memory() const;

private:
  using Nodes = std::vector<int>;
  void build_bulk();
  void build_constant();
  void cover(bool contacts);
  bool locate();
  void watch_contacts();
  /// What an assembly is asked for.
  struct Request {
    const States<D>& states;
    const VectorX* direction;
    bool tangent;
  };
  struct Task;
  std::optional<BodyInversion> add_bulk(const Request& request, Timings& timings);
  void clear(const Request& request);
  void add_elements(const std::vector<int>& elements, const Request& request, Task& task);
  void add_element(int e, const Request& request, Task& task);
  void scatter(int body, int e, const solid::ElementArrays<D>& arrays, double* values) const;
  void multiply(int body, int e, const solid::ElementArrays<D>& arrays, const VectorX& direction);
  void add_contacts(const Request& request);
  void find_diagonal_norm();

  /// Where a contact block's entries go; found once per pattern.
  struct Placement {
    Nodes rows, columns;        ///< degrees of freedom
    std::vector<int> positions; ///< in values_, row by row
  };

  const Scene<D>& scene_;
  const Unknowns<D>& unknowns_;
  const contact::Formulations<D>& contacts_;
  solve::Pattern bulk_pattern_, pattern_;
  std::vector<int> bulk_positions_, positions_;          ///< per element and block entry: in bulk_pattern_, in pattern_
  std::vector<std::vector<std::size_t>> first_position_; ///< [body][element]
  std::vector<std::vector<char>> holds_;                 ///< [body][element]: has degrees of freedom that are held
  std::vector<std::unordered_map<std::uint64_t, Placement>> placements_; ///< per contact, by Block::key()
  std::vector<Partition> partitions_;                                    ///< per body
  std::vector<solid::ElementArrays<D>> arrays_;                          ///< per body and share of its partition
  std::vector<int> diagonal_;
  std::vector<double> values_;   ///< one more than entries: what belongs to prescribed degrees of freedom lands there
  std::vector<double> constant_; ///< bulk values of linear bodies, in the order of pattern_
  bool linear_ = true;
  std::vector<int> contact_unknowns_;
  std::vector<char> is_contact_unknown_;
  int contact_version_ = 0;
  VectorX product_;
  double diagonal_norm_ = 0;
  int version_ = 0;
};

} // namespace signorini::model
