#pragma once
// The interface of signorini_mumps.so, the only part of the program that is linked with MUMPS and MPI. It passes
// matrices and numbers; what they mean to a run is decided in mumps.cpp.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace signorini::solve {

/// How MUMPS factors and stores.
struct MumpsSettings {
  double low_rank = 0;     ///< tolerance of block low rank compression, relative to the matrix; 0: exact factors
  bool single = false;     ///< factors in single precision
  std::string folder = {}; ///< folder of the factors' files; empty: factors in memory

  bool operator==(const MumpsSettings&) const = default;
};

/// Positions of the entries, and the pivot order, numbered from 1. Of symmetric matrices the lower triangle.
struct MumpsPattern {
  int size = 0;
  std::vector<int> rows, columns;
  std::vector<int> order; ///< place of each unknown in the sequence of pivots
};

/// Results of a call.
struct MumpsReport {
  int status = 0, detail = 0;    ///< INFOG(1), negative after errors, and INFOG(2)
  double operations = 0;         ///< of the factorization
  double entries = 0;            ///< of the factors
  double peak = 0;               ///< bytes that the rank with most memory used
  int negative = 0;              ///< negative pivots of a symmetric matrix
  int null = 0;                  ///< zero pivots
  double least = 0, largest = 0; ///< pivots of the scaled matrix, by absolute value
};

/// One matrix, distributed over all ranks by MUMPS. All calls are made on rank 0.
class MumpsInstance {
public:
  virtual ~MumpsInstance() = default;
  /// Sets the pattern, which has to outlive the instance.
  virtual MumpsReport analyze(const MumpsPattern& pattern) = 0;
  virtual MumpsReport factor(const double* values) = 0;
  /// Overwrites b by the solution.
  virtual MumpsReport solve(double* b) = 0;
};

/// What the module exports as `signorini_mumps`.
struct MumpsModule {
  std::string (*description)();
  std::unique_ptr<MumpsInstance> (*make)(const MumpsSettings&, bool symmetric);
  /// Joins the processes that mpirun has started, and returns this one's rank, or −1 on all of them if they do not have
  /// the same `version`.
  int (*join)(const std::string& version);
  /// For ranks other than 0: takes part in factorizations until rank 0 ends.
  void (*serve)();
};

} // namespace signorini::solve
