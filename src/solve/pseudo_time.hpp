#pragma once
// Step control of pseudo-transient continuation: adapts the damping on the way to an equilibrium.

namespace signorini::solve {

/// The bodies move as in a viscous medium, α D u̇ = −r(u), past a loss of stability to an equilibrium behind it. A move
/// Δu of (K + α D) Δu = −r is one implicit Euler step of this motion (C. T. Kelley, D. E. Keyes, SIAM J. Numer. Anal.
/// 35, 1998), accurate as long as the error e = |r(u + Δu) + α D Δu| / |r(u)| is small. α = 0 is Newton's method.
class PseudoTime {
public:
  /// α of the next move.
  double damping() const { return damping_; }
  /// Adapts α to a trial move's error e, infinite if the state is invalid. Returns whether the move is accepted;
  /// otherwise it has to be repeated with the new α.
  bool accept(double error);

private:
  double damping_ = 0; ///< starts with Newton's method
};

} // namespace signorini::solve
