// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/run_command.h"

#include <fmt/format.h>

#include <map>
#include <memory>

#include "app/run/run_report.h"
#include "app/run/sequence_run.h"
#include "app/run/video_file.h"
#include "base/console.h"
#include "base/errors.h"
#include "base/interrupt.h"
#include "cli/help.h"
#include "io/image.h"
#include "io/run_folder.h"
#include "io/sequence.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

// The detections that a sequence is run with instead of its own; empty: those.
fs::path FindDetections(const fs::path& given, const fs::path& sequence) {
  if (given.empty() || !fs::is_directory(given)) return given;
  return given / (ReadSequenceSettings(sequence / "sequence.yaml").name + ".csv");
}

std::vector<Sequence> LoadSequences(const RunArguments& arguments,
                                    const std::vector<std::string>& categories) {
  const bool is_one_file = !arguments.detections.empty() && !fs::is_directory(arguments.detections);
  if (is_one_file && arguments.sequences.size() > 1)
    throw InputError(fmt::format(
        "--detections {}: is one file for {} sequences; give a folder that has <sequence name>.csv each",
        arguments.detections.string(), arguments.sequences.size()));
  std::vector<Sequence> sequences;
  std::map<std::string, fs::path> folder_of_name;
  for (const fs::path& folder : arguments.sequences) {
    Sequence sequence = LoadSequence(folder, categories, {}, FindDetections(arguments.detections, folder));
    const auto [earlier, is_new] = folder_of_name.emplace(sequence.name, folder);
    if (!is_new) {
      throw InputError(
          fmt::format("{}: has the name '{}' as {} does; run folders are named by it, so give them "
                      "different names in sequence.yaml or run them one by one",
                      folder.string(), sequence.name, earlier->second.string()));
    }
    sequences.push_back(std::move(sequence));
  }
  return sequences;
}

std::vector<fs::path> RunFolders(const std::vector<Sequence>& sequences, const fs::path& out) {
  if (sequences.size() == 1) return {out};
  if (IsCompleteRun(out)) {
    throw InputError(
        fmt::format("{}: is the run of one sequence; choose another folder for several", out.string()));
  }
  std::vector<fs::path> folders;
  folders.reserve(sequences.size());
  for (const Sequence& sequence : sequences) folders.push_back(out / sequence.name);
  return folders;
}

// One a sequence; empty where none is asked for.
std::vector<fs::path> VideoFiles(const std::vector<Sequence>& sequences, const fs::path& video) {
  std::vector<fs::path> files(sequences.size());
  if (video.empty()) return files;
  for (size_t i = 0; i < sequences.size(); ++i)
    files[i] = sequences.size() == 1 ? video : video / (sequences[i].name + ".mp4");
  for (const fs::path& file : files) CheckVideoName(file);
  return files;
}

// What would end the run of a later sequence, found before the first one runs.
void CheckBeforeRunning(const std::vector<Sequence>& sequences, const std::vector<fs::path>& folders) {
  for (const Sequence& sequence : sequences) {
    if (!sequence.segments.empty()) continue;
    const ImageResult first = ReadImage(sequence.images.front().file, sequence.camera);
    if (!first.image) throw InputError(first.error);
  }
  for (const fs::path& folder : folders) const RunFolder may_be_written(folder);
}

CommandHelp RunHelp() {
  return {.description =
              "Takes each sequence (a folder of images, boxes with optional viewpoint priors, and odometry; "
              "datasets/README.md) frame by frame through the pipeline: line segments, association with the "
              "edges of the category models, pose and shape of each object, and one map of all objects and "
              "cameras. Without odometry there are single views, but no map.\n\n"
              "Everything is read and checked before the first frame. A run folder is there whole or not at "
              "all; an older run in its place is replaced at the end.",
          .files = {{"OUT/objects.csv", "the map: a row an object; objects_odometry.csv: by odometry alone"},
                    {"OUT/trajectory.txt", "T_world_camera of the map; odometry_scaled.txt: of the odometry"},
                    {"OUT/observations.csv", "a row a detection; associations.csv: a row a matched segment"},
                    {"OUT/shape_evidence.csv", "what the images say of each object's shape"},
                    {"OUT/timings.csv", "a row a frame: milliseconds of each stage"},
                    {"OUT/config.yaml", "every option as it was"},
                    {"OUT/summary.json", "versions, machine, counts, percentiles, peak memory"},
                    {"OUT/overlays/", "with --overlays: a picture a frame"},
                    {"VIDEO", "with --video: the overlays at the sequence's frame rate"}},
          .exit_status = {},
          .examples = {
              {"a generated sequence, with the category models learnt from its CAD models",
               "armature run datasets/generated/seq1 --out runs/seq1 --categories "
               "results/reproduce/categories"},
              {"three sequences as the paper has it, a run folder each in runs/paper",
               "armature run datasets/generated/seq1 datasets/generated/seq2 datasets/generated/seq3 "
               "--out runs/paper --preset paper"},
              {"a look at the first frames with another line detector",
               "armature run datasets/generated/seq1 --out runs/look --frames 20 --video runs/look.mp4 --set "
               "lines.detector=lsd"}}};
}

}  // namespace

int RunRun(const RunArguments& arguments) {
  if (arguments.frames < 0)
    throw InputError(fmt::format("--frames {}: has to be 1 or more, 0 for all", arguments.frames));
  SequenceRunSettings settings;
  settings.options = LoadOptions(arguments.configuration);
  settings.models = LoadModels(arguments.configuration);
  settings.preset = arguments.configuration.preset;
  settings.config_yaml = ConfigurationText(arguments.configuration, settings.options);
  settings.overlays = arguments.overlays;
  settings.pipelined = arguments.pipelined;
  settings.frames = arguments.frames;
  settings.jitter = arguments.jitter;

  const std::vector<Sequence> sequences = LoadSequences(arguments, CategoryNames(settings.models));
  const std::vector<fs::path> folders = RunFolders(sequences, arguments.out);
  CheckBeforeRunning(sequences, folders);

  const std::vector<fs::path> videos = VideoFiles(sequences, arguments.video);
  std::vector<SequenceRunResult> results;
  std::vector<std::string> finished;
  for (size_t i = 0; i < sequences.size(); ++i) {
    settings.video = videos[i];
    results.push_back(
        InterruptedAfter(finished, [&] { return RunSequence(sequences[i], settings, folders[i]); }));
    finished.push_back(folders[i].string());
  }
  PrintResult(arguments.json ? RunReportJson(results) : RunReportText(results));
  return 0;
}

void AddRunCommand(CLI::App& app, int& exit_status) {
  const auto arguments = std::make_shared<RunArguments>();
  RunArguments& a = *arguments;
  CLI::App* run = app.add_subcommand("run", "Find and place the objects of sequences, a run folder each");
  Describe(*run, RunHelp());
  BeginSection(*run, "Input");
  run->add_option("SEQUENCE", a.sequences, "sequence folders")->required()->type_name("DIR");
  run->add_option(
         "--detections", a.detections,
         "boxes to use instead of the sequence's detections.csv; with several sequences a folder that "
         "has <sequence name>.csv each. Single views have no truth then")
      ->type_name("FILE");
  run->add_option("--frames", a.frames, "only the first N images (0: all)")->type_name("N");
  run->add_flag(
      "--pipelined", a.pipelined,
      "load the next image and find its lines in a second thread: the same results, more frames a second");
  run->add_option(
         "--jitter", a.jitter,
         "change the input by what must not matter (lines by 0.1 pixel, boxes by 0.1 %), in another way "
         "for each seed: how far do results move? (0: no change)")
      ->check(CLI::NonNegativeNumber)
      ->type_name("N");
  BeginSection(*run, "Output");
  run->add_option("--out", a.out, "run folder; with several sequences DIR/<sequence name> each")
      ->required()
      ->type_name("DIR");
  run->add_flag("--overlays", a.overlays, "also write a picture of each frame");
  run->add_option(
         "--video", a.video,
         "also write the overlays as a video, .mp4 or .avi; with several sequences a folder that gets "
         "<sequence name>.mp4 each")
      ->type_name("FILE");
  run->add_flag("--json", a.json, "print JSON instead of a table");
  AddConfigurationArguments(*run, a.configuration);
  run->callback([arguments, &exit_status] { exit_status = RunRun(*arguments); });
}

}  // namespace armature
