// SPDX-License-Identifier: BSD-3-Clause
#include "bench/bench_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/console.h"
#include "bench/bench_output.h"
#include "bench/bench_plan.h"
#include "bench/guard/regression_guard.h"
#include "bench/sections/bench_tables.h"
#include "bench/sections/section_plots.h"
#include "cli/help.h"
#include "cli/printed_tables.h"
#include "drawing/plots/gnuplot.h"

namespace armature {
namespace {

constexpr int kSlower = 1;  // exit status

std::optional<BenchRecord> ReadReference(BenchArguments& a) {
  if (a.against.empty()) return std::nullopt;
  BenchRecord reference = ReadBenchRecord(a.against);
  TakeReferenceSettings(a);
  return reference;
}

bool AreDrawn(const BenchArguments& a, const BenchPlan& plan) {
  return !a.out.empty() && !a.no_plots && std::any_of(plan.tables.begin(), plan.tables.end(), IsDrawnTable);
}

// Adds the table of what moved. Returns whether anything became slower.
bool Guard(const BenchRecord& reference, const std::set<TableOfSequence>& measured, BenchResults& results) {
  const BenchRecord now = MakeRecord(results.environment, results.report);
  const GuardResult guard =
      CompareWithReference(GuardedPart(reference, measured), GuardedPart(now, measured));
  results.report.sections.push_back({.name = "against", .sequence = "", .tables = {GuardTable(guard)}});
  return BecameSlower(guard);
}

// What is measured.
void AddSubjects(CLI::App& bench, BenchArguments& a) {
  BeginSection(bench, "What is measured");
  bench.add_option("SEQUENCE", a.sequences, "sequence folders; --tables micro,retrieval needs none")
      ->type_name("DIR");
  KnownValues(*bench.add_option("--tables", a.tables, "which tables (default: all)")
                   ->type_name("NAME")
                   ->delimiter(',')
                   ->allow_extra_args(false),
              BenchTableNames());
  OfferValues(*bench
                   .add_option("--engines", a.engines,
                               "what is compared: lines, lines:PRESET, keypoints:published|wait|hourglass; "
                               "ratios refer to the first")
                   ->type_name("NAME")
                   ->delimiter(',')
                   ->allow_extra_args(false),
              {"lines", "lines:default", "lines:fast", "lines:paper", "lines:paper_meant",
               "keypoints:published", "keypoints:wait", "keypoints:hourglass"});
  bench
      .add_option("--micro", a.micro, "which micro-benchmarks or families of them, as hypothesis:chair (all)")
      ->type_name("NAME")
      ->delimiter(',')
      ->allow_extra_args(false);
}

// On how much, and how.
void AddMeasuring(CLI::App& bench, BenchArguments& a) {
  BeginSection(bench, "How much, and how");
  bench.add_option("--frames", a.frames, "only the first N images (0: all)")->type_name("N");
  bench.add_option("--warm-up", a.warm_up, "first frames that do not count")
      ->type_name("N")
      ->capture_default_str();
  bench.add_option("--repeat", a.repeat, "times that all frames are processed")
      ->type_name("N")
      ->capture_default_str();
  bench.add_option("--threads", a.threads, "of line detectors and the network")
      ->type_name("N")
      ->capture_default_str();
  bench.add_option("--objects", a.objects, "the comparison is of frames with so many")
      ->type_name("N")
      ->capture_default_str();
  bench.add_option("--baseline-frames", a.baseline_frames, "about so many frames are given to a baseline")
      ->type_name("N")
      ->capture_default_str();
  bench
      .add_option("--retrieval-sizes", a.retrieval_sizes, "instances of the libraries of --tables retrieval")
      ->type_name("N")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->capture_default_str();
  bench.add_option("--cad", a.cad, "folder of annotated CAD models, to measure recall without edges_gt.csv")
      ->type_name("DIR");
}

// What becomes of it.
void AddResults(CLI::App& bench, BenchArguments& a) {
  BeginSection(bench, "Output");
  bench
      .add_option("--against", a.against,
                  "compare with this bench.json: status 1 when a stage became slower; what it was measured "
                  "with is taken from it where it is not given here")
      ->type_name("FILE");
  bench.add_option("--out", a.out, "also write bench.json, raw.csv, the tables and plots to this folder")
      ->type_name("DIR");
  bench.add_flag("--no-plots", a.no_plots, "no plots in this folder; they need gnuplot");
  AddFormatArguments(bench, a.format, a.json);
}

CommandHelp BenchHelp() {
  return {
      .description =
          "Measures each stage of the pipeline and of its baselines on the same frames, next to what they "
          "find, so that no speed stands without its accuracy: images are loaded and warmed up before the "
          "clock starts, contenders take turns frame by frame, and below each table stands what is inside "
          "each span. Small functions, memory and retrieval have tables of their own.",
      .files = {{"OUT/bench.json", "environment, settings, all tables and spans; for a later --against"},
                {"OUT/raw.csv", "every row that was measured"},
                {"OUT/tables.*", "the tables as txt, md, csv and tex"},
                {"OUT/*.svg", "plots, unless --no-plots"}},
      .exit_status = {{"1", "with --against also: a stage became slower"}},
      .examples = {{"everything on one sequence",
                    "armature bench datasets/generated/seq1 --categories results/reproduce/categories --out "
                    "runs/bench"},
                   {"our pipeline against a keypoint network as published, few frames",
                    "armature bench datasets/generated/seq1 --frames 30 --tables comparison --engines "
                    "lines,lines:fast,keypoints:published"},
                   {"small functions alone", "armature bench --tables micro --micro hypothesis"}}};
}

}  // namespace

int RunBench(BenchArguments a) {
  const TableFormat format = a.json ? TableFormat::kJson : TableFormatFromName(a.format);
  const std::optional<BenchRecord> reference = ReadReference(a);
  const BenchPlan plan(a);
  a.tables = plan.tables;
  a.engines = plan.settings.engines;
  if (reference) CheckSharesTables(*reference, ListTablesOfSequences(plan));
  const bool draw = AreDrawn(a, plan);
  if (draw) CheckGnuplot();
  std::optional<BenchFolder> folder;
  if (!a.out.empty()) folder.emplace(a.out);

  BenchResults results{GetBenchEnvironment(a.threads), SettingsJson(a, plan.parts.options), {}};
  results.report = Measure(plan);
  const bool slower = reference && Guard(*reference, ListTablesOfSequences(plan), results);
  if (draw) WritePlots(results.report, plan.settings.objects, *folder);
  if (folder) WriteBench(results, *folder);
  PrintResult(BenchText(results, format));
  return slower ? kSlower : 0;
}

void AddBenchCommand(CLI::App& app, int& exit_status) {
  const auto arguments = std::make_shared<BenchArguments>();
  BenchArguments& a = *arguments;
  CLI::App* bench = app.add_subcommand("bench", "Measure how long the parts take, next to what they find");
  Describe(*bench, BenchHelp());
  AddSubjects(*bench, a);
  AddMeasuring(*bench, a);
  AddResults(*bench, a);
  AddConfigurationArguments(*bench, a.configuration);
  bench->callback([arguments, bench, &exit_status] {
    for (const KeptArgument& kept : KeptArguments(*arguments)) {
      if (bench->get_option(kept.option)->count() > 0) arguments->given.insert(kept.setting);
    }
    exit_status = RunBench(*arguments);
  });
}

}  // namespace armature
