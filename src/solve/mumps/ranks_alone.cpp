// For MUMPS without MPI: this process is the only rank.
#include "solve/mumps/ranks.hpp"

namespace signorini::solve::mumps {

int join(const std::string&) {
  return 0;
}

int communicator() {
  return 0; // not used by MUMPS' own replacement of MPI
}

void send(const Command&) {}

Command receive() {
  return Command{end_of_run};
}

std::string ranks_description() {
  return "without MPI";
}

} // namespace signorini::solve::mumps
