// SPDX-License-Identifier: BSD-3-Clause
#include "app/bench_command.h"

#include <fmt/format.h>

#include <memory>
#include <opencv2/core.hpp>
#include <optional>

#include "app/bench_output.h"
#include "bench/bench_sequence.h"
#include "bench/sections/bench_tables.h"
#include "eval/category_lookup.h"
#include "io/errors.h"
#include "io/option_value.h"
#include "io/sequence.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

struct LoadedSequence {
  BenchSequence sequence;
  std::vector<FrameTruth> truth;
};

void CheckAtLeast(const char* option, int value, int least) {
  if (value < least) throw InputError(fmt::format("{} {}: has to be {} or more", option, value, least));
}

void CheckArguments(const BenchArguments& a) {
  CheckAtLeast("--frames", a.frames, 0);
  CheckAtLeast("--warm-up", a.warm_up, 0);
  CheckAtLeast("--repeat", a.repeat, 1);
  CheckAtLeast("--threads", a.threads, 1);
  CheckAtLeast("--objects", a.objects, 1);
  CheckAtLeast("--baseline-frames", a.baseline_frames, 1);
  for (const std::string& table : a.tables) CheckBenchTableName(table);
}

BenchSettings SettingsOf(const BenchArguments& a, const EngineParts& parts) {
  BenchSettings settings;
  settings.harness = {static_cast<size_t>(a.warm_up), static_cast<size_t>(a.repeat)};
  settings.threads = a.threads;
  settings.objects = static_cast<size_t>(a.objects);
  settings.baseline_frames = static_cast<size_t>(a.baseline_frames);
  for (const std::string& name : a.engines.empty() ? DefaultEngines() : a.engines)
    settings.engines.push_back(FullEngineName(name, parts));
  return settings;
}

void CheckNameIsNew(const Sequence& sequence, const std::vector<LoadedSequence>& loaded) {
  for (const LoadedSequence& other : loaded) {
    if (other.sequence.name != sequence.name) continue;
    throw InputError(fmt::format("{}: a second sequence named '{}', tables could not be told apart; give one",
                                 sequence.folder.string(), sequence.name));
  }
}

std::vector<LoadedSequence> LoadAll(const BenchArguments& a, const std::vector<CategoryModel>& models) {
  const CadLibrary cad = a.cad.empty() ? CadLibrary() : CadLibrary(a.cad, SpecsOf(models));
  std::vector<LoadedSequence> loaded;
  for (const fs::path& folder : a.sequences) {
    const Sequence sequence = LoadSequence(folder, CategoryNames(models));
    CheckNameIsNew(sequence, loaded);
    LoadedSequence& to = loaded.emplace_back();
    to.sequence = LoadBenchSequence(sequence, static_cast<size_t>(a.frames));
    to.truth = LoadFrameTruth(folder, to.sequence, models, cad);
  }
  return loaded;
}

std::string Joined(const std::vector<std::string>& names) { return fmt::format("{}", fmt::join(names, ",")); }

// Every option as it was, for bench.json.
SettingTexts TextsOf(const BenchArguments& a, const BenchSettings& settings,
                     const std::vector<std::string>& tables, Options options) {
  SettingTexts texts;
  std::vector<std::string> folders;
  for (const fs::path& folder : a.sequences) folders.push_back(folder.string());
  texts = {{"sequences", Joined(folders)},
           {"tables", Joined(tables)},
           {"engines", Joined(settings.engines)},
           {"frames", std::to_string(a.frames)},
           {"warm_up", std::to_string(a.warm_up)},
           {"repeat", std::to_string(a.repeat)},
           {"threads", std::to_string(a.threads)},
           {"objects", std::to_string(a.objects)},
           {"baseline_frames", std::to_string(a.baseline_frames)},
           {"cad", a.cad.string()},
           {"preset", a.configuration.preset},
           {"config", a.configuration.config.string()},
           {"set", Joined(a.configuration.settings)},
           {"categories", a.configuration.categories.string()}};
  for (const OptionEntry& entry : OptionTable(options)) texts.emplace_back(entry.key, OptionText(entry));
  return texts;
}

}  // namespace

int RunBench(const BenchArguments& a) {
  const TableFormat format = a.json ? TableFormat::kJson : TableFormatFromName(a.format);
  CheckArguments(a);
  const EngineParts parts{LoadOptions(a.configuration), LoadPresets(a.configuration),
                          LoadModels(a.configuration)};
  const BenchSettings settings = SettingsOf(a, parts);
  const std::vector<std::string>& tables = a.tables.empty() ? BenchTableNames() : a.tables;
  const std::vector<LoadedSequence> sequences = LoadAll(a, parts.models);
  std::optional<BenchFolder> folder;
  if (!a.out.empty()) folder.emplace(a.out);

  cv::setNumThreads(a.threads);
  BenchResults results{GetBenchEnvironment(a.threads), TextsOf(a, settings, tables, parts.options), {}};
  for (const auto& [sequence, truth] : sequences) {
    for (const std::string& table : tables)
      results.report.sections.push_back(MeasureSection(table, {sequence, truth, parts, settings}));
  }
  if (folder) WriteBench(results, *folder);
  fmt::print("{}", BenchText(results, format));
  return 0;
}

void AddBenchCommand(CLI::App& app, int& exit_status) {
  const auto arguments = std::make_shared<BenchArguments>();
  BenchArguments& a = *arguments;
  CLI::App* bench = app.add_subcommand("bench", "Measure how long the parts take, next to what they find");
  bench->add_option("SEQUENCE", a.sequences, "sequence folders")->required()->type_name("DIR");
  bench
      ->add_option("--tables", a.tables,
                   fmt::format("which tables: {} (default: all)", fmt::join(BenchTableNames(), ", ")))
      ->type_name("NAME")
      ->delimiter(',');
  bench
      ->add_option(
          "--engines", a.engines,
          "what is compared: lines, lines:PRESET, keypoints:published|wait|hourglass; ratios refer to "
          "the first")
      ->type_name("NAME")
      ->delimiter(',');
  bench->add_option("--frames", a.frames, "only the first N images (0: all)")->type_name("N");
  bench->add_option("--warm-up", a.warm_up, "first frames that do not count")
      ->type_name("N")
      ->capture_default_str();
  bench->add_option("--repeat", a.repeat, "times that all frames are processed")
      ->type_name("N")
      ->capture_default_str();
  bench->add_option("--threads", a.threads, "of line detectors and the network")
      ->type_name("N")
      ->capture_default_str();
  bench->add_option("--objects", a.objects, "the comparison is of frames with so many")
      ->type_name("N")
      ->capture_default_str();
  bench->add_option("--baseline-frames", a.baseline_frames, "about so many frames are given to a baseline")
      ->type_name("N")
      ->capture_default_str();
  bench->add_option("--cad", a.cad, "folder of annotated CAD models, to measure recall without edges_gt.csv")
      ->type_name("DIR");
  bench->add_option("--out", a.out, "also write bench.json, raw.csv and the tables to this folder")
      ->type_name("DIR");
  bench->add_option("--format", a.format, "text, markdown, csv, latex or json")->capture_default_str();
  bench->add_flag("--json", a.json, "the same as --format json");
  AddConfigurationArguments(*bench, a.configuration);
  bench->callback([arguments, &exit_status] { exit_status = RunBench(*arguments); });
}

}  // namespace armature
