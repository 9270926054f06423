// SPDX-License-Identifier: BSD-3-Clause
#include "app/reproduce/job_planner.h"

#include <fmt/format.h>

#include <algorithm>

namespace armature {
namespace {

namespace fs = std::filesystem;

std::string RoomJob(const MatrixSequence& room) { return "rooms/" + room.name; }

std::string DataJob(int draw) { return draw == 1 ? "data" : fmt::format("data-draw{}", draw); }

bool Names(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

void AddFrames(int frames, std::vector<std::string>& call) {
  if (frames > 0) call.insert(call.end(), {"--frames", std::to_string(frames)});
}

}  // namespace

Job JobPlanner::Data(int draw) const {
  Job job{.name = DataJob(draw), .alone = true, .always = true};
  std::vector<std::string> call{"generate", "--only", fmt::format("{}", fmt::join(matrix_.scenes, ",")),
                                "--out", Here(LocateDraw(matrix_, draw))};
  if (draw != 1) call.insert(call.end(), {"--draw", std::to_string(draw), "--without-cad"});
  AddFrames(matrix_.frames, call);
  job.commands = {call};
  return job;
}

Job JobPlanner::Room(const MatrixSequence& room) const {
  const RoomSet& rooms = matrix_.rooms.value();
  const bool is_split = std::find(kRoomSplits.begin(), kRoomSplits.end(), rooms.split) != kRoomSplits.end();
  std::vector<std::string> call{"generate",
                                "--rooms",
                                Here(rooms.recipe),
                                "--count",
                                "1",
                                "--first",
                                std::to_string(room.room.value()),
                                is_split ? "--split" : "--seed",
                                rooms.split,
                                "--out",
                                Here(LocateRooms(matrix_))};
  for (const fs::path& folder : rooms.collections)
    call.insert(call.end(), {"--collection", Here(fs::absolute(folder).lexically_normal())});
  if (rooms.lines_only) call.push_back("--lines-only");
  return {.name = RoomJob(room), .commands = {call}, .always = true};
}

// How the edges of our CAD models lie is the category's padding: datasets/README.md.
Job JobPlanner::Category(const LearntCategory& category) const {
  const fs::path spec = folders_.configs / "categories/specs" / (category.name + ".yaml");
  const fs::path edges = LocateDraw(matrix_, 1) / "cad" / (category.name + "_edges.csv");
  const std::string out = "categories/" + category.name + ".yaml";
  const auto& [x, y, z] = category.padding;
  std::vector<std::string> call{
      "learn",    "--spec", Here(spec), "--annotations", Here(edges),
      "--format", "edges",  "--metric", "--padding",     fmt::format("{},{},{}", x, y, z),
      "--out",    out};
  if (category.slab_drop) call.insert(call.end(), {"--slab-drop", fmt::format("{}", *category.slab_drop)});
  return {.name = "categories/" + category.name,
          .commands = {call},
          .outputs = {out},
          .inputs = {Here(spec), Here(edges)},
          .after = {DataJob(1)}};
}

Job JobPlanner::Library() const {
  const std::string cad = Here(matrix_.cad.empty() ? LocateDraw(matrix_, 1) / "cad" : matrix_.cad);
  Job job{.name = "library", .outputs = {kLibraryFile}, .inputs = {cad}};
  job.commands = {Call({"retrieve", "--build", "--cad", cad, "--out", kLibraryFile})};
  NeedCategories(job);
  if (matrix_.cad.empty()) job.after.push_back(DataJob(1));
  return job;
}

Job JobPlanner::Run(const Variant& variant, const MatrixSequence& sequence, int jitter) const {
  const std::string folder = jitter == 0
                                 ? fmt::format("runs/{}/{}", variant.name, sequence.name)
                                 : fmt::format("jitter/{}-{}/{}", variant.name, jitter, sequence.name);
  std::vector<std::string> call{"run", Here(sequence.folder), "--out", folder, "--preset", variant.preset};
  Job job{.name = folder,
          .outputs = {folder},
          .inputs = {Here(sequence.folder), Here(folders_.configs / "presets" / (variant.preset + ".yaml"))}};
  if (!variant.config.empty()) {
    call.insert(call.end(), {"--config", Here(variant.config)});
    job.inputs.push_back(Here(variant.config));
  }
  if (jitter > 0) call.insert(call.end(), {"--jitter", std::to_string(jitter)});
  if (!variant.detections.empty()) {
    job.inputs.emplace_back(Here(variant.detections / (sequence.name + ".csv")));
    call.insert(call.end(), {"--detections", job.inputs.back().string()});
  }
  AddFrames(matrix_.frames, call);
  job.commands = {Call(call)};
  NeedCategories(job);
  if (!matrix_.scenes.empty()) job.after.push_back(DataJob(sequence.draw));
  if (sequence.room) job.after.push_back(RoomJob(sequence));
  if (IsRetrieved(variant.name) && jitter == 0) AddRetrieval(folder, job);
  return job;
}

Job JobPlanner::Bench(const Timing& timing) const {
  const std::string folder = "timings/" + timing.name;
  Job job{.name = folder, .outputs = {folder}, .inputs = {Here(folders_.configs / "presets")}, .alone = true};
  std::vector<std::string> call{"bench"};
  for (const MatrixSequence& sequence : sequences_) {
    if (sequence.draw != 1 || !Names(timing.sequences, sequence.family)) continue;
    call.push_back(Here(sequence.folder));
    job.inputs.emplace_back(Here(sequence.folder));
  }
  call.insert(call.end(), {"--tables", fmt::format("{}", fmt::join(timing.tables, ",")), "--baseline-frames",
                           std::to_string(timing.baseline_frames), "--out", folder});
  if (!timing.engines.empty())
    call.insert(call.end(), {"--engines", fmt::format("{}", fmt::join(timing.engines, ","))});
  AddFrames(timing.frames > 0 ? timing.frames : matrix_.frames, call);
  job.commands = {Call(call)};
  NeedCategories(job);
  if (!matrix_.scenes.empty()) job.after.push_back(DataJob(1));
  return job;
}

Job JobPlanner::Evaluation(const std::string& folder, const std::vector<std::string>& runs,
                           const std::vector<std::string>& more) const {
  Job job{.name = folder, .outputs = {folder}, .inputs = {}};
  std::vector<std::string> call{"eval"};
  for (const std::string& run : runs) {
    call.push_back(run);
    job.inputs.emplace_back(run);
  }
  if (!runs.empty()) AddSequences(job);
  call.insert(call.end(), more.begin(), more.end());
  call.insert(call.end(), {"--out", folder});
  job.commands = {Call(call)};
  job.inputs.emplace_back(CategoriesInput());
  return job;
}

// True edges of one's own sequences.
std::vector<std::string> JobPlanner::CadArguments() const {
  if (matrix_.cad.empty()) return {};
  return {"--cad", Here(matrix_.cad)};
}

// Truth and images.
void JobPlanner::AddSequences(Job& job) const {
  for (const MatrixSequence& sequence : sequences_) {
    const bool is_missing = sequence.room && !fs::exists(sequence.folder);  // it could not be made
    if (!is_missing) job.inputs.emplace_back(Here(sequence.folder));
  }
}

// With what all calls are told.
std::vector<std::string> JobPlanner::Call(std::vector<std::string> call) const {
  if (!matrix_.categories.empty() || !matrix_.category_folder.empty())
    call.insert(call.end(), {"--categories", CategoriesInput()});
  if (folders_.name_configs) call.insert(call.end(), {"--configs", Here(folders_.configs)});
  return call;
}

std::string JobPlanner::CategoriesInput() const {
  if (!matrix_.categories.empty()) return "categories";
  return Here(matrix_.category_folder.empty() ? folders_.configs / "categories" : matrix_.category_folder);
}

// As it is written in the folder of results.
std::string JobPlanner::Here(const fs::path& path) const {
  return path.lexically_relative(folders_.results).string();
}

bool JobPlanner::IsRetrieved(const std::string& variant) const { return Names(matrix_.retrieval, variant); }

void JobPlanner::NeedCategories(Job& job) const {
  job.inputs.emplace_back(CategoriesInput());
  for (const LearntCategory& category : matrix_.categories)
    job.after.push_back("categories/" + category.name);
}

void JobPlanner::AddRetrieval(const std::string& folder, Job& job) const {
  job.commands.push_back(Call({"retrieve", folder, "--library", kLibraryFile, "--place"}));
  job.inputs.emplace_back(kLibraryFile);
  job.after.push_back("library");
}

}  // namespace armature
