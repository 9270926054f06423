// SPDX-License-Identifier: BSD-3-Clause
#include "bench/bench_json.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/csv_fields.h"
#include "base/number_format.h"
#include "bench/guard/guarded_spans.h"

namespace armature {
namespace {

using Json = nlohmann::ordered_json;

Json EnvironmentJson(const BenchEnvironment& environment) {
  const auto& [machine, build, threads, load] = environment;
  return {{"cpu", machine.cpu},
          {"cores", machine.cores},
          {"threads", threads},
          {"load_average", load},
          {"version", build.version},
          {"git", {{"commit", build.git_commit}, {"dirty", build.git_dirty}}},
          {"compiler", build.compiler},
          {"flags", build.flags},
          {"versions", {{"opencv", build.opencv}, {"eigen", build.eigen}, {"ceres", build.ceres}}}};
}

Json SeriesJson(const BenchSection& section, const BenchSeries& series) {
  Json json{{"table", section.name},     {"sequence", section.sequence}, {"contender", series.contender},
            {"x_label", series.x_label}, {"y_label", series.y_label},    {"fit", nullptr},
            {"points", Json::array()}};
  if (series.fit) json["fit"] = {{"constant", series.fit->constant}, {"slope", series.fit->slope}};
  for (const BenchSeries::Point& point : series.points) {
    Json& entry = json["points"].emplace_back(Json{{"x", point.x}});
    entry.update(StatisticsJson(point.milliseconds));
  }
  return json;
}

void AddSection(const BenchSection& section, Json& json) {
  json["sections"].push_back({{"table", section.name},
                              {"sequence", section.sequence},
                              {"frames_counted", section.frames},
                              {"frames_discarded", section.warmed_up},
                              {"runs_counted", section.rows.size()}});
  for (const NamedRatio& ratio : section.ratios) json["ratios"].push_back(NamedRatioJson(ratio));
  for (const BenchSeries& series : section.series) json["series"].push_back(SeriesJson(section, series));
  for (Table table : section.tables) {
    table.name = section.name;
    table.sequence = section.sequence;
    json["tables"].push_back(Json::parse(FormatTable(table, TableFormat::kJson)));
  }
}

std::string Field(const std::optional<double>& milliseconds) {
  return milliseconds ? Fixed(*milliseconds, 6) : "";
}

std::string RawRow(const BenchSection& section, const BenchRow& row) {
  std::string stages;
  for (const auto& stage : row.outcome.stages_ms) stages += Field(stage) + ",";
  return fmt::format("{},{},{},{},{},{},{},{}{},{}\n", CsvField(section.name), CsvField(section.sequence),
                     CsvField(row.contender), row.repetition, row.input, row.outcome.objects,
                     row.outcome.segments, stages, Field(row.outcome.added_ms), Field(row.total_ms()));
}

}  // namespace

std::string BenchJson(const BenchEnvironment& environment, const Json& settings, const BenchReport& report) {
  Json json{{"program", "armature bench"}, {"environment", EnvironmentJson(environment)}};
  json["settings"] = settings;
  AddBenchRecord(MakeRecord(environment, report), json);
  for (const char* list : {"sections", "ratios", "series", "tables"}) json[list] = Json::array();
  for (const BenchSection& section : report.sections) AddSection(section, json);
  json["complete"] = true;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string RawCsv(const BenchReport& report) {
  std::string text =
      fmt::format("table,sequence,contender,repetition,frame,objects,segments,{},added,total\n",
                  fmt::join(kBenchStageNames, ","));
  for (const BenchSection& section : report.sections) {
    for (const BenchRow& row : section.rows) text += RawRow(section, row);
  }
  return text;
}

}  // namespace armature
