// SPDX-License-Identifier: BSD-3-Clause
// bench.json and raw.csv: all that a call of `armature bench` has measured, for programs.
#pragma once

#include <map>
#include <string>

#include "bench/bench_report.h"
#include "bench/environment.h"

namespace armature {

// Every option of the call as text, by name.
using SettingTexts = std::vector<std::pair<std::string, std::string>>;

// {"program", "environment", "settings", "sections": what was counted and discarded, "spans": rows of
// NamedSpan, "series", "tables", "complete": true}; ends with a line break.
std::string BenchJson(const BenchEnvironment& environment, const SettingTexts& settings,
                      const BenchReport& report);

// A row a timed run: table,sequence,contender,repetition,frame,objects,segments,a column a stage,added,total.
// Milliseconds; a stage that the engine does not have is empty. `added` is part of a stage and of the total.
std::string RawCsv(const BenchReport& report);

}  // namespace armature
