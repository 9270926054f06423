// SPDX-License-Identifier: BSD-3-Clause
#include "eval/report/reported_bench.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/errors.h"
#include "eval/report/table_json.h"
#include "io/bench_record.h"
#include "io/json_fields.h"
#include "io/json_file.h"
#include "io/named_span.h"

namespace armature {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kBenchRemedy = "run `armature bench --out` again";

constexpr double kLogarithmicTimes = 30, kLogarithmicSizes = 100;  // largest by smallest

// Curves over the same axes of one sequence share a plot.
Plot& FindPlot(const Json& series, std::vector<TimeCurves>& all) {
  const auto sequence = JsonField<std::string>(series, "sequence");
  const auto x_label = JsonField<std::string>(series, "x_label");
  const auto y_label = JsonField<std::string>(series, "y_label");
  for (TimeCurves& curves : all) {
    if (curves.sequence == sequence && curves.plot.x_label == x_label && curves.plot.y_label == y_label)
      return curves.plot;
  }
  return all
      .emplace_back(TimeCurves{sequence, {.title = "", .x_label = x_label, .y_label = y_label, .series = {}}})
      .plot;
}

// Whether the values are so different that the small ones could not be read on a linear axis.
bool IsLogarithmic(const Plot& plot, std::vector<double> PlotSeries::*values, double ratio) {
  double least = std::numeric_limits<double>::max(), most = 0;
  for (const PlotSeries& series : plot.series) {
    for (const double value : series.*values) {
      least = std::min(least, value);
      most = std::max(most, value);
    }
  }
  return least > 0 && most > ratio * least;
}

std::vector<TimeCurves> MakeCurves(const Json& bench) {
  std::vector<TimeCurves> all;
  for (const Json& series : JsonList(bench, "series")) {
    PlotSeries curve{.name = JsonField<std::string>(series, "contender")};
    for (const Json& point : JsonList(series, "points")) {
      curve.x.push_back(JsonField<double>(point, "x"));
      curve.y.push_back(JsonField<double>(point, "median"));
      curve.low.push_back(JsonField<double>(point, "p10"));
      curve.high.push_back(JsonField<double>(point, "p90"));
    }
    FindPlot(series, all).series.push_back(std::move(curve));
  }
  for (TimeCurves& curves : all) {
    curves.plot.log_x = IsLogarithmic(curves.plot, &PlotSeries::x, kLogarithmicSizes);
    curves.plot.log_y = IsLogarithmic(curves.plot, &PlotSeries::y, kLogarithmicTimes);
  }
  return all;
}

std::vector<std::pair<std::string, std::string>> ListEnvironment(const Json& environment) {
  const Json& git = JsonObject(environment, "git");
  const auto text = [&](const char* key) { return JsonField<std::string>(environment, key); };
  const auto count = [&](const char* key) { return JsonField<int>(environment, key); };
  return {{"benchmark: machine", fmt::format("{}, {} cores", text("cpu"), count("cores"))},
          {"benchmark: threads", fmt::format("{}", count("threads"))},
          {"benchmark: commit",
           JsonField<std::string>(git, "commit") + (JsonField<bool>(git, "dirty") ? ", modified" : "")},
          {"benchmark: compiler", fmt::format("{}, {}", text("compiler"), text("flags"))}};
}

ReportedBench ReadResults(const Json& json) {
  ReportedBench results;
  for (const Json& ratio : JsonList(json, "ratios")) results.ratios.push_back(NamedRatioFromJson(ratio));
  results.curves = MakeCurves(json);
  results.objects = JsonField<size_t>(JsonObject(json, "settings"), "objects");
  results.environment = ListEnvironment(JsonObject(json, "environment"));
  return results;
}

// Where `name` stands in the list, added at its end if it is new.
size_t FindPlace(const std::string& name, std::vector<std::string>& names) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<size_t>(found - names.begin());
  names.push_back(name);
  return names.size() - 1;
}

StackedBars& FindBars(const std::string& sequence, std::vector<StageBars>& all) {
  for (StageBars& bars : all) {
    if (bars.sequence == sequence) return bars.bars;
  }
  return all.emplace_back(StageBars{sequence, {}}).bars;
}

double& GetValue(const std::string& engine, const std::string& stage, StackedBars& bars) {
  const size_t place = FindPlace(stage, bars.stages);
  auto bar = std::find_if(bars.bars.begin(), bars.bars.end(),
                          [&](const StackedBars::Bar& b) { return b.name == engine; });
  if (bar == bars.bars.end()) bar = bars.bars.insert(bars.bars.end(), StackedBars::Bar{engine, {}});
  bar->parts.resize(std::max(bar->parts.size(), place + 1), 0);
  return bar->parts[place];
}

}  // namespace

ReportedBench ReadReportedBench(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "bench.json";
  const Json json = ReadJsonObject(file, kBenchRemedy);
  if (!json.contains("complete") || json["complete"] != true)
    throw InputError(fmt::format("{}: is not a finished benchmark; {}", file.string(), kBenchRemedy));
  ReportedBench results;
  try {
    results = ReadResults(json);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}; {}", file.string(), error.what(), kBenchRemedy));
  }
  results.tables = TablesFromJson(json.contains("tables") ? json["tables"] : Json(), file.string());
  results.spans = ReadBenchRecord(file).spans;
  return results;
}

std::vector<StageBars> MakeStageBars(const ReportedBench& bench) {
  std::vector<StageBars> all;
  for (const NamedSpan& span : bench.spans) {
    const bool is_engine = span.contender.find(':') != std::string::npos;  // not the calibration loop
    if (span.table != "comparison" || !is_engine || span.stage == kTotal) continue;
    GetValue(span.contender, span.stage, FindBars(span.sequence, all)) = span.milliseconds.median;
  }
  for (StageBars& stages : all) {
    for (StackedBars::Bar& bar : stages.bars.bars) bar.parts.resize(stages.bars.stages.size(), 0);
  }
  return all;
}

}  // namespace armature
