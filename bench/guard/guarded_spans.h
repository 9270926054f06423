// SPDX-License-Identifier: BSD-3-Clause
// Which spans of a report can be guarded, and which of a reference have something to be compared with.
#pragma once

#include <set>
#include <string>
#include <utility>

#include "bench/bench_report.h"
#include "bench/environment.h"
#include "io/bench_record.h"

namespace armature {

// A table's name and a sequence's, which is empty for fixed inputs.
using TableOfSequence = std::pair<std::string, std::string>;

// The spans of all sections, each followed by its calibration's ("calibration", "pass"), with one calibration
// of the whole process. A stage that mostly had nothing to do
// (a median of 0) is left out. Without any race there is no calibration, and no span.
BenchRecord MakeRecord(const BenchEnvironment& environment, const BenchReport& report);

// Whether this machine's work took the time: not for the network of keypoints:published, whose time is added,
// and of keypoints:wait, which sleeps, nor for their totals.
bool IsMachinesWork(const NamedSpan& span);

// What of a record is guarded: this machine's work in the tables that are measured.
BenchRecord GuardedPart(BenchRecord record, const std::set<TableOfSequence>& measured);

// Throws InputError when nothing of the reference would be measured.
void CheckSharesTables(const BenchRecord& reference, const std::set<TableOfSequence>& measured);

}  // namespace armature
