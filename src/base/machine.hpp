#pragma once
// What the machine is called: figures of time mean little without it.

#include <string>

namespace signorini {

std::string host_name();

/// Such as "AMD EPYC 7763 64-Core Processor"; empty where the system does not tell.
std::string processor_name();

} // namespace signorini
