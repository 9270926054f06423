// SPDX-License-Identifier: BSD-3-Clause
#include "app/bench_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <opencv2/imgproc.hpp>

#include "app/printed_tables.h"
#include "bench/detector_bench.h"
#include "bench/detector_table.h"
#include "eval/category_lookup.h"
#include "eval/sequence_truth.h"
#include "eval/true_scene.h"
#include "io/errors.h"
#include "io/image.h"
#include "io/nearest_name.h"
#include "io/sequence.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

std::vector<LineOptions> ChosenDetectors(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const std::vector<std::string>& known = LineDetectorNames();
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      throw InputError("--detector: " + UnknownNameMessage("line detector", name, known));
    }
  }
  std::vector<LineOptions> chosen;
  for (const LineOptions& options : AllDetectors()) {
    if (names.empty() || std::find(names.begin(), names.end(), options.detector) != names.end()) {
      chosen.push_back(options);
    }
  }
  return chosen;
}

std::vector<ImageObject> ObjectsSeen(const TrueScene& scene, const GroundTruth& truth, double timestamp,
                                     size_t detections) {
  std::vector<ImageObject> seen;
  const auto camera = IndexOfStamp(truth.T_world_camera, timestamp);
  for (size_t i = 0; i < detections && camera; ++i) {
    const TrueObject* object = truth.ObjectOf(timestamp, static_cast<int>(i));
    if (!object) continue;
    auto edges =
        scene.EdgesSeen(static_cast<size_t>(object - truth.objects.data()), truth.T_world_camera[*camera]);
    if (edges) seen.push_back({object->category, std::move(*edges)});
  }
  return seen;
}

std::vector<BenchImage> LoadImages(const Sequence& sequence, size_t count) {
  std::vector<BenchImage> images;
  for (size_t i = 0; i < count; ++i) {
    const ImageResult loaded = ReadImage(sequence.images[i].file, sequence.camera);
    if (!loaded.image) throw InputError(loaded.error);
    BenchImage image;
    cv::cvtColor(*loaded.image, image.gray, cv::COLOR_BGR2GRAY);
    for (const Detection& detection : sequence.detections[i]) image.boxes.push_back(detection.box);
    images.push_back(std::move(image));
  }
  return images;
}

Table BenchSequence(const fs::path& folder, const DetectorBenchArguments& arguments,
                    const std::vector<CategoryModel>& models, const CadLibrary& cad) {
  const Sequence sequence = LoadSequence(folder, CategoryNames(models));
  const size_t limit = arguments.frames > 0 ? static_cast<size_t>(arguments.frames) : sequence.images.size();
  std::vector<BenchImage> images = LoadImages(sequence, std::min(limit, sequence.images.size()));
  if (!arguments.cad.empty() || fs::exists(folder / kTrueEdgesFile)) {
    const SequenceTruth truth = LoadSequenceTruth(folder, SpecsOf(models));
    const TrueScene scene(truth, models, cad);
    for (size_t i = 0; i < images.size(); ++i) {
      images[i].objects =
          ObjectsSeen(scene, truth.truth, sequence.images[i].timestamp, sequence.detections[i].size());
    }
  }
  const auto timings = BenchDetectors(images, sequence.camera, ChosenDetectors(arguments.detectors));
  return DetectorTable(sequence.name, images.size(), timings);
}

}  // namespace

int RunDetectorBench(const DetectorBenchArguments& arguments) {
  const TableFormat format = arguments.json ? TableFormat::kJson : TableFormatFromName(arguments.format);
  const std::vector<CategoryModel> models = LoadModels(arguments.configuration);
  const CadLibrary cad = arguments.cad.empty() ? CadLibrary() : CadLibrary(arguments.cad, SpecsOf(models));
  std::vector<Table> tables;
  for (const fs::path& folder : arguments.sequences)
    tables.push_back(BenchSequence(folder, arguments, models, cad));
  fmt::print("{}", FormatTables(tables, format));
  return 0;
}

void AddBenchCommand(CLI::App& app, int& exit_status) {
  CLI::App* bench = app.add_subcommand("bench", "Measure how long the parts take, next to what they find");
  bench->require_subcommand(1);
  const auto arguments = std::make_shared<DetectorBenchArguments>();
  DetectorBenchArguments& a = *arguments;
  CLI::App* detectors =
      bench->add_subcommand("detectors", "Line detectors: time and share of the true edges found");
  detectors->add_option("SEQUENCE", a.sequences, "sequence folders")->required()->type_name("DIR");
  detectors
      ->add_option("--cad", a.cad, "folder of annotated CAD models, to measure recall without edges_gt.csv")
      ->type_name("DIR");
  detectors->add_option("--detector", a.detectors, "only this one; may be repeated")
      ->type_name("NAME")
      ->allow_extra_args(false);
  detectors->add_option("--frames", a.frames, "only the first N images")
      ->check(CLI::PositiveNumber)
      ->type_name("N");
  detectors->add_option("--format", a.format, "text, markdown, csv, latex or json")->capture_default_str();
  detectors->add_flag("--json", a.json, "the same as --format json");
  AddCategoriesArguments(*detectors, a.configuration);
  detectors->callback([arguments, &exit_status] { exit_status = RunDetectorBench(*arguments); });
}

}  // namespace armature
