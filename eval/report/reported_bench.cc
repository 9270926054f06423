// SPDX-License-Identifier: BSD-3-Clause
#include "eval/report/reported_bench.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/errors.h"
#include "eval/report/table_json.h"
#include "io/bench_record.h"
#include "io/named_span.h"

namespace armature {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kBenchRemedy = "run `armature bench --out` again";

constexpr double kLogarithmicTimes = 30, kLogarithmicSizes = 100;  // largest by smallest

// Curves over the same axes of one sequence share a plot.
Plot& FindPlot(const Json& series, std::vector<TimeCurves>& all) {
  const auto sequence = series.at("sequence").get<std::string>();
  const auto x_label = series.at("x_label").get<std::string>();
  const auto y_label = series.at("y_label").get<std::string>();
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
  for (const Json& series : bench.at("series")) {
    PlotSeries curve{.name = series.at("contender").get<std::string>()};
    for (const Json& point : series.at("points")) {
      curve.x.push_back(point.at("x").get<double>());
      curve.y.push_back(point.at("median").get<double>());
      curve.low.push_back(point.at("p10").get<double>());
      curve.high.push_back(point.at("p90").get<double>());
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
  const Json& git = environment.at("git");
  return {{"benchmark: machine", fmt::format("{}, {} cores", environment.at("cpu").get<std::string>(),
                                             environment.at("cores").get<int>())},
          {"benchmark: threads", fmt::format("{}", environment.at("threads").get<int>())},
          {"benchmark: commit",
           git.at("commit").get<std::string>() + (git.at("dirty").get<bool>() ? ", modified" : "")},
          {"benchmark: compiler", fmt::format("{}, {}", environment.at("compiler").get<std::string>(),
                                              environment.at("flags").get<std::string>())}};
}

ReportedBench ReadResults(const Json& json, const std::filesystem::path& file) {
  ReportedBench results;
  results.tables = TablesFromJson(json.at("tables"), file.string());
  results.spans = ReadBenchRecord(file).spans;
  for (const Json& ratio : json.at("ratios")) results.ratios.push_back(NamedRatioFromJson(ratio));
  results.curves = MakeCurves(json);
  results.objects = json.at("settings").at("objects").get<size_t>();
  results.environment = ListEnvironment(json.at("environment"));
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
  const Json json = ReadJson(file, kBenchRemedy);
  if (!json.is_object() || !json.contains("complete") || json["complete"] != true)
    throw InputError(fmt::format("{}: is not a finished benchmark; {}", file.string(), kBenchRemedy));
  try {
    return ReadResults(json, file);
  } catch (const Json::exception& error) {
    throw InputError(fmt::format("{}: is malformed ({}); {}", file.string(), error.what(), kBenchRemedy));
  }
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
