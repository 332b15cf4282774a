#include "solve/mumps/ranks.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <mpi.h>
#include <set>
#include <unistd.h>

namespace signorini::solve::mumps {

namespace {

constexpr long first_nap = 20'000, longest_nap = 5'000'000; // ns

/// With one process, a group of its own: it need not be part of what mpirun has started.
MPI_Comm group = MPI_COMM_SELF;

int size() {
  int count = 0;
  MPI_Comm_size(group, &count);
  return count;
}

/// Without MPI_Finalize on all ranks mpirun reports an abnormal end.
void finish() {
  int rank = 0;
  MPI_Comm_rank(group, &rank);
  if (rank == 0) send(Command{end_of_run});
  MPI_Finalize();
}

std::set<std::string> environment() {
  std::set<std::string> names;
  for (char** entry = environ; *entry; ++entry) names.emplace(*entry, std::strcspn(*entry, "="));
  return names;
}

void start() {
  int started = 0;
  MPI_Initialized(&started);
  if (started) return;
  const std::set<std::string> before = environment();
  const bool alone = !before.count("OMPI_COMM_WORLD_SIZE") && !before.count("PMIX_RANK");
  if (alone) { // starts no daemon for processes that it will never spawn, makes no folder, and looks for no network
    ::setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
    ::setenv("OMPI_MCA_orte_create_session_dirs", "0", 0);
    ::setenv("OMPI_MCA_btl", "self", 0);
  }
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
  std::atexit(finish);
  if (!alone) return;
  // A script may start mpirun, which would take the variables of this process for its own.
  for (const std::string& name : environment())
    if (!before.count(name)) ::unsetenv(name.c_str());
}

} // namespace

int join(const std::string& version) {
  start();
  group = MPI_COMM_WORLD;
  int rank = 0, same = 0;
  MPI_Comm_rank(group, &rank);
  char leading[64] = {}, own[64] = {};
  std::copy_n(version.begin(), std::min(version.size(), sizeof own - 1), own);
  std::copy_n(own, sizeof own, leading);
  MPI_Bcast(leading, sizeof leading, MPI_BYTE, 0, group);
  const int agrees = std::memcmp(leading, own, sizeof own) == 0;
  MPI_Allreduce(&agrees, &same, 1, MPI_INT, MPI_MIN, group);
  if (same) return rank;
  group = MPI_COMM_SELF;
  return -1;
}

int communicator() {
  start();
  return MPI_Comm_c2f(group);
}

void send(const Command& command) {
  if (size() == 1) return;
  Command sent = command;
  MPI_Request request;
  MPI_Ibcast(&sent, sizeof sent, MPI_BYTE, 0, group, &request);
  MPI_Wait(&request, MPI_STATUS_IGNORE);
}

/// Blocking receives of MPI spin; naps that grow leave the processor to others and cost little time after a command.
Command receive() {
  Command command{end_of_run};
  MPI_Request request;
  MPI_Ibcast(&command, sizeof command, MPI_BYTE, 0, group, &request);
  for (long nap = first_nap;; nap = std::min(2 * nap, longest_nap)) {
    int arrived = 0;
    MPI_Test(&request, &arrived, MPI_STATUS_IGNORE);
    if (arrived) return command;
    const timespec time{0, nap};
    ::nanosleep(&time, nullptr);
  }
}

std::string ranks_description() {
  start();
  char words[MPI_MAX_LIBRARY_VERSION_STRING];
  int length = 0;
  MPI_Get_library_version(words, &length);
  const std::string all(words, static_cast<std::size_t>(length)), library = all.substr(0, all.find(','));
  return library + ", " + std::to_string(size()) + (size() == 1 ? " rank" : " ranks");
}

} // namespace signorini::solve::mumps
