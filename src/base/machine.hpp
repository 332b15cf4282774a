#pragma once
// What the machine is called, for figures of time mean little without it, and what fits into it.

#include <string>

namespace signorini {

std::string host_name();

/// Such as "AMD EPYC 7763 64-Core Processor"; empty where the system does not tell.
std::string processor_name();

/// Bytes of main memory; infinity where the system does not tell.
double main_memory();

} // namespace signorini
