#pragma once
// Sparse direct solvers behind one face: the symbolic factorisation lives as long as the pattern, the numbers change.

#include "solve/pattern.hpp"

#include <memory>
#include <string>
#include <vector>

namespace signorini::solve {

enum class LinearKind { automatic, klu, umfpack, cholmod, banded, condensed, kept };

/// "auto", "klu", "umfpack", "cholmod", "banded", "condensed", "kept". Throws Error that lists them.
LinearKind linear_kind(const std::string& name);
/// All names that linear_kind() knows, "auto" first.
std::vector<std::string> linear_names();
std::string name_of(LinearKind kind);

/// What a solver has done since it was made.
struct SolverStatistics {
  int factorisations = 0; ///< numerical ones
  int solutions = 0;      ///< right-hand sides
  int iterations = 0;     ///< of GMRES, summed
  double operations = 0;  ///< floating-point, of one factorisation; 0: not known
  double entries = 0;     ///< that one solution with the factors reads; 0: not known
  double memory = 0;      ///< bytes of the factors
};

/// Solves K x = b for one K after the other on a structurally symmetric pattern.
class LinearSolver {
public:
  virtual ~LinearSolver() = default;
  /// Takes over new values in the order of the pattern; the first call also analyses. Returns false when the matrix is
  /// singular to working precision.
  virtual bool factor(const double* values) = 0;
  /// Overwrites b by K⁻¹ b, or by what comes as close as the solver promises. Call after a successful factor(), whose
  /// values must still be there. Returns false when the matrix turns out to be singular to working precision. May be
  /// called again for other right-hand sides.
  virtual bool solve(double* b) = 0;
  virtual LinearKind kind() const = 0;
  /// How many eigenvalues of the factored symmetric matrix are negative; −1 when the solver does not know.
  virtual int negative_pivots() const { return -1; }
  /// Goes over to another pattern of the same unknowns, as where contacts slide on, keeping what is of use; factor()
  /// comes next. Returns false when a new solver would do as well: then make one.
  virtual bool adopt(const Pattern&) { return false; }
  /// Tells which unknowns (increasing) contacts act on or will soon: what changes between them may change much. A hint;
  /// solutions are the same without.
  virtual void watch(const std::vector<int>&) {}
  virtual SolverStatistics statistics() const = 0;
};

/// A matrix K₀ + C of which only C changes from one factor() to the next.
struct Condensation {
  std::vector<double> constant; ///< K₀, symmetric, in the order of the pattern
  std::vector<int> contact;     ///< the unknowns whose rows and columns C touches, increasing
};

/// `automatic` takes KLU, but `kept` where a factorisation costs more than 70 operations for each entry that a solution
/// reads. Measured on frictional ironing and on two rings (scripts/ironing2d/problem.lua, rings2d/problem.lua), seconds
/// in the linear solver with KLU and with `kept`, behind that ratio: ironing N2 at m3 (1370 degrees of freedom, 50)
/// 2.68, 2.84, N2-N2.2 at m3 (1594, 53) 3.24, 3.90, over the whole path; N2 at m4 (5034, 87) 9.3, 5.0, N2-N2.2 at m4
/// (5482) 11.6, 5.9, over 110 of its 296 steps; slender rings, N2-N2.2 at m4 (3104, 41) 0.37, 0.41, at m5 (6176, 42)
/// 0.38, 0.37. UMFPACK takes 1.04 and 1.18 s for the rings, and as long as KLU for ironing at m4. In space the ratio is
/// 260 with 1,440 unknowns, 400 with 2,988, 600 with 6,588, 1,050 with 17,388.
///
/// `cholmod` is for symmetric tangents. While they are definite, UMFPACK takes 3.2 to 3.8 times as long with 3,167 to
/// 14,015 unknowns, KLU 0.9 to 2.5 times with 215 to 815. `banded` is for slender bodies. On strips of 200 × 10
/// elements, 4,423 to 4,555 unknowns of degrees 2, 4 and 8, UMFPACK takes 4.7, 6.1 and 5.0 times as long while the
/// tangent is symmetric and definite, else 3.7, 2.6 and 1.9; `cholmod` 1.5, 1.7 and 1.4. For bodies as high as wide it
/// is no better than UMFPACK when the tangent is not symmetric.
///
/// `kept` is for solids, and for any tangents that change little. Seconds of processor time on one thread, of UMFPACK
/// over `kept`, with as many Newton iterations to 5 %: frictionless ironing of solids by a block (1,440 unknowns of
/// degree 2) 8.9, of degree 4 (2,400) 8.4, by a spherical indenter (2,988 of N2) 7.5, (6,588 of N2-N2.2) 3.9,
/// (17,388 of N2, the first steps of pressing only) 4.3. In the plane, frictional ironing as above, KLU takes 1.2 times
/// as long as `kept` with 346 unknowns of degree 2 and 3.0 times with 1,266, UMFPACK 4.6 times with 4,834. GMRES takes
/// 3 to 4 iterations where the solver was told which unknowns to watch, 10 to 20 where it was not.
///
/// `condensed` needs the condensation, which is copied; the others pass it over. Its factor() reads the entries between
/// contact unknowns only: that all other values are those of K₀ is the caller's word. Making it takes as long as one or
/// two of UMFPACK's factorisations; each system then a small part of one, on 36 × 48 to 288 × 48 elements with a third
/// of the contact unknowns touched: 1/60 with 3,647 unknowns and 75 in contact, 1/40 with 14,015 and 291, 1/23 with
/// 14,591 and 867 (1/5 when all are touched), 1/35 with 27,839 and 579.
std::unique_ptr<LinearSolver> make_solver(LinearKind kind, const Pattern& pattern,
                                          const Condensation* condensation = nullptr);

/// What suits tangents that are symmetric: `banded` for slender bodies, whose band is at most twice √n wide, `cholmod`
/// for others. Measured, milliseconds of factor() and solve() on one thread, banded and cholmod: strip of 200 × 10
/// elements of degree 2 and 4, 2.5 and 3.7, 4.0 and 6.7; block of 64 × 24, 5.3 and 3.5; of 144 × 48, 68 and 24. There
/// UMFPACK takes 12, 24, 13 and 81.
LinearKind symmetric_choice(const Pattern& pattern);

} // namespace signorini::solve
