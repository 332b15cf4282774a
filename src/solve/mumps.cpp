#include "solve/mumps.hpp"

#include "base/error.hpp"
#include "os/module.hpp"
#include "os/sandbox.hpp"
#include "solve/cholmod.hpp"

#include <algorithm>
#include <cstdlib>
#include <unistd.h>

namespace signorini::solve {

namespace {

constexpr const char* module_file = "signorini_mumps.so";

const MumpsModule& load() {
  static const MumpsModule& loaded = []() -> const MumpsModule& {
    require(sandbox_folder().empty(), "solve.mumps.sandbox");
    const std::filesystem::path file = find_module(module_file);
    const auto [first, second] = module_folders();
    require(!file.empty(), "solve.mumps.missing",
            {{"module", module_file}, {"first", first.string()}, {"second", second.string()}});
    return *static_cast<const MumpsModule*>(load_module(file, "signorini_mumps"));
  }();
  return loaded;
}

/// The place of each unknown in a nested dissection order, counted from 1.
std::vector<int> places_in_order(const Pattern& pattern) {
  CholmodCommon common;
  cholmod_sparse matrix = upper_triangle(pattern, nullptr);
  matrix.xtype = CHOLMOD_PATTERN;
  std::vector<int> order(pattern.size), places(pattern.size);
  require(cholmod_metis(&matrix, nullptr, 0, true, order.data(), &common), "solve.cholmod.order",
          {{"status", common.status}});
  for (int k = 0; k < pattern.size; ++k) places[order[k]] = k + 1;
  return places;
}

/// The number in an environment variable, 0 without one.
int number(const char* name) {
  const char* text = std::getenv(name);
  return text ? std::atoi(text) : 0;
}

void check_folder(const std::string& folder) {
  if (folder.empty()) return;
  const std::size_t most = 255;
  require(folder.size() <= most, "solve.mumps.folder_length", {{"folder", folder}, {"most", most}});
  require(std::filesystem::is_directory(folder) && ::access(folder.c_str(), W_OK) == 0, "solve.mumps.folder",
          {{"folder", folder}});
}

class Mumps final : public DirectSolver {
public:
  explicit Mumps(MumpsSettings settings) : settings_(std::move(settings)) {
    load();
    check_folder(settings_.folder);
  }

  void analyze(const Pattern& pattern) override {
    instance_.reset();
    pattern_ = pattern;
    entries_.size = pattern.size;
    entries_.order = places_in_order(pattern);
    symmetric_ = true;
  }

  /// After an unsymmetric matrix all are factored by LU until the pattern changes, so that contacts that alternate
  /// between sticking and slipping do not cause analyses.
  bool factor(const double* values) override {
    if (symmetric_ && !is_symmetric(pattern_, values)) {
      symmetric_ = false;
      instance_.reset();
    }
    if (!instance_ && !begin()) return false;
    ++statistics_.factorizations;
    report_ = instance_->factor(symmetric_ ? lower_values(values) : values);
    const double triangles = symmetric_ ? 2 : 1; // that a solution reads
    statistics_.operations = report_.operations;
    statistics_.entries = triangles * report_.entries;
    statistics_.memory = report_.entries * (settings_.single ? sizeof(float) : sizeof(double));
    statistics_.rank_memory = report_.peak;
    statistics_.negative = symmetric_ ? report_.negative : -1;
    statistics_.definite = statistics_.negative == 0;
    return succeeded(report_) && report_.null == 0 && pivots().regular();
  }

  bool solve(double* b) override {
    ++statistics_.solutions;
    return succeeded(instance_->solve(b));
  }

  PivotRange pivots() const override { return {report_.least, report_.largest}; }
  SolverStatistics statistics() const override { return statistics_; }

private:
  /// Lists the entries, of symmetric matrices those of the lower triangle, and analyzes them.
  bool begin() {
    entries_.rows.clear();
    entries_.columns.clear();
    kept_.clear();
    for (int j = 0; j < pattern_.size; ++j)
      for (int k = pattern_.starts[j]; k < pattern_.starts[j + 1]; ++k) {
        const int i = pattern_.rows[k];
        if (symmetric_ && i < j) continue;
        entries_.rows.push_back(i + 1);
        entries_.columns.push_back(j + 1);
        if (symmetric_) kept_.push_back(k);
      }
    instance_ = load().make(settings_, symmetric_);
    return succeeded(instance_->analyze(entries_));
  }

  const double* lower_values(const double* values) {
    lower_.resize(kept_.size());
    for (std::size_t k = 0; k < kept_.size(); ++k) lower_[k] = values[kept_[k]];
    return lower_.data();
  }

  /// Returns false if the matrix is singular; throws Error after other failures.
  bool succeeded(const MumpsReport& report) const {
    constexpr int singular[] = {-6, -10}, memory[] = {-5, -7, -8, -9, -13, -14, -15, -17, -19, -20}, files = -90;
    const auto is_in = [&](const auto& list) {
      return std::find(std::begin(list), std::end(list), report.status) != std::end(list);
    };
    if (report.status >= 0) return true;
    if (is_in(singular)) return false;
    require(report.status != files, "solve.mumps.files", {{"folder", settings_.folder}});
    require(!is_in(memory), "solve.mumps.memory", {{"size", pattern_.size}, {"status", report.status}});
    fail("solve.mumps.failed", {{"status", report.status}, {"detail", report.detail}});
  }

  MumpsSettings settings_;
  Pattern pattern_;
  MumpsPattern entries_;
  bool symmetric_ = true; ///< as long as all matrices are
  std::vector<int> kept_; ///< positions of the lower triangle in the pattern
  std::vector<double> lower_;
  std::unique_ptr<MumpsInstance> instance_;
  MumpsReport report_;
  SolverStatistics statistics_;
};

} // namespace

std::unique_ptr<DirectSolver> make_mumps(const MumpsSettings& settings) {
  return std::make_unique<Mumps>(settings);
}

bool has_mumps() {
  return !find_module(module_file).empty();
}

std::string mumps_description() {
  return load().description();
}

int started_ranks() {
  return number("OMPI_COMM_WORLD_SIZE");
}

bool leads_ranks(const std::string& version) {
  // srun and MPICH's mpirun; that of Open MPI uses srun to start itself.
  const int others = std::max(number("SLURM_STEP_NUM_TASKS"), number("PMI_SIZE"));
  if (started_ranks() == 0 && others > 1) fail("solve.mumps.launcher", {{"count", others}});
  if (started_ranks() <= 1) return true;
  const bool first = number("OMPI_COMM_WORLD_RANK") == 0;
  if (!first && !has_mumps()) return false; // rank 0 reports it
  const int rank = load().join(version);
  require(rank >= 0 || !first, "solve.mumps.versions");
  if (rank > 0) load().serve();
  return rank == 0;
}

} // namespace signorini::solve
