#pragma once
// The processes that share factorizations. Rank 0 runs the program; the others wait for its commands.

#include <string>

namespace signorini::solve::mumps {

/// A call of MUMPS in which all ranks take part. Sent as bytes: ranks run the same version on the same architecture.
struct Command {
  int job;          ///< MUMPS' number of the job
  int instance = 0; ///< number of the matrix
  bool symmetric = false, single = false;
  double low_rank = 0;
  char folder[256] = {}; ///< the length of MUMPS' own field
};

/// Jobs with a meaning of their own besides MUMPS' 1, 2, 3.
inline constexpr int begin_instance = -1, end_instance = -2, end_of_run = 0;

/// See MumpsModule.
int join(const std::string& version);
/// Fortran's number of the communicator. Starts MPI if needed.
int communicator();
/// Sends a command from rank 0 to the others.
void send(const Command& command);
/// The next command of rank 0, which this rank awaits asleep.
Command receive();
/// "Open MPI …, 4 ranks"
std::string ranks_description();

} // namespace signorini::solve::mumps
