// SPDX-License-Identifier: BSD-3-Clause
// bench.json and raw.csv: all that a call of `armature bench` has measured, for programs.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "bench/bench_report.h"
#include "bench/environment.h"

namespace armature {

// {"program", "environment", "settings", "schema", "calibration_ms", "spans" and "ratios": see
// io/bench_record.h, "sections": what was counted and discarded, "series", "tables", "complete": true}; ends
// with a line break. `settings`: an object with every argument and option of the call.
std::string BenchJson(const BenchEnvironment& environment, const nlohmann::ordered_json& settings,
                      const BenchReport& report);

// A row a timed run: table,sequence,contender,repetition,frame,objects,segments,a column a stage,added,total.
// Milliseconds; a stage that the engine does not have is empty. `added` is part of a stage and of the total.
std::string RawCsv(const BenchReport& report);

}  // namespace armature
