// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/reproduce/job_records.h"
#include "app/reproduce/reproduction_folder.h"
#include "base/text.h"
#include "io/atomic_write.h"
#include "io/build_info.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

// In the order in which a newcomer looks at them.
constexpr std::array kFiles{
    std::pair{"report.html", "the report: open it in a browser"},
    std::pair{"tables.txt", "all tables; also as .md, .csv, .tex and .json"},
    std::pair{"runs", "a run folder each: runs/<variant>/<sequence> (see the README of Armature)"},
    std::pair{"jitter",
              "the same again with changes that must not matter: jitter/<variant>-<seed>/<sequence>"},
    std::pair{"evaluation", "tables of accuracy and retrieval, and their raw rows (.csv)"},
    std::pair{"timings", "benchmarks: bench.json, raw.csv (a row a timed run), tables, plots"},
    std::pair{"pictures", "samples of the data, maps with their CAD models, plots"},
    std::pair{"categories", "category models, learnt for this"},
    std::pair{"library.armlib", "library of CAD instances"},
    std::pair{"jobs", "what was called, what it printed, how long it took, what it is valid for"},
    std::pair{"config.yaml", "the effective matrix: armature reproduce --config"},
    std::pair{"environment.json", "versions, git state, machine, outcome"},
    std::pair{"README.txt", "this list"}};

void CopyInto(const fs::path& folder, const fs::path& from, const std::string& name) {
  fs::create_directories(folder);
  fs::copy_file(from, folder / name, fs::copy_options::overwrite_existing);
}

std::vector<fs::path> Sorted(const fs::path& folder) {
  std::vector<fs::path> entries;
  std::error_code absent;
  for (const auto& entry : fs::directory_iterator(folder, absent)) entries.push_back(entry.path());
  std::sort(entries.begin(), entries.end());
  return entries;
}

// As it was typed, word by word.
std::vector<std::string> ReadOwnCall() {
  std::vector<std::string> words;
  std::istringstream stream(ReadTextFile("/proc/self/cmdline"));
  for (std::string word; std::getline(stream, word, '\0');) words.push_back(word);
  return words;
}

}  // namespace

void WriteEnvironment(const fs::path& folder, double wall_seconds, const std::vector<JobRecord>& jobs) {
  const BuildInfo build = GetBuildInfo();
  const MachineInfo machine = GetMachineInfo();
  nlohmann::ordered_json json{{"program", "armature reproduce"},
                              {"version", build.version},
                              {"git_commit", build.git_commit},
                              {"git_dirty", build.git_dirty},
                              {"compiler", build.compiler},
                              {"flags", build.flags},
                              {"opencv", build.opencv},
                              {"eigen", build.eigen},
                              {"ceres", build.ceres},
                              {"cpu", machine.cpu},
                              {"cores", machine.cores},
                              {"call", ReadOwnCall()},
                              {"wall_seconds", wall_seconds}};
  nlohmann::ordered_json& outcome = json["jobs"] = nlohmann::ordered_json::object();
  for (const JobRecord& job : jobs) {
    auto& count = outcome[StatusName(job.status)];
    count = count.is_null() ? 1 : count.get<int>() + 1;
  }
  json["complete"] = true;
  AtomicWrite(folder / "environment.json", json.dump(2) + "\n");
}

void CollectPictures(const fs::path& folder, const Matrix& matrix) {
  const fs::path pictures = folder / "pictures";
  fs::remove_all(pictures);
  if (const fs::path sheet = matrix.data / "contact_sheet.jpg"; !matrix.scenes.empty() && fs::exists(sheet))
    CopyInto(pictures, sheet, "data.jpg");
  for (const fs::path& variant : Sorted(folder / "runs")) {
    for (const fs::path& run : Sorted(variant)) {
      if (!fs::exists(run / "map.png")) continue;
      CopyInto(pictures, run / "map.png",
               fmt::format("map-{}-{}.png", variant.filename().string(), run.filename().string()));
    }
  }
  for (const fs::path& timing : Sorted(folder / "timings")) {
    for (const fs::path& plot : Sorted(timing / "plots"))
      CopyInto(pictures, plot, fmt::format("timing-{}", plot.filename().string()));
  }
}

std::vector<std::pair<std::string, std::string>> ListFiles(const fs::path& folder) {
  std::vector<std::pair<std::string, std::string>> files;
  for (const auto& [name, meaning] : kFiles) {
    if (fs::exists(folder / name)) files.emplace_back(name, meaning);
  }
  return files;
}

}  // namespace armature
