#pragma once
// Notice to end soon (SIGUSR1), which Slurm gives before the time limit of a task: runs end at their next checkpoint.

namespace signorini {

/// Exit status of a process that has ended at a checkpoint, to be continued (EX_TEMPFAIL of sysexits.h).
constexpr int to_be_continued = 75;

/// Catches the signal from now on, also in processes forked later.
void catch_notice();
bool notice_given();

} // namespace signorini
