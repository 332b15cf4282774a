#include "bind/program/doctor.hpp"
#include "bind/lua/wording/wording.hpp"

#include "base/eigen.hpp"
#include "base/error.hpp"
#include "bind/lua/threads.hpp"
#include "bind/program/library.hpp"
#include "exchange/hdf5.hpp"
#include "os/sandbox.hpp"
#include "os/whole_file.hpp"
#include "solid/kernel.hpp"
#include "solve/mumps.hpp"
#include "terminal/screen.hpp"
#include "view/figure.hpp"
#include "view/picture.hpp"
#include "view/series.hpp"

#include <dlfcn.h>
#include <filesystem>
#include <iomanip>
#include <lua.hpp>
#include <ostream>
#include <unistd.h>

namespace signorini::bind {

namespace fs = std::filesystem;

namespace {

std::string suitesparse_version() {
  int v[3] = {0, 0, 0};
  auto* version = loaded<int(int*)>("SuiteSparse_version");
  if (!version) return "not loaded";
  version(v);
  return text(v[0], ".", v[1], ".", v[2]);
}

/// "OpenBLAS 0.3.21 …, libopenblas.so": version and file of the loaded BLAS.
std::string blas_description() {
  void* dgemm = dlsym(RTLD_DEFAULT, "dgemm_");
  Dl_info info;
  if (!dgemm || !dladdr(dgemm, &info)) return "none loaded";
  const std::string file = std::filesystem::weakly_canonical(info.dli_fname).string();
  auto* config = loaded<char*()>("openblas_get_config");
  return (config ? std::string(config()) + ", " : "") + file;
}

/// Draws a colored square to test the modules.
std::string test_picture() {
  view::Body square;
  square.skin.points.resize(3, 4);
  square.skin.points << 0, 1, 1, 0, 0, 0, 1, 1, 0, 0, 0, 0;
  square.skin.triangles.resize(3, 2);
  square.skin.triangles << 0, 0, 1, 2, 2, 3;
  square.skin.values = VectorX::LinSpaced(4, 0, 1);
  view::PictureOptions options;
  options.title = "signorini";
  options.size = {400, 300};
  const fs::path file = fs::temp_directory_path() / text("signorini-doctor-", getpid(), ".png");
  write_record(file.string(),
               view::bytes_of(view::figure_of(view::make_plate(std::vector<view::Panel>{{"", {square}}}, options)),
                              view::format_of(file.string())));
  const auto bytes = fs::file_size(file);
  fs::remove(file);
  return text("ok (", bytes, " bytes)");
}

} // namespace

std::vector<std::pair<std::string, std::string>> versions() {
  return {{"signorini", SIGNORINI_VERSION},
          {"Lua", LUA_RELEASE},
          {"Eigen", text(EIGEN_WORLD_VERSION, ".", EIGEN_MAJOR_VERSION, ".", EIGEN_MINOR_VERSION)},
          {"SuiteSparse", suitesparse_version()},
          {"BLAS", blas_description()},
          {"kernel", solid::instruction_names[static_cast<int>(solid::widest_instructions())]}};
}

bool doctor(std::ostream& out, int threads, const std::vector<OtherLibrary>& others) {
  const auto row = [&](const char* name, const std::string& value) {
    out << std::left << std::setw(14) << name << value << std::endl;
  };
  bool well = true;
  const auto attempt = [&](const char* name, auto&& check) {
    try {
      row(name, check());
    } catch (const std::exception& error) {
      well = false;
      row(name, text("FAILED: ", worded(error)));
    }
  };
  for (const auto& [name, version] : versions()) row(name.c_str(), version);
  attempt("library", [] { return find_home().string(); });
  row("threads", std::to_string(threads));
  for (const auto& [name, description] : others) attempt(name, description);
  attempt("MUMPS", [] {
    return solve::has_mumps() ? solve::mumps_description() : "not installed, linear = \"mumps\" is not available";
  });
  attempt("HDF5", [] {
    return exchange::has_hdf5() ? exchange::hdf5().description() : "not installed, run:hdf5 is not available";
  });
  attempt("renderer", [] { return view::renderer().description(); });
  attempt("drawing", [] { return view::flat_renderer().description(); });
  attempt("terminal", [] {
    return terminal::has_art() ? terminal::art_description()
                               : "no Chafa or libsixel: pictures in kitty and iTerm2 only";
  });
  attempt("sandbox", [] {
    const auto missing = sandbox_missing();
    return missing ? worded(*missing) : sandbox_description();
  });
  attempt("test picture", test_picture);
  attempt("films", [] { return view::film_description(); });
  row("all in all", well ? "ok" : "something is missing, see above");
  return well;
}

} // namespace signorini::bind
