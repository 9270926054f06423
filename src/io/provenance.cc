// SPDX-License-Identifier: BSD-3-Clause
#include "io/provenance.h"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "base/errors.h"
#include "io/csv.h"
#include "io/json_file.h"
#include "io/placed_objects.h"
#include "io/run_configuration.h"

namespace armature {
namespace {

namespace fs = std::filesystem;
using Document = nlohmann::ordered_json;
using Remarks = std::vector<ProvenanceRemark>;

// A member of summary.json or bench.json. `consequence`: of different values; empty: there is none.
struct Fact {
  const char* name;
  const char* pointer;
  const char* consequence;
};

constexpr const char* kMakeRunAgain = "run `armature run` again";
constexpr const char* kBenchAgain = "write a new one with 'armature bench'";
constexpr const char* kTimes = "times do not compare";
constexpr const char* kOtherData = "not the same data, pairs may be of different things";

constexpr Fact kRunFacts[] = {{"CPU", "/machine/cpu", kTimes},
                              {"cores", "/machine/cores", kTimes},
                              {"threads", "/threads", kTimes},
                              {"compiler", "/versions/compiler", kTimes},
                              {"OpenCV", "/versions/opencv", "lines may be others"},
                              {"processed images", "/counts/frames", kOtherData},
                              {"detections", "/counts/detections", kOtherData},
                              {"version", "/version", ""},
                              {"commit", "/git", ""},
                              {"preset", "/preset", ""}};

constexpr Fact kBenchFacts[] = {{"CPU", "/environment/cpu", kTimes},
                                {"cores", "/environment/cores", kTimes},
                                {"threads", "/environment/threads", kTimes},
                                {"compiler", "/environment/compiler", kTimes},
                                {"compiler flags", "/environment/flags", kTimes},
                                {"OpenCV", "/environment/versions/opencv", kTimes},
                                {"sequences", "/settings/sequences", kOtherData},
                                {"category models", "/settings/categories", ""},
                                {"objects of the comparison's frames", "/settings/objects", kTimes},
                                {"version", "/environment/version", ""},
                                {"commit", "/environment/git", ""},
                                {"preset", "/settings/preset", ""}};

// A text as it is, anything else as JSON.
std::string FactValue(const Document& value) {
  return value.is_string() ? value.get<std::string>()
                           : value.dump(-1, ' ', false, Document::error_handler_t::replace);
}

// "unknown" of older results, which lack members, and of members that are not what they should be.
std::string FactText(const Document& json, const char* pointer) {
  const Document::json_pointer place(pointer);
  const Document value = json.contains(place) ? json.at(place) : Document();
  if (value.is_null()) return "unknown";
  if (value.is_object() && value.contains("commit"))  // a git state
    return FactValue(value["commit"]) +
           (value.contains("dirty") && value["dirty"] == true ? " (modified)" : "");
  return FactValue(value);
}

template <size_t kCount>
void AddFacts(const Fact (&facts)[kCount], const Document& a, const Document& b, Remarks& remarks) {
  for (const Fact& fact : facts) {
    const std::string in_a = FactText(a, fact.pointer), in_b = FactText(b, fact.pointer);
    if (in_a == in_b) continue;
    const std::string consequence = *fact.consequence ? fmt::format(": {}", fact.consequence) : "";
    remarks.push_back(
        {fmt::format("{}: {} in A, {} in B{}", fact.name, in_a, in_b, consequence), *fact.consequence != 0});
  }
}

using OptionTexts = std::map<std::string, std::string>;

void AddOptionRemark(const OptionTexts& a, const OptionTexts& b, Remarks& remarks) {
  std::set<std::string> keys;
  for (const OptionTexts* options : {&a, &b})
    for (const auto& [key, value] : *options) keys.insert(key);
  const auto value = [](const OptionTexts& options, const std::string& key) {
    const auto found = options.find(key);
    return found == options.end() ? "unknown" : found->second;
  };
  std::vector<std::string> different;
  for (const std::string& key : keys) {
    const std::string in_a = value(a, key), in_b = value(b, key);
    if (in_a != in_b) different.push_back(fmt::format("{} ({}, {})", key, in_a, in_b));
  }
  if (!different.empty())
    remarks.push_back({fmt::format("Options that differ (A, B): {}.", fmt::join(different, ", "))});
}

// The files that a run reads, but for the images themselves.
void AddFolderRemarks(const fs::path& a, const fs::path& b, Remarks& remarks) {
  if (a == b) return;
  for (const auto& [folder, name] : {std::pair{a, "A"}, std::pair{b, "B"}}) {
    if (fs::is_directory(folder)) continue;
    remarks.push_back(
        {fmt::format("the sequence folder of {} is gone: it may not be the same data", name), true});
    return;
  }
  for (const char* file : {"sequence.yaml", "rgb.txt", "detections.csv", "odometry.txt"}) {
    const auto text = [&](const fs::path& folder) {
      return fs::exists(folder / file) ? ReadTextFile(folder / file) : "";
    };
    if (text(a) != text(b))
      remarks.push_back({fmt::format("{} of the two sequence folders differ: {}", file, kOtherData), true});
  }
}

fs::path DetectionsFile(const RunIdentity& run) {
  return run.detections.empty() ? run.sequence_folder / "detections.csv" : run.detections;
}

void AddDataRemarks(const RunIdentity& a, const RunIdentity& b, Remarks& remarks) {
  AddFolderRemarks(a.sequence_folder, b.sequence_folder, remarks);
  const auto text = [](const fs::path& file) { return fs::exists(file) ? ReadTextFile(file) : ""; };
  const fs::path of_a = DetectionsFile(a), of_b = DetectionsFile(b);
  const bool is_told = a.detections.empty() && b.detections.empty();
  if (!is_told && text(of_a) != text(of_b))
    remarks.push_back(
        {fmt::format("the detections differ ({}, {}): {}", of_a.string(), of_b.string(), kOtherData), true});
}

// The category models that the shapes of a map are of: category to checksum.
std::map<std::string, std::string> ShapeModels(const fs::path& run) {
  std::map<std::string, std::string> categories, models;
  if (!fs::exists(run / "objects.csv") || !fs::exists(run / "shape_evidence.csv")) return models;
  for (const PlacedObject& object : ReadPlacedObjects(run / "objects.csv"))
    categories[object.id] = object.category;
  const CsvTable table(run / "shape_evidence.csv", {"id"});
  if (!table.HasColumn("model")) return models;
  for (const CsvRow& row : table.rows()) models[categories[row.Text("id")]] = row.Text("model");
  return models;
}

void AddModelRemarks(const fs::path& a, const fs::path& b, Remarks& remarks) {
  const auto models_b = ShapeModels(b);
  for (const auto& [category, model] : ShapeModels(a)) {
    const auto found = models_b.find(category);
    if (found != models_b.end() && found->second != model)
      remarks.push_back(
          {fmt::format("the category models of '{}' differ: shapes do not compare", category), true});
  }
}

OptionTexts BenchOptions(const Document& json) {
  OptionTexts options;
  const Document::json_pointer place("/settings/options");
  if (!json.contains(place)) return options;
  for (const auto& [key, value] : json.at(place).items()) options[key] = FactValue(value);
  return options;
}

}  // namespace

Remarks CompareRunProvenance(const RunIdentity& a, const RunIdentity& b) {
  Remarks remarks;
  AddDataRemarks(a, b, remarks);
  AddModelRemarks(a.folder, b.folder, remarks);
  AddFacts(kRunFacts, ReadJsonObject(a.folder / "summary.json", kMakeRunAgain),
           ReadJsonObject(b.folder / "summary.json", kMakeRunAgain), remarks);
  AddOptionRemark(ReadOptionTexts(a.folder), ReadOptionTexts(b.folder), remarks);
  return remarks;
}

Remarks CompareBenchProvenance(const fs::path& a, const fs::path& b) {
  Remarks remarks;
  const Document json_a = ReadJsonObject(a, kBenchAgain), json_b = ReadJsonObject(b, kBenchAgain);
  AddFacts(kBenchFacts, json_a, json_b, remarks);
  AddOptionRemark(BenchOptions(json_a), BenchOptions(json_b), remarks);
  return remarks;
}

}  // namespace armature
