// SPDX-License-Identifier: BSD-3-Clause
#include "io/bench_record.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>

#include "base/errors.h"
#include "base/text.h"
#include "io/json_fields.h"
#include "io/json_file.h"

namespace armature {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kSchema = 1;
constexpr const char* kBenchRemedy = "write a new one with 'armature bench'";

SpanStatistics StatisticsFrom(const Json& json) {
  SpanStatistics s;
  s.n = JsonField<size_t>(json, "n");
  s.mean = JsonField<double>(json, "mean");
  s.deviation = JsonField<double>(json, "std");
  s.median = JsonField<double>(json, "median");
  s.p10 = JsonField<double>(json, "p10");
  s.p90 = JsonField<double>(json, "p90");
  s.p99 = JsonField<double>(json, "p99");
  s.max = JsonField<double>(json, "max");
  s.median_low = JsonField<double>(json, "median_low");
  s.median_high = JsonField<double>(json, "median_high");
  return s;
}

Json NamedSpanJson(const NamedSpan& span) {
  Json json = {{"table", span.table},
               {"sequence", span.sequence},
               {"contender", span.contender},
               {"stage", span.stage}};
  json.update(StatisticsJson(span.milliseconds));
  return json;
}

NamedSpan SpanFrom(const Json& json) {
  return {JsonField<std::string>(json, "table"), JsonField<std::string>(json, "sequence"),
          JsonField<std::string>(json, "contender"), JsonField<std::string>(json, "stage"),
          StatisticsFrom(json)};
}

InputError Unusable(const std::filesystem::path& file, const std::string& why) {
  return InputError(fmt::format("{}: {}; {}", file.string(), why, kBenchRemedy));
}

BenchRecord RecordFrom(const Json& json) {
  BenchRecord record;
  record.cpu = JsonField<std::string>(JsonObject(json, "environment"), "cpu");
  record.calibration = StatisticsFrom(JsonObject(json, "calibration_ms"));
  for (const Json& span : JsonList(json, "spans")) record.spans.push_back(SpanFrom(span));
  return record;
}

void CheckRecord(const BenchRecord& record, const std::filesystem::path& file) {
  if (!(record.calibration.median > 0)) throw Unusable(file, "the calibration's median is not positive");
  if (record.spans.empty()) throw Unusable(file, "there are no spans to compare with");
  std::set<std::string> keys;
  for (const NamedSpan& span : record.spans) {
    if (!(span.milliseconds.median > 0))
      throw Unusable(file, fmt::format("the median of {} is not positive", Quoted(span.Key())));
    if (!keys.insert(span.Key()).second)
      throw Unusable(file, fmt::format("the span {} is there twice", Quoted(span.Key())));
  }
}

// Another version's files may look alike and mean something else.
void CheckSchema(const Json& json, const std::filesystem::path& file) {
  if (!json.is_object() || !json.contains("schema"))
    throw Unusable(file, "is not a bench.json, it has no 'schema'");
  if (json["schema"] != kSchema)
    throw Unusable(file, fmt::format("has schema {}, not {}", Quoted(json["schema"].dump()), kSchema));
}

}  // namespace

Json StatisticsJson(const SpanStatistics& s) {
  return {{"n", s.n},
          {"mean", s.mean},
          {"std", s.deviation},
          {"median", s.median},
          {"p10", s.p10},
          {"p90", s.p90},
          {"p99", s.p99},
          {"max", s.max},
          {"median_low", s.median_low},
          {"median_high", s.median_high}};
}

Json NamedRatioJson(const NamedRatio& ratio) {
  Json json = {{"table", ratio.table},
               {"sequence", ratio.sequence},
               {"contender", ratio.contender},
               {"reference", ratio.reference}};
  json.update(StatisticsJson(ratio.ratio));
  return json;
}

NamedRatio NamedRatioFromJson(const Json& json) {
  return {JsonField<std::string>(json, "table"), JsonField<std::string>(json, "sequence"),
          JsonField<std::string>(json, "contender"), JsonField<std::string>(json, "reference"),
          StatisticsFrom(json)};
}

void AddBenchRecord(const BenchRecord& record, Json& json) {
  json["schema"] = kSchema;
  json["environment"]["cpu"] = record.cpu;
  json["calibration_ms"] = StatisticsJson(record.calibration);
  json["spans"] = Json::array();
  for (const NamedSpan& span : record.spans) json["spans"].push_back(NamedSpanJson(span));
}

BenchRecord ReadBenchRecord(const std::filesystem::path& file) {
  const Json json = ReadJson(file, kBenchRemedy);
  CheckSchema(json, file);
  BenchRecord record;
  try {
    record = RecordFrom(json);
  } catch (const InputError& error) {
    throw Unusable(file, error.what());
  }
  CheckRecord(record, file);
  return record;
}

}  // namespace armature
