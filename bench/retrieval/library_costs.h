// SPDX-License-Identifier: BSD-3-Clause
// What a library of instances costs as a whole: its file, and a query that weighs by covariance.
#pragma once

#include "bench/retrieval/synthetic_library.h"

namespace armature {

struct LibraryCosts {
  double file_mb = 0;                // 2^20 bytes
  double write_ms = 0, read_ms = 0;  // once each, with the checksum of everything
  double weighed_ms = 0;             // median: the five likeliest by covariance, an exact scan
};

// A category of chairs (11 edges, 7 modes) with these coefficients; its file is in the system's folder for
// temporary files and removed again.
LibraryCosts MeasureLibrary(const SyntheticLibrary& library);

}  // namespace armature
