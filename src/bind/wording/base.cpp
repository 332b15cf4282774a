#include "bind/wording/wording.hpp"

namespace signorini::bind {

namespace {

constexpr Wording base_rows[] = {
    {"base.archive.bytes", "{count} bytes were expected where {left} are left"},
    {"base.archive.list", "a list of {count} entries was expected where {left} bytes are left"},
    {"base.archive.section", "the section '{expected}' was expected, got '{found}'"},
    {"base.archive.kind", "'{file}' is not a {kind} of signorini. Hint: name a file that it has saved"},
    {"base.archive.version", "'{file}' was written in format {written}, this program reads format {known}. Hint: use "
                             "the program that wrote it"},
    {"base.archive.damaged", "'{file}' is damaged: {damage}. Hint: take an older copy, or start again without it"},
    {"base.archive.cut_off", "it is cut off after {length} bytes"},
    {"base.archive.trailing", "{count:byte} too many at its end"},
    {"base.archive.checksum", "its checksum is wrong"},
    {"base.archive.matrix",
     "a matrix of {rows} x {columns} was found where one of {expected_rows} x {expected_columns} was expected"},
    {"base.archive.matrix_cut_off", "a matrix of {rows} x {columns} is cut off"},
    {"base.jobs.pipe", "cannot open a pipe to another process: {reason}. Hint: run fewer jobs at once"},
    {"base.jobs.fork", "cannot start another process: {reason}. Hint: run fewer jobs at once"},
    {"base.jobs.at_once", "at least one process must run at once, got {at_once}"},
    {"base.jobs.seconds", "the limit must be a positive number of seconds, got {seconds}"},
    {"base.jobs.time", "time"},
    {"base.jobs.signal", "died of signal {signal}"},
    {"base.jobs.status", "left with status {status} before it returned anything"},
    {"base.jobs.threw", "failed: {error}"},
    {"base.lock.write", "cannot write '{file}': {reason}. Hint: choose a folder that you may write to"},
    {"base.lock.lock", "cannot lock '{file}': {reason}. Hint: choose a folder of another file system"},
    {"base.lock.held", "'{file}' is held by {holder}. Hint: wait until it has ended, or choose another folder"},
    {"base.threads.start", "the system started only {started} of {wanted} threads ({reason}). Hint: ask for fewer"},
    {"base.process.start", "cannot run {program}: {reason}"},
    {"base.process.failed", "{program} failed with the message: {output}"},
    {"base.file.write",
     "cannot write '{file}': {reason}. Hint: choose a file in a folder that you may write to, with space left"},
    {"base.file.in_a_file", "cannot write '{file}': '{above}' is a file, not a folder. Hint: choose another name"},
    {"base.file.tilde", "cannot write '{file}': only the shell expands '~'. Hint: write the folder's full name, "
                        "os.getenv \"HOME\" .. \"/…\""},
    {"base.file.no_folder",
     "cannot write '{file}': the folder '{folder}' does not exist. Hint: create it first, sg.mkdir \"{folder}\""},
    {"base.file.no_name", "file '{file}' names a folder. Hint: add the name of a file"},
    {"base.file.write_folder", "cannot write '{file}': it is a folder. Hint: add the name of a file"},
    {"base.file.read_folder", "cannot read '{file}': it is a folder. Hint: name a file"},
    {"base.file.read", "cannot read '{file}': {reason}. Hint: check the name and the folder"},
    {"base.file.read_broken", "cannot read '{file}': {reason}"},
};

} // namespace

std::span<const Wording> base_wordings() {
  return base_rows;
}

} // namespace signorini::bind
