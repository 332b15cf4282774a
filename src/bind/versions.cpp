#include "bind/versions.hpp"

#include "base/eigen.hpp"
#include "base/error.hpp"
#include "bind/threads.hpp"

#include <dlfcn.h>
#include <lua.hpp>

namespace signorini::bind {

namespace {

std::string suitesparse_version() {
  int v[3] = {0, 0, 0};
  auto* version = reinterpret_cast<int (*)(int*)>(dlsym(RTLD_DEFAULT, "SuiteSparse_version"));
  if (!version) return "not loaded";
  version(v);
  return text(v[0], ".", v[1], ".", v[2]);
}

} // namespace

std::vector<std::pair<std::string, std::string>> versions() {
  return {{"signorini", SIGNORINI_VERSION},
          {"Lua", LUA_RELEASE},
          {"Eigen", text(EIGEN_WORLD_VERSION, ".", EIGEN_MAJOR_VERSION, ".", EIGEN_MINOR_VERSION)},
          {"SuiteSparse", suitesparse_version()},
          {"BLAS", blas_description()},
          {"kernel", kernel_description()}};
}

} // namespace signorini::bind
