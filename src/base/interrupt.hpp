#pragma once
// Ctrl-C as a flag: the signal handler raises it, long loops look at it between two states that are both usable.

namespace signorini {

/// Installs the SIGINT handler that raises the flag. A second Ctrl-C before the first was seen ends the program.
void catch_interrupts();
void request_interrupt();
bool interrupted();
/// Whatever ends because of Ctrl-C and returns what it has says so.
void answer_interrupt();
/// Whether something has ended because of the Ctrl-C that was seen last.
bool interrupt_answered();
void clear_interrupt();

} // namespace signorini
