// MUMPS (Amestoy, Duff, L'Excellent, Koster, SIAM J. Matrix Anal. Appl. 23, 2001; Amestoy, Buttari, L'Excellent, Mary,
// ACM TOMS 45, 2019), version 5: instances in double and single precision on all ranks. Numbers of controls and results
// are those of its manual.
#include "solve/mumps/ranks.hpp"
#include "solve/mumps_module.hpp"

#include <dmumps_c.h>
#include <smumps_c.h>

#include <algorithm>
#include <cstring>
#include <map>

namespace signorini::solve::mumps {

namespace {

template <class Real> struct Library;
template <> struct Library<double> {
  using Data = DMUMPS_STRUC_C;
  static void call(Data& data) { dmumps_c(&data); }
};
template <> struct Library<float> {
  using Data = SMUMPS_STRUC_C;
  static void call(Data& data) { smumps_c(&data); }
};

/// This rank's part of a matrix.
class Part {
public:
  virtual ~Part() = default;
  virtual void call(int job) = 0;
};

template <class Real> class PartOf final : public Part {
public:
  explicit PartOf(const Command& command) {
    data_.comm_fortran = communicator();
    data_.par = 1; // rank 0 takes part
    data_.sym = command.symmetric ? 2 : 0;
    call(begin_instance);
    for (const int stream : {1, 2, 3, 4}) control(stream) = 0; // prints nothing
    control(6) = 0;                                            // no column exchanges: the diagonal is full
    control(7) = 1;                                            // our pivot order
    control(12) = 1;                                           // also of symmetric matrices
    control(13) = 1;                                           // no ScaLAPACK, which does not count negative pivots
    control(24) = 1;                                           // reports zero pivots
    if (command.low_rank > 0) {
      control(35) = 2; // factorization and solution by low-rank blocks
      data_.cntl[7 - 1] = static_cast<Real>(command.low_rank);
    }
    if (*command.folder) {
      control(22) = 1;
      data_.keep[99 - 1] = 3; // writes without a thread, which after an error would wait forever
      static_assert(sizeof data_.ooc_tmpdir == sizeof command.folder);
      std::memcpy(data_.ooc_tmpdir, command.folder, sizeof command.folder);
      std::strcpy(data_.ooc_prefix, "signorini");
    }
  }
  ~PartOf() override { call(end_instance); }
  PartOf(const PartOf&) = delete;
  PartOf& operator=(const PartOf&) = delete;

  void call(int job) override {
    data_.job = job;
    Library<Real>::call(data_);
  }
  typename Library<Real>::Data& data() { return data_; }
  int& control(int number) { return data_.icntl[number - 1]; }

private:
  typename Library<Real>::Data data_ = {};
};

std::unique_ptr<Part> make_part(const Command& command) {
  if (command.single) return std::make_unique<PartOf<float>>(command);
  return std::make_unique<PartOf<double>>(command);
}

/// A count that MUMPS gives in millions, negative, if it is large.
double large_count(int count) {
  return count >= 0 ? count : -1e6 * count;
}

template <class Real> class Instance final : public MumpsInstance {
public:
  explicit Instance(const Command& command) : command_(command), part_(send_first(command)) {}
  ~Instance() override { send_job(end_instance); }
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  MumpsReport analyze(const MumpsPattern& pattern) override {
    auto& data = part_.data();
    data.n = pattern.size;
    data.nnz = static_cast<MUMPS_INT8>(pattern.rows.size());
    data.irn = const_cast<int*>(pattern.rows.data()); // MUMPS only reads them
    data.jcn = const_cast<int*>(pattern.columns.data());
    data.perm_in = const_cast<int*>(pattern.order.data());
    return call(1);
  }

  /// Pivoting may need more workspace than the analysis expects: it is doubled then.
  MumpsReport factor(const double* values) override {
    auto& data = part_.data();
    if constexpr (std::is_same_v<Real, double>) {
      data.a = const_cast<double*>(values);
    } else {
      values_.assign(values, values + data.nnz);
      data.a = values_.data();
    }
    constexpr int too_small[] = {-8, -9, -14, -15, -17, -20}, most_workspace = 3000; // %
    for (;;) {
      const MumpsReport report = call(2);
      const bool repeat = std::find(std::begin(too_small), std::end(too_small), report.status) != std::end(too_small);
      if (!repeat || part_.control(14) > most_workspace) return report;
      part_.control(14) *= 2;
    }
  }

  MumpsReport solve(double* b) override {
    auto& data = part_.data();
    if constexpr (std::is_same_v<Real, double>) {
      data.rhs = b;
    } else {
      right_.assign(b, b + data.n);
      data.rhs = right_.data();
    }
    const MumpsReport report = call(3);
    if constexpr (!std::is_same_v<Real, double>) std::copy(right_.begin(), right_.end(), b);
    return report;
  }

private:
  static const Command& send_first(const Command& command) {
    communicator(); // starts MPI
    send(command);
    return command;
  }
  void send_job(int job) {
    command_.job = job;
    send(command_);
  }

  MumpsReport call(int job) {
    send_job(job);
    part_.call(job);
    const auto& data = part_.data();
    const auto count = [&](int number) { return data.infog[number - 1]; };
    const auto value = [&](int number) { return static_cast<double>(data.rinfog[number - 1]); };
    MumpsReport report{.status = count(1), .detail = count(2)};
    if (job != 2) return report;
    const bool compressed = command_.low_rank > 0;
    report.operations = value(compressed ? 14 : 3);
    report.entries = large_count(count(compressed ? 35 : 29));
    report.peak = 1e6 * count(21);
    report.negative = count(12);
    report.null = count(28);
    report.least = value(20);
    report.largest = value(21);
    return report;
  }

  Command command_;
  PartOf<Real> part_;
  std::vector<Real> values_, right_; ///< in single precision
};

std::unique_ptr<MumpsInstance> make(const MumpsSettings& settings, bool symmetric) {
  static int instances = 0;
  Command command{begin_instance, ++instances, symmetric, settings.single, settings.low_rank, {}};
  settings.folder.copy(command.folder, sizeof command.folder - 1);
  if (settings.single) return std::make_unique<Instance<float>>(command);
  return std::make_unique<Instance<double>>(command);
}

void serve() {
  std::map<int, std::unique_ptr<Part>> parts;
  for (;;) {
    const Command command = receive();
    switch (command.job) {
    case end_of_run:
      for (auto& [number, part] : parts) part.release(); // rank 0 does not end its parts either
      return;
    case begin_instance:
      parts[command.instance] = make_part(command);
      break;
    case end_instance:
      parts.erase(command.instance);
      break;
    default:
      parts.at(command.instance)->call(command.job);
    }
  }
}

std::string description() {
  return std::string("MUMPS ") + MUMPS_VERSION + ", " + ranks_description();
}

} // namespace
} // namespace signorini::solve::mumps

extern "C" const signorini::solve::MumpsModule signorini_mumps = {
    signorini::solve::mumps::description, signorini::solve::mumps::make, signorini::solve::mumps::join,
    signorini::solve::mumps::serve};
