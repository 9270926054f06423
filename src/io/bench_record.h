// SPDX-License-Identifier: BSD-3-Clause
// The part of bench.json that a later run is compared with:
//   {"schema": 1, "environment": {"cpu": NAME},
//    "calibration_ms": {"n", "mean", "std", "median", "p10", "p90", "p99", "max", "median_low",
//    "median_high"}, "spans": [{"table", "sequence", "contender", "stage", and as calibration_ms}]}
// All times are milliseconds, with every digit. What else the object holds is not looked at; beside the spans
// it has "ratios": [{"table", "sequence", "contender", "reference", and as calibration_ms}].
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "io/named_span.h"

namespace armature {

struct BenchRecord {
  std::string cpu;             // see MachineInfo
  SpanStatistics calibration;  // of bench/guard/calibration.h, in the same process
  std::vector<NamedSpan> spans;
};

nlohmann::ordered_json StatisticsJson(const SpanStatistics& s);
nlohmann::ordered_json NamedRatioJson(const NamedRatio& ratio);
// Throws nlohmann::json::exception, which names the member that is missing.
NamedRatio NamedRatioFromJson(const nlohmann::ordered_json& json);

// Adds the members above to an object, and to its environment where it has one already.
void AddBenchRecord(const BenchRecord& record, nlohmann::ordered_json& json);

// Throws InputError when the file cannot be read, is not JSON, has another schema, lacks a member or has one
// of another kind, has a span twice or none, or a median that is not positive.
BenchRecord ReadBenchRecord(const std::filesystem::path& file);

}  // namespace armature
