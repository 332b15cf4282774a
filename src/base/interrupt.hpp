#pragma once
// Ctrl-C as a flag: the signal handler raises it, long loops look at it between two states that are both usable.

namespace signorini {

/// Installs the SIGINT handler that raises the flag. A second Ctrl-C before the first was seen ends the program.
void catch_interrupts();
void request_interrupt();
bool interrupted();
void clear_interrupt();

} // namespace signorini
