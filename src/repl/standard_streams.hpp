#pragma once
// Standard input, output and error of the process.

namespace signorini::repl {

/// Opens those that are closed as empty (/dev/null): the next file that is opened would take their place, and would
/// receive what is printed. Call it before anything is opened.
void open_standard_streams();

/// Files that would exceed the limit of the process (ulimit -f) are errors of the writer, as on a full disk, not the
/// end of the program. At the end of the program, an output that could not be written, because the disk is full, is
/// reported on stderr and makes the exit status 1.
void report_lost_output();

} // namespace signorini::repl
