#pragma once
// Ctrl-C as a flag: the signal handler sets it, long loops test it where their state is consistent.

namespace signorini {

/// Installs the SIGINT handler that sets the flag. A second Ctrl-C before the first one is seen ends the program,
/// unless survive_interrupts() was called.
void catch_interrupts();
void survive_interrupts();
/// File descriptor to which Ctrl-C is acknowledged immediately during an iteration; none by default.
void acknowledge_interrupts(int descriptor);
/// Scope of one iteration of a solve, at whose end the flag is tested.
class Iteration {
public:
  Iteration();
  ~Iteration();
  Iteration(const Iteration&) = delete;
  Iteration& operator=(const Iteration&) = delete;
};
/// Scope of the factorization of so many unknowns, which nothing interrupts: the acknowledgement names it and its time.
class Factorization {
public:
  explicit Factorization(int unknowns);
  ~Factorization();
  Factorization(const Factorization&) = delete;
  Factorization& operator=(const Factorization&) = delete;
};
/// Sets the flag, also in signal handlers.
void interrupt();
bool interrupted();
/// Called by operations that end early because of Ctrl-C and return a partial result.
void report_interrupt();
/// True if an operation has ended early because of the last Ctrl-C.
bool interrupt_reported();
void clear_interrupt();

} // namespace signorini
