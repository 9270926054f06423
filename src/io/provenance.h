// SPDX-License-Identifier: BSD-3-Clause
// Whether two results are of the same data and machine, as far as their folders tell.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/run_results.h"

namespace armature {

// A line about what the results do not have in common.
struct ProvenanceRemark {
  std::string text;
  bool is_warning = false;  // values of the two are not to be paired, or not wholly
};

// Of two run folders: data (number of images and detections, image size, the files of the sequence folders
// where they are two), category models of the map's shapes, machine, threads, libraries, then without a
// warning program version, preset and options. Throws InputError: a malformed file.
std::vector<ProvenanceRemark> CompareRunProvenance(const RunIdentity& a, const RunIdentity& b);

// Of two bench.json: machine, compiler, threads and what was measured; then the program version and options.
// Throws InputError: a malformed file.
std::vector<ProvenanceRemark> CompareBenchProvenance(const std::filesystem::path& a,
                                                     const std::filesystem::path& b);

}  // namespace armature
