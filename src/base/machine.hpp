#pragma once
// Name and memory of the machine: the context of reported times.

#include <string>

namespace signorini {

std::string host_name();

/// For example "AMD EPYC 7763 64-Core Processor"; empty if unknown.
std::string processor_name();

/// Bytes of main memory; infinity if unknown.
double main_memory();

} // namespace signorini
