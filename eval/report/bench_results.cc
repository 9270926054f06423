// SPDX-License-Identifier: BSD-3-Clause
#include "eval/report/bench_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/errors.h"
#include "eval/report/table_json.h"
#include "io/bench_record.h"
#include "io/named_span.h"

namespace armature {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kBenchRemedy = "run `armature bench --out` again";

// Curves over the same axes of one sequence share a plot.
TimeCurves& FindPlot(const Json& series, std::vector<TimeCurves>& plots) {
  const auto sequence = series.at("sequence").get<std::string>();
  const auto x_label = series.at("x_label").get<std::string>();
  const auto y_label = series.at("y_label").get<std::string>();
  for (TimeCurves& plot : plots) {
    if (plot.sequence == sequence && plot.x_label == x_label && plot.y_label == y_label) return plot;
  }
  return plots.emplace_back(TimeCurves{sequence, x_label, y_label, {}});
}

std::vector<TimeCurves> MakeCurves(const Json& bench) {
  std::vector<TimeCurves> plots;
  for (const Json& series : bench.at("series")) {
    TimeCurves::Curve curve{series.at("contender").get<std::string>(), {}};
    for (const Json& point : series.at("points")) {
      curve.points.push_back({point.at("x").get<double>(), point.at("median").get<double>(),
                              point.at("p10").get<double>(), point.at("p90").get<double>()});
    }
    FindPlot(series, plots).curves.push_back(std::move(curve));
  }
  return plots;
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

BenchResults ReadResults(const Json& json, const std::filesystem::path& file) {
  BenchResults results;
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

StageBars& FindBars(const std::string& sequence, size_t objects, std::vector<StageBars>& all) {
  for (StageBars& bars : all) {
    if (bars.sequence == sequence) return bars;
  }
  return all.emplace_back(
      StageBars{sequence,
                fmt::format("Median time of each stage, frames of {} with {} objects", sequence, objects),
                {},
                {}});
}

double& GetValue(const std::string& engine, const std::string& stage, StageBars& bars) {
  const size_t place = FindPlace(stage, bars.stages);
  auto bar = std::find_if(bars.bars.begin(), bars.bars.end(),
                          [&](const StageBars::Bar& b) { return b.engine == engine; });
  if (bar == bars.bars.end()) bar = bars.bars.insert(bars.bars.end(), StageBars::Bar{engine, {}});
  bar->milliseconds.resize(std::max(bar->milliseconds.size(), place + 1), 0);
  return bar->milliseconds[place];
}

}  // namespace

BenchResults ReadBenchResults(const std::filesystem::path& folder) {
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

std::vector<StageBars> MakeStageBars(const BenchResults& bench) {
  std::vector<StageBars> all;
  for (const NamedSpan& span : bench.spans) {
    const bool is_engine = span.contender.find(':') != std::string::npos;  // not the calibration loop
    if (span.table != "comparison" || !is_engine || span.stage == kTotal) continue;
    GetValue(span.contender, span.stage, FindBars(span.sequence, bench.objects, all)) =
        span.milliseconds.median;
  }
  for (StageBars& bars : all) {
    for (StageBars::Bar& bar : bars.bars) bar.milliseconds.resize(bars.stages.size(), 0);
  }
  return all;
}

}  // namespace armature
