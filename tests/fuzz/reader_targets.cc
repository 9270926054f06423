// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz/reader_targets.h"

#include <fmt/format.h>
#include <unistd.h>

#include <span>

#include "app/reproduce/job_records.h"
#include "app/reproduce/read_matrix.h"
#include "base/checksum.h"
#include "base/text.h"
#include "category/category_lookup.h"
#include "datasets/rooms/recipe.h"
#include "datasets/scene/scene_yaml.h"
#include "eval/objects/paper_object_errors.h"
#include "eval/report/reported_bench.h"
#include "eval/report/retrieved_models.h"
#include "eval/report/table_json.h"
#include "eval/statistics/run_values.h"
#include "io/annotations.h"
#include "io/bench_record.h"
#include "io/cad_folder.h"
#include "io/category_yaml.h"
#include "io/evaluation_records.h"
#include "io/g2o.h"
#include "io/image.h"
#include "io/index_file.h"
#include "io/library_file.h"
#include "io/mesh_file.h"
#include "io/options_yaml.h"
#include "io/placed_objects.h"
#include "io/run_configuration.h"
#include "io/run_map.h"
#include "io/run_results.h"
#include "io/segments_csv.h"
#include "io/sequence.h"
#include "io/shape_evidence_csv.h"
#include "io/trajectory.h"
#include "pipeline/options.h"
#include "support/block_collection.h"
#include "truth/ground_truth.h"
#include "truth/true_edges.h"

namespace armature::fuzzing {
namespace {

const std::vector<CategoryModel>& Models() {
  static const std::vector<CategoryModel> models =
      LoadCategories(fs::path(ARMATURE_SOURCE_DIR) / "configs/categories");
  return models;
}

const std::vector<CategorySpec>& Specs() {
  static const std::vector<CategorySpec> specs = CollectSpecs(Models());
  return specs;
}

void ReadTheDetections(const fs::path& file) {
  const fs::path folder = file.parent_path();
  static const Camera camera = ReadSequenceSettings(folder / "sequence.yaml").camera;
  static const std::vector<ImageEntry> images = ReadImageList(folder / "rgb.txt");
  ReadDetections(file, images, camera, {"chair", "table", "laptop"});
}

void ReadTheSegments(const fs::path& file) {
  static const std::vector<ImageEntry> images{{0, {}, 1}, {0.1, {}, 2}, {0.2, {}, 3}};
  ReadSegments(file, images);
}

void ReadTheSequence(const fs::path& file) { LoadSequence(file.parent_path(), {"chair", "table", "laptop"}); }

template <TrajectoryFormat format>
void ReadTrajectoryAs(const fs::path& file) {
  ReadTrajectory(file, {.format = format});
}

void ReadTrueEdges(const fs::path& file) {
  static const GroundTruth truth = LoadGroundTruth(file.parent_path());
  const TrueEdges edges(file, truth, Specs());
}

void ReadTheOptions(const fs::path& file) {
  Options options;
  const std::vector<OptionEntry> entries = OptionTable(options);
  ApplyYaml(file, entries);
  CheckOptions(entries);
}

void ReadTheSetting(const fs::path& file) {
  Options options;
  ApplySetting(ReadTextFile(file), OptionTable(options));
}

void ReadConfig(const fs::path& file) {
  ReadRunConfiguration(file.parent_path());
  ReadOptionTexts(file.parent_path());
  ReadRunOptions(file.parent_path());
}

void ReadMap(const fs::path& file) {
  static const RunResults run = LoadRun(file.parent_path());
  ReadRunMap(run, Models());
}

std::uint64_t ChecksumOf(std::string_view bytes) { return Checksum(std::as_bytes(std::span(bytes))); }

// Past the checksum, which finds accidents: what lies behind it has to hold by itself.
std::string SealLibrary(std::string bytes) {
  if (bytes.size() < sizeof(std::uint64_t)) return bytes;
  bytes.resize(bytes.size() - sizeof(std::uint64_t));
  const std::uint64_t sum = ChecksumOf(bytes);
  return bytes.append(reinterpret_cast<const char*>(&sum), sizeof sum);
}

Eigen::MatrixXf Features() { return Eigen::MatrixXf::Random(3, 24); }

// As WriteIndex has it of these features: the three lines before the payload's.
std::string IndexHead() {
  const fs::path file = fs::temp_directory_path() / fmt::format("armature_fuzz_index_{}", getpid());
  WriteIndex(InstanceIndex(Features(), IndexMethod()), file);
  const std::string content = ReadTextFile(file);
  fs::remove(file);
  return content.substr(0, content.find("payload "));
}

std::string SealIndex(std::string bytes) {
  static const std::string head = IndexHead();
  const size_t line = bytes.find("payload ");
  const size_t start = line == std::string::npos ? line : bytes.find('\n', line);
  if (start == std::string::npos) return bytes;
  const std::string payload = bytes.substr(start + 1);
  return head + fmt::format("payload {} bytes, checksum {:016x}\n", payload.size(), ChecksumOf(payload)) +
         payload;
}

void ReadTheIndex(const fs::path& file) {
  const InstanceIndex index = ReadIndex(file, Features(), IndexMethod());
  index.Nearest(Eigen::VectorXf::Zero(index.dimensions()), 3);
}

}  // namespace

const std::vector<ReaderTarget>& ReaderTargets() {
  static const std::vector<ReaderTarget> targets{
      {"sequence", "sequence/sequence.yaml", [](const fs::path& f) { ReadSequenceSettings(f); }},
      {"images", "sequence/rgb.txt", [](const fs::path& f) { ReadImageList(f); }},
      {"detections", "sequence/detections.csv", ReadTheDetections},
      {"segments", "segments.csv", ReadTheSegments},
      {"odometry", "sequence/odometry.txt", ReadTheSequence},
      {"true_trajectory", "sequence/groundtruth.txt",
       [](const fs::path& f) { LoadTrueTrajectory(f.parent_path()); }},
      {"true_objects", "sequence/objects_gt.csv",
       [](const fs::path& f) { LoadGroundTruth(f.parent_path()); }},
      {"true_detections", "sequence/detections_gt.csv",
       [](const fs::path& f) { LoadGroundTruth(f.parent_path()); }},
      {"true_edges", "sequence/edges_gt.csv", ReadTrueEdges},
      {"trajectory", "tum.txt", ReadTrajectoryAs<TrajectoryFormat::kAuto>},
      {"tum", "tum.txt", ReadTrajectoryAs<TrajectoryFormat::kTum>},
      {"kitti", "kitti.txt", ReadTrajectoryAs<TrajectoryFormat::kKitti>},
      {"euroc", "euroc.csv", ReadTrajectoryAs<TrajectoryFormat::kEuroc>},
      {"stamps", "sequence/rgb.txt", [](const fs::path& f) { ReadStamps(f); }},
      {"image", "image.png", [](const fs::path& f) { ReadImage(f); }},
      {"category", "category.yaml", [](const fs::path& f) { LoadCategory(f); }},
      {"specification", "specification.yaml", [](const fs::path& f) { LoadCategorySpec(f); }},
      {"training", "specification.yaml", [](const fs::path& f) { LoadTrainingSpec(f); }},
      {"options", "options.yaml", ReadTheOptions},
      {"setting", "setting.txt", ReadTheSetting},
      {"matrix", "matrix.yaml", [](const fs::path& f) { ReadMatrix(f, {.fast = true}); }},
      {"recipe", "recipe.yaml", [](const fs::path& f) { ReadRecipe(f); }},
      {"scene", "scene.yaml", [](const fs::path& f) { ReadScene(f, testing::BlockCollection()); }},
      {"config", "run/config.yaml", ReadConfig},
      {"summary", "run/summary.json", [](const fs::path& f) { IdentifyRun(f.parent_path()); }},
      {"observations", "run/observations.csv", [](const fs::path& f) { LoadRun(f.parent_path()); }},
      {"associations", "run/associations.csv", [](const fs::path& f) { LoadRun(f.parent_path()); }},
      {"timings", "run/timings.csv", [](const fs::path& f) { ReadRunTimes(f.parent_path()); }},
      {"objects", "run/objects.csv", [](const fs::path& f) { ReadPlacedObjects(f); }},
      {"map", "run/objects.csv", ReadMap},
      {"map_trajectory", "run/trajectory.txt", ReadMap},
      {"shape_evidence", "run/shape_evidence.csv", [](const fs::path& f) { ReadShapeEvidence(f); }},
      {"retrieval", "run/retrieval.csv", [](const fs::path& f) { ReadRetrieval(f.parent_path()); }},
      {"records", "eval/records.json", [](const fs::path& f) { ReadEvaluationRecords(f); }},
      {"tables", "tables.json", [](const fs::path& f) { ReadTables(f); }},
      {"bench", "bench.json", [](const fs::path& f) { ReadBenchRecord(f); }},
      {"reported_bench", "bench.json", [](const fs::path& f) { ReadReportedBench(f.parent_path()); }},
      {"job", "jobs/runs.json", [](const fs::path& f) { ReadRecord(f.parent_path().parent_path(), "runs"); }},
      {"paper", "paper.csv", [](const fs::path& f) { ReadPaperObjectErrors(f); }},
      {"obj", "mesh.obj", [](const fs::path& f) { ReadMesh(f); }},
      {"off", "mesh.off", [](const fs::path& f) { ReadMesh(f); }},
      {"ply", "mesh.ply", [](const fs::path& f) { ReadMesh(f); }},
      {"boxes", "cad/keypointnet_chair_boxes.txt", [](const fs::path& f) { ReadBoxes(f, "m1"); }},
      {"cad", "cad/instances.csv", [](const fs::path& f) { ReadCadFolder(f.parent_path(), Specs()); }},
      {"annotations", "cad/chair_edges.csv",
       [](const fs::path& f) { ReadAnnotations(f, "edges", Specs()[0]); }},
      {"g2o", "graph.g2o", [](const fs::path& f) { ReadG2o(f); }},
      {"library", "library.armlib", [](const fs::path& f) { ReadLibrary(f, Models()); }, SealLibrary},
      {"index", "library.armlib.chair.index", ReadTheIndex, SealIndex},
      {"numbers", "numbers.txt", [](const fs::path& f) { ParseNumbers(ReadTextFile(f), "numbers"); }},
  };
  return targets;
}

}  // namespace armature::fuzzing
