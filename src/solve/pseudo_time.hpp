#pragma once
// Step control of pseudo-transient continuation: how strongly motion is damped on the way to an equilibrium.

namespace signorini::solve {

/// Bodies move as in a viscous medium, α D u̇ = −r(u), which carries them past a loss of stability to a state of rest
/// behind it. A move Δu of (K + α D) Δu = −r is one implicit Euler step of that motion (C. T. Kelley, D. E. Keyes, SIAM
/// J. Numer. Anal. 35, 1998), and follows it as long as the error e = |r(u + Δu) + α D Δu| / |r(u)| is small. With α =
/// 0 it is Newton's.
class PseudoTime {
public:
  /// α of the next move.
  double damping() const { return damping_; }
  /// Takes note of a trial move's error e, infinite where the state has no residual. Returns whether the move counts;
  /// otherwise it has to be tried again with the new α.
  bool accept(double error);

private:
  double damping_ = 0; ///< begins with Newton's method
};

} // namespace signorini::solve
