// SPDX-License-Identifier: GPL-3.0-or-later
#include "peak_memory.h"

#include <malloc.h>

#include <fstream>
#include <stdexcept>
#include <string>

namespace wirewarp {

void reset_peak_memory() {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";  // proc(5): resets the peak resident set size
}

double peak_memory_mb() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind("VmHWM:", 0) == 0) return std::stod(line.substr(6)) / 1024;  // the file has kilobytes
  }
  throw std::runtime_error("/proc/self/status has no VmHWM");
}

}  // namespace wirewarp
