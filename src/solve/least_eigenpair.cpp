#include "solve/least_eigenpair.hpp"

#include "solve/lapack.hpp"

namespace signorini::solve {

Eigenpair least_eigenpair(MatrixX symmetric) {
  const int size = static_cast<int>(symmetric.rows()), workspace = 3 * size;
  VectorX values(size), work(workspace);
  int info = 0;
  dsyev_("V", "L", &size, symmetric.data(), &size, values.data(), work.data(), &workspace, &info);
  if (info != 0) return {0, VectorX::Zero(size)};
  return {values(0), symmetric.col(0)};
}

} // namespace signorini::solve
