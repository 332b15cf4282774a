#pragma once
// Names of Eigen's types used throughout: small fixed sizes by dimension, and the two dynamic ones.

#include <Eigen/Dense>

namespace signorini {

template <int D> using Vec = Eigen::Matrix<double, D, 1>;
template <int D> using Mat = Eigen::Matrix<double, D, D>;
using VectorX = Eigen::VectorXd;
using MatrixX = Eigen::MatrixXd;

} // namespace signorini
