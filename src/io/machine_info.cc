// SPDX-License-Identifier: BSD-3-Clause
#include <sys/resource.h>

#include <fstream>
#include <thread>

#include "base/text.h"
#include "io/build_info.h"

namespace armature {
namespace {

std::string CpuName() {
  std::ifstream stream("/proc/cpuinfo");
  for (std::string line; std::getline(stream, line);) {
    const size_t colon = line.find(':');
    if (line.starts_with("model name") && colon != std::string::npos) return Trimmed(line.substr(colon + 1));
  }
  return "unknown";
}

}  // namespace

MachineInfo GetMachineInfo() { return {CpuName(), static_cast<int>(std::thread::hardware_concurrency())}; }

double PeakMemoryMegabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;  // Linux counts kilobytes
}

}  // namespace armature
