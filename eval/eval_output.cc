// SPDX-License-Identifier: BSD-3-Clause
#include "eval/eval_output.h"

#include <nlohmann/json.hpp>

#include "cli/printed_tables.h"
#include "io/atomic_write.h"
#include "io/build_info.h"
#include "io/run_folder.h"

namespace armature {
namespace {

bool IsCompleteEvaluation(const std::filesystem::path& folder) { return SaysComplete(folder / "eval.json"); }

std::string EvalJson(const std::vector<std::filesystem::path>& runs, const std::vector<Table>& tables) {
  const BuildInfo build = GetBuildInfo();
  nlohmann::ordered_json json{{"program", "armature eval"},
                              {"version", build.version},
                              {"git_commit", build.git_commit},
                              {"git_dirty", build.git_dirty},
                              {"runs", nlohmann::ordered_json::array()}};
  for (const std::filesystem::path& run : runs)
    json["runs"].push_back(std::filesystem::absolute(run).lexically_normal().string());
  json["tables"] = nlohmann::ordered_json::parse(FormatTables(tables, TableFormat::kJson));
  json["complete"] = true;
  return json.dump(2) + "\n";
}

}  // namespace

EvalFolder::EvalFolder(const std::filesystem::path& folder)
    : OutputFolder(folder, {"a finished evaluation", IsCompleteEvaluation}) {}

void WriteEvaluation(const std::vector<std::filesystem::path>& runs, const Evaluation& evaluation,
                     EvalFolder& folder) {
  const std::vector<Table>& tables = evaluation.tables;
  AtomicWrite(folder.partial() / "eval.json", EvalJson(runs, tables));
  AtomicWrite(folder.partial() / "records.json", EvaluationRecordsJson(evaluation.records));
  WriteTableFiles(folder.partial(), [&](TableFormat format) { return FormatTables(tables, format); });
  folder.Publish();
}

}  // namespace armature
