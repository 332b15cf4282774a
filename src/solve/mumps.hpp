#pragma once
// MUMPS, a direct solver whose factorizations the processes of mpirun share. It is in a module of its own
// (mumps_module.hpp), so that builds and runs without it need no MPI.

#include "solve/direct.hpp"
#include "solve/mumps_module.hpp"

namespace signorini::solve {

/// Multifrontal LU, or L D Lᵀ with pivots of order 1 and 2 as long as the matrices are symmetric, with pivoting,
/// ordered by nested dissection (METIS). The statistics contain the number of negative pivots, which is that of
/// negative eigenvalues. Throws Error if the module is missing.
std::unique_ptr<DirectSolver> make_mumps(const MumpsSettings& settings);

bool has_mumps();
/// Versions of MUMPS and MPI. Starts MPI; needs has_mumps().
std::string mumps_description();

/// Number of processes that mpirun has started for this run; 0 without mpirun.
int started_ranks();

/// True if this process is to run the program, as without mpirun and on rank 0. Other ranks take part in factorizations
/// until rank 0 has ended, and then return false. Throws Error on rank 0 if the module is missing, or if ranks run
/// another version of the program; on all if another launcher than Open MPI's has started several processes.
bool leads_ranks(const std::string& version);

} // namespace signorini::solve
