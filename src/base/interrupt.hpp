#pragma once
// Ctrl-C as a flag: the signal handler raises it, long loops look at it between two states that are both usable.

namespace signorini {

/// Installs the SIGINT handler that raises the flag. A second Ctrl-C before the first was seen ends the program, unless
/// survive_interrupts() was called.
void catch_interrupts();
void survive_interrupts();
/// Where Ctrl-C is acknowledged at once when it comes during an iteration: a file descriptor, none at first.
void acknowledge_interrupts(int descriptor);
/// An iteration of a solve, at whose end the flag is looked at.
class Iteration {
public:
  Iteration();
  ~Iteration();
  Iteration(const Iteration&) = delete;
  Iteration& operator=(const Iteration&) = delete;
};
bool interrupted();
/// Whatever ends because of Ctrl-C and returns what it has says so.
void answer_interrupt();
/// Whether something has ended because of the Ctrl-C that was seen last.
bool interrupt_answered();
void clear_interrupt();

} // namespace signorini
