#pragma once
// Name and memory of the machine, the context of reported times, and where the program is.

#include <filesystem>
#include <string>

namespace signorini {

std::string host_name();

/// The file of this program. Throws Error without /proc.
std::filesystem::path program_file();

/// For example "AMD EPYC 7763 64-Core Processor"; empty if unknown.
std::string processor_name();

/// Bytes of main memory; infinity if unknown.
double main_memory();

} // namespace signorini
