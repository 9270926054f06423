// SPDX-License-Identifier: BSD-3-Clause
#include "io/bench_record.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>

#include "base/errors.h"
#include "base/text.h"

namespace armature {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kSchema = 1;
constexpr const char* kRemedy = "write a new one with 'armature bench'";

SpanStatistics StatisticsFrom(const Json& json) {
  SpanStatistics s;
  s.n = json.at("n").get<size_t>();
  s.mean = json.at("mean").get<double>();
  s.deviation = json.at("std").get<double>();
  s.median = json.at("median").get<double>();
  s.p10 = json.at("p10").get<double>();
  s.p90 = json.at("p90").get<double>();
  s.p99 = json.at("p99").get<double>();
  s.max = json.at("max").get<double>();
  s.median_low = json.at("median_low").get<double>();
  s.median_high = json.at("median_high").get<double>();
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
  return {json.at("table").get<std::string>(), json.at("sequence").get<std::string>(),
          json.at("contender").get<std::string>(), json.at("stage").get<std::string>(), StatisticsFrom(json)};
}

InputError Unusable(const std::filesystem::path& file, const std::string& why) {
  return InputError(fmt::format("{}: {}; {}", file.string(), why, kRemedy));
}

BenchRecord RecordFrom(const Json& json, const std::filesystem::path& file) {
  if (!json.at("spans").is_array()) throw Unusable(file, "'spans' is no list");
  BenchRecord record;
  record.cpu = json.at("environment").at("cpu").get<std::string>();
  record.calibration = StatisticsFrom(json.at("calibration_ms"));
  for (const Json& span : json.at("spans")) record.spans.push_back(SpanFrom(span));
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
  return {json.at("table").get<std::string>(), json.at("sequence").get<std::string>(),
          json.at("contender").get<std::string>(), json.at("reference").get<std::string>(),
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
  const std::string text = ReadTextFile(file);
  BenchRecord record;
  try {
    const Json json = Json::parse(text);
    CheckSchema(json, file);
    record = RecordFrom(json, file);
  } catch (const Json::parse_error& error) {
    throw Unusable(file, fmt::format("is not JSON from byte {} on", error.byte));
  } catch (const Json::exception& error) {
    const std::string what = error.what();  // "[json.exception...] and what is wrong"
    throw Unusable(file, what.substr(what.find("] ") + 2));
  }
  CheckRecord(record, file);
  return record;
}

}  // namespace armature
