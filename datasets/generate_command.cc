// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/generate_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "base/console.h"
#include "base/errors.h"
#include "base/interrupt.h"
#include "base/nearest_name.h"
#include "base/progress.h"
#include "cli/data_folders.h"
#include "cli/help.h"
#include "datasets/cad/folder_collection.h"
#include "datasets/rooms/generate_rooms.h"
#include "datasets/scene/scene_yaml.h"
#include "datasets/sequence_pictures.h"
#include "io/image.h"
#include "io/sequence.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

// Of the contact sheet; rows of one sequence, pixels of a picture and between.
constexpr int kColumns = 5, kRows = 2, kWidth = 240, kMargin = 4;

// Pictures evenly over the sequence; fewer when it has fewer.
std::vector<cv::Mat3b> Thumbnails(const std::filesystem::path& sequence) {
  const SequencePictures pictures(sequence);
  const size_t wanted = std::min<size_t>(kColumns * kRows, pictures.size());
  std::vector<cv::Mat3b> thumbnails;
  for (size_t i = 0; i < wanted; ++i) {
    const cv::Mat image = pictures.Read(i * pictures.size() / wanted);
    cv::Mat3b small;
    cv::resize(image, small, {kWidth, kWidth * image.rows / image.cols}, 0, 0, cv::INTER_AREA);
    thumbnails.push_back(small);
  }
  return thumbnails;
}

// Below `sheet`, with a margin.
void Append(const std::vector<cv::Mat3b>& thumbnails, cv::Mat3b* sheet) {
  const int step_x = kWidth + kMargin, step_y = thumbnails.front().rows + kMargin;
  const int rows = (static_cast<int>(thumbnails.size()) + kColumns - 1) / kColumns;
  cv::Mat3b block(rows * step_y, sheet->cols, cv::Vec3b(255, 255, 255));
  for (int i = 0; i < static_cast<int>(thumbnails.size()); ++i) {
    const cv::Mat3b& picture = thumbnails[static_cast<size_t>(i)];
    picture.copyTo(
        block(cv::Rect(kMargin + i % kColumns * step_x, i / kColumns * step_y, picture.cols, picture.rows)));
  }
  sheet->push_back(block);
}

// Pictures evenly over each sequence folder's rgb.txt, one sequence below the other; 8-bit BGR. Throws
// InputError when a list or an image cannot be read.
cv::Mat3b ContactSheet(const std::vector<std::filesystem::path>& sequences) {
  cv::Mat3b sheet(kMargin, kColumns * (kWidth + kMargin) + kMargin, cv::Vec3b(255, 255, 255));
  for (const std::filesystem::path& sequence : sequences) Append(Thumbnails(sequence), &sheet);
  return sheet;
}

const std::vector<std::string> kDefaultScenes = {"seq1", "seq2", "seq3"};

// By name; none where the program has been parted from its data.
std::vector<std::string> ShippedScenes() {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(ScenesFolder(), ignored)) {
    if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<fs::path> ScenesToMake(const GenerateArguments& arguments) {
  if (!arguments.scenes.empty() && !arguments.only.empty()) {
    throw InputError("generate: --only chooses among the shipped scenes; leave it out with --scene");
  }
  if (!arguments.scenes.empty()) return arguments.scenes;
  const std::vector<std::string> shipped = ShippedScenes();
  std::vector<fs::path> files;
  for (const std::string& name : arguments.only.empty() ? kDefaultScenes : arguments.only) {
    if (std::find(shipped.begin(), shipped.end(), name) == shipped.end())
      throw InputError("generate: --only: " + UnknownNameMessage("scene", name, shipped));
    files.push_back(ScenesFolder() / (name + ".yaml"));
  }
  return files;
}

void Say(const Generated& generated, const std::string& what) {
  PrintResult(
      fmt::format("{}: {}{}\n", generated.folder.string(), what, generated.is_new ? "" : " (there already)"));
}

// Shows the progress of one sequence.
Generated GenerateWithProgress(const fs::path& scene, const std::vector<CadInstance>& collection,
                               const fs::path& out, const SequenceOptions& options) {
  std::unique_ptr<Progress> shown;
  const GenerationProgress progress{[&](const std::string& name, int frames) {
                                      shown = std::make_unique<Progress>(name + ": pictures", frames);
                                    },
                                    [&] {
                                      ThrowIfInterrupted();
                                      shown->Step();
                                    }};
  return GenerateSequence(scene, collection, out, options, progress);
}

// Pictures of all sequences, unless nothing has changed.
void ShowOnOneSheet(const std::vector<Generated>& sequences, const fs::path& file) {
  const bool is_new =
      std::any_of(sequences.begin(), sequences.end(), [](const Generated& g) { return g.is_new; });
  if (!is_new && fs::exists(file)) return;
  std::vector<fs::path> folders;
  for (const Generated& sequence : sequences) folders.push_back(sequence.folder);
  WritePicture(file, ContactSheet(folders));
  PrintResult(fmt::format("{}: some of their pictures\n", file.string()));
}

std::uint64_t RoomSeed(const GenerateArguments& arguments) {
  if (arguments.seed && !arguments.split.empty())
    throw InputError("generate: --split and --seed both say which rooms; give one of them");
  if (arguments.seed) return static_cast<std::uint64_t>(*arguments.seed);
  if (arguments.split.empty() || arguments.split == "development") return kDevelopmentSeed;
  if (arguments.split == "check") return kCheckSeed;
  throw InputError("generate: --split: " +
                   UnknownNameMessage("split", arguments.split, {"development", "check"}));
}

void CheckRoomArguments(const GenerateArguments& arguments) {
  const bool has_scenes =
      !arguments.scenes.empty() || !arguments.only.empty() || arguments.sequence.draw != 1;
  const bool is_about_rooms =
      arguments.count != 0 || arguments.first != 0 || !arguments.split.empty() || arguments.seed;
  if (arguments.rooms.empty() && is_about_rooms)
    throw InputError("generate: --count, --first, --split and --seed are about --rooms; name its recipe");
  if (arguments.rooms.empty()) return;
  if (has_scenes) throw InputError("generate: --rooms draws scenes; leave out --scene, --only and --draw");
  if (arguments.count < 1) throw InputError("generate: --rooms needs --count N, how many rooms to draw");
}

int RunGenerateRooms(const GenerateArguments& arguments) {
  const Recipe recipe = ReadRecipe(arguments.rooms);
  const RoomsToMake rooms{arguments.first, arguments.count, RoomSeed(arguments)};
  const Furniture furniture{CollectFurniture(DrawCollection({}), arguments.collections), FurnitureSpecs()};
  std::vector<std::string> made;
  std::vector<Generated> sequences;
  std::vector<RoomPictures> pictures;
  for (const RoomFile& file : WriteRooms(recipe, furniture, rooms, arguments.out)) {
    sequences.push_back(InterruptedAfter(made, [&] {
      return GenerateWithProgress(file.scene, furniture.collection, arguments.out, arguments.sequence);
    }));
    made.push_back(sequences.back().folder.string());
    pictures.push_back({sequences.back().folder, file.plan});
    Say(sequences.back(), "sequence with ground truth");
  }
  const std::string first = RoomName(recipe, rooms, rooms.first);
  const fs::path sheet = arguments.out / (first.substr(0, first.rfind('-')) + ".jpg");
  WritePicture(sheet, RoomSheet(pictures));
  PrintResult(fmt::format("{}: two pictures of each, and its plan\n", sheet.string()));
  return 0;
}

CommandHelp GenerateHelp() {
  return {
      .description =
          "Makes the embedded data: a collection of annotated CAD models of chairs, tables and laptops, and "
          "sequences of rooms with them, rendered, with odometry that drifts, detections that err, and exact "
          "ground truth. The same bytes on every machine; what is there already is not made again. Scenes "
          "are YAML files, also of your own (datasets/README.md).",
      .files = {{"OUT/cad/", "CAD models, their annotated edges and instances.csv"},
                {"OUT/<scene>/", "a sequence: sequence.yaml, rgb/, detections.csv, odometry.txt; the truth"},
                {"OUT/contact_sheet.jpg", "some pictures of all sequences"},
                {"OUT/<recipe>-<split>-<number>/",
                 "with --rooms: a sequence a room, and its scene file beside"},
                {"OUT/<recipe>-<split>.jpg", "with --rooms: two pictures and a plan of each room"}},
      .exit_status = {},
      .examples = {{"all of it, about a minute on two cores", "armature generate --out datasets/generated"},
                   {"ten frames of one scene with detections twice as wrong",
                    "armature generate --out runs/noisy --only seq3 --frames 10 --detection-noise 2 "
                    "--without-cad"},
                   {"40 rooms of many kinds, five minutes on two cores",
                    "armature generate --rooms configs/rooms/mixed.yaml --count 40 --out runs/rooms"}}};
}

}  // namespace

int RunGenerate(const GenerateArguments& arguments) {
  CheckRoomArguments(arguments);
  if (!arguments.rooms.empty()) return RunGenerateRooms(arguments);
  const std::vector<fs::path> scenes = ScenesToMake(arguments);
  const CollectionOptions collection_options;
  const std::vector<CadInstance> collection = DrawCollection(collection_options);
  const std::vector<CadInstance> furniture = CollectFurniture(collection, arguments.collections);
  for (const fs::path& scene : scenes)
    ReadScene(scene, furniture, arguments.sequence.draw);  // all have to be right before anything is written
  std::vector<std::string> made;
  if (!arguments.without_cad) {
    const Generated cad = GenerateCad(arguments.out / "cad", collection_options, collection);
    made.push_back(cad.folder.string());
    Say(cad, "annotated CAD models");
  }
  std::vector<Generated> sequences;
  for (const fs::path& scene : scenes) {
    sequences.push_back(InterruptedAfter(
        made, [&] { return GenerateWithProgress(scene, furniture, arguments.out, arguments.sequence); }));
    made.push_back(sequences.back().folder.string());
    Say(sequences.back(), "sequence with ground truth");
  }
  ShowOnOneSheet(sequences, arguments.out / "contact_sheet.jpg");
  return 0;
}

void AddGenerateCommand(CLI::App& app, int& exit_status) {
  const auto arguments = std::make_shared<GenerateArguments>();
  GenerateArguments& a = *arguments;
  CLI::App* generate =
      app.add_subcommand("generate", "Make the embedded data: annotated CAD models, rendered sequences");
  Describe(*generate, GenerateHelp());
  BeginSection(*generate, "Output");
  generate->add_option("--out", a.out, "folder that gets cad/ and a folder a sequence")
      ->required()
      ->type_name("DIR");
  generate->add_flag("--without-cad", a.without_cad, "sequences only");
  BeginSection(*generate, "Scenes");
  KnownValues(*generate
                   ->add_option("--only", a.only,
                                fmt::format("shipped scenes (default: {})", fmt::join(kDefaultScenes, ", ")))
                   ->type_name("NAME")
                   ->delimiter(','),
              ShippedScenes());
  generate->add_option("--scene", a.scenes, "scene files of your own instead (datasets/README.md)")
      ->type_name("FILE");
  generate
      ->add_option("--collection", a.collections,
                   "folder of annotated CAD models that scenes may place beside our own families, as "
                   "`armature retrieve --build --cad` reads them")
      ->type_name("CAD");
  BeginSection(*generate, "Rooms from a recipe");
  generate->add_option("--rooms", a.rooms, "draw rooms from this recipe instead (configs/rooms)")
      ->type_name("FILE");
  generate->add_option("--count", a.count, "how many rooms")->check(CLI::PositiveNumber)->type_name("N");
  generate->add_option("--first", a.first, "number of the first one")
      ->check(CLI::NonNegativeNumber)
      ->type_name("K")
      ->capture_default_str();
  KnownValues(*generate
                   ->add_option("--split", a.split,
                                "which of the published rooms (default: development); check is for reports "
                                "only, never to choose by")
                   ->type_name("NAME"),
              {"development", "check"});
  generate->add_option("--seed", a.seed, "rooms of another seed instead of a split")
      ->check(CLI::NonNegativeNumber)
      ->type_name("S");
  BeginSection(*generate, "Pictures");
  generate->add_option("--frames", a.sequence.frames, "only the first N pictures of each path")
      ->check(CLI::PositiveNumber)
      ->type_name("N");
  generate->add_flag("--lines-only", a.sequence.lines_only,
                     "no pictures, but the lines that the detector would find in them: far quicker");
  generate
      ->add_option(
          "--detection-noise", a.sequence.detection_noise,
          "factor of everything that detections have wrong: noise, misses, false alarms, turned viewpoints")
      ->check(CLI::NonNegativeNumber)
      ->type_name("FACTOR")
      ->capture_default_str();
  generate
      ->add_option("--draw", a.sequence.draw,
                   "which draw of all that scenes leave to chance: 1 has the seed of the scene's file, 2, 3, "
                   "... others, and sequences named NAME-draw2, ...")
      ->check(CLI::PositiveNumber)
      ->type_name("N")
      ->capture_default_str();
  generate->callback([arguments, &exit_status] { exit_status = RunGenerate(*arguments); });
}

}  // namespace armature
