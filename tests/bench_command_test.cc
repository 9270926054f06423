// SPDX-License-Identifier: BSD-3-Clause
// `armature bench` as its users start it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/csv.h"
#include "support/path_override.h"
#include "support/small_scene.h"
#include "support/tiny_sequence.h"

namespace armature {
namespace {

using testing::AllFiles;
using testing::CopySmallScene;
using testing::ExpectBadInput;
using testing::ReadFile;
using testing::RunOk;
using testing::TempFolder;
using testing::WriteTinySequence;

TEST(BenchCommand, ComparesEnginesAndDetectorsOnTheSmallScene) {
  const TempFolder folder;
  CopySmallScene(folder, 4);
  const std::string sequence = folder / "out/den", out = folder / "bench";
  const auto result =
      RunOk({"bench", sequence, "--tables", "comparison,detectors", "--engines", "lines,lines:fast",
             "--warm-up", "1", "--repeat", "2", "--objects", "2", "--out", out, "--json"});
  EXPECT_EQ(AllFiles(out),
            (std::set<std::string>{"bench.json", "plots", "plots/comparison-den.svg", "raw.csv", "tables.csv",
                                   "tables.md", "tables.tex", "tables.txt"}));
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(nlohmann::json::parse(ReadFile(folder / "bench/bench.json")), json);
  EXPECT_EQ(json["settings"]["engines"], (std::vector<std::string>{"lines:default", "lines:fast"}));
  EXPECT_EQ(json["settings"]["options"]["lines.detector"], "edgedrawing");
  EXPECT_NE(json["environment"]["flags"], "");
  EXPECT_EQ(json["sections"][0]["frames_counted"], 3);
  EXPECT_EQ(json["sections"][0]["frames_discarded"], 1);
  EXPECT_EQ(json["spans"][0]["contender"], "lines:default");
  EXPECT_EQ(json["spans"][0]["n"], 6);
  EXPECT_EQ(json["calibration_ms"]["n"], 2 * 6);  // in both tables
  ASSERT_EQ(json["tables"].size(), 5u);
  EXPECT_EQ(json["tables"][3]["table"], "detectors");
  EXPECT_EQ(json["tables"][3]["sequence"], "den");
  EXPECT_EQ(json["tables"][3]["rows"].size(), 18u);  // detectors
  EXPECT_GT(json["tables"][3]["rows"][0]["recall [%]"], 30);
  EXPECT_GT(json["tables"][3]["rows"][0]["with pose [%]"], 50);

  const CsvTable raw(folder / "bench/raw.csv", {"contender", "frame", "detection", "total"});
  EXPECT_EQ(raw.rows().size(), 2u * 3 * (2 + 18));
  for (const CsvRow& row : raw.rows()) {
    EXPECT_GE(row.Integer("frame"), 1);
    const double stages = row.Number("detection") + row.Number("association") + row.Number("optimization") +
                          row.Number("mapping");
    EXPECT_LE(stages, row.Number("total"));
  }
}

TEST(BenchCommand, TheTextSaysWhereItWasMeasured) {
  const TempFolder folder;
  WriteTinySequence(folder);
  const auto result =
      RunOk({"bench", folder.path(), "--tables", "scaling", "--warm-up", "1", "--format", "text"});
  EXPECT_NE(result.out.find("load average"), std::string::npos);
  EXPECT_NE(result.out.find("OpenCV"), std::string::npos);
  EXPECT_NE(result.out.find("1920x1080"), std::string::npos);
}

TEST(BenchCommand, VariesTheNumberOfObjects) {
  const TempFolder folder;
  WriteTinySequence(folder);
  const auto result = RunOk(
      {"bench", folder.path(), "--tables", "objects", "--warm-up", "1", "--engines", "lines:fast", "--json"});
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json["tables"][0]["rows"].size(), 12u);
  EXPECT_EQ(json["tables"][0]["rows"][11]["objects"], 20);
  EXPECT_EQ(json["tables"][0]["rows"][11]["repeated [%]"], 90.0);  // two of its own
  EXPECT_EQ(json["series"][0]["points"].size(), 12u);
}

TEST(BenchCommand, MeasuresMemoryInProcessesOfTheirOwn) {
  const TempFolder folder;
  WriteTinySequence(folder);
  const auto result = RunOk(
      {"bench", folder.path(), "--tables", "memory", "--engines", "lines,keypoints:published", "--json"});
  const auto rows = nlohmann::json::parse(result.out)["tables"][0]["rows"];
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0]["engine"], "none, frames only");
  EXPECT_EQ(rows[1]["engine"], "lines:default");
  for (const auto& row : rows) {
    EXPECT_GT(row["program before [MB]"], 1);
    EXPECT_NEAR(row["peak [MB]"].get<double>() - row["program before [MB]"].get<double>(),
                row["added [MB]"].get<double>(), 0.11);
  }
  EXPECT_GT(rows[1]["peak [MB]"], rows[0]["peak [MB]"]);
}

TEST(BenchCommand, MicroBenchmarksNeedNoSequence) {
  const auto result = RunOk({"bench", "--tables", "micro", "--micro", "matching", "--json"});
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json["tables"][0]["rows"].size(), 3u);  // chair, laptop, table
  EXPECT_EQ(json["spans"].size(), 4u);              // and the calibration
  EXPECT_GT(json["calibration_ms"]["median"], 0);
}

TEST(BenchCommand, RetrievalNeedsNoSequence) {
  const auto result = RunOk({"bench", "--tables", "retrieval", "--retrieval-sizes", "200,20", "--json"});
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json["tables"][0]["rows"].size(), 16u);
  EXPECT_EQ(json["tables"][0]["rows"][0]["instances"], 20);
  EXPECT_EQ(json["tables"][0]["rows"][15]["instances"], 200);
  EXPECT_EQ(json["settings"]["retrieval_sizes"], (std::vector<std::string>{"200", "20"}));
}

TEST(BenchCommand, PlotsNeedGnuplotBeforeAnythingIsMeasured) {
  const TempFolder folder;
  WriteTinySequence(folder);
  const std::string out = folder / "bench";
  const std::vector<std::string> arguments{"bench",     folder.path(), "--tables",  "comparison",
                                           "--engines", "lines",       "--warm-up", "1",
                                           "--objects", "2",           "--out",     out};
  const testing::PathOverride nowhere(folder.path());
  ExpectBadInput(arguments, {"gnuplot", "apt-get install", "--no-plots"});
  EXPECT_FALSE(std::filesystem::exists(out));
  std::vector<std::string> without = arguments;
  without.push_back("--no-plots");
  RunOk(without);
  EXPECT_TRUE(AllFiles(out).contains("bench.json"));
  EXPECT_FALSE(AllFiles(out).contains("plots"));
}

TEST(BenchCommand, BadInput) {
  const TempFolder folder;
  WriteTinySequence(folder);
  const std::string sequence = folder.path();
  ExpectBadInput({"bench"}, {"SEQUENCE", "bench --help"});
  ExpectBadInput({"bench", sequence, "--tables", "comparsion"}, {"comparsion", "comparison"});
  ExpectBadInput({"bench", sequence, "--tables", "pipelined", "--engines", "keypoints:published"},
                 {"--tables pipelined", "--engines lines"});
  ExpectBadInput({"bench", sequence, "--engines", "lines:fats"}, {"lines:fats", "lines:fast"});
  ExpectBadInput({"bench", sequence, "--threads", "0"}, {"--threads 0", "1 or more"});
  ExpectBadInput({"bench", sequence, "--warm-up", "-1"}, {"--warm-up -1"});
  ExpectBadInput({"bench", sequence, sequence, "--warm-up", "1", "--objects", "2"},
                 {"second sequence", "tiny"});
  ExpectBadInput({"bench", sequence}, {"2 frames", "warm-up of 5"});
  ExpectBadInput({"bench", sequence, "--frames", "1"}, {"1 frames", "object"});
  ExpectBadInput({"bench", "--tables", "micro,memory"}, {"SEQUENCE", "--tables micro", "--tables retrieval"});
  ExpectBadInput({"bench", "--tables", "retrieval", "--retrieval-sizes", "10,ten"},
                 {"--retrieval-sizes", "'ten'"});
  ExpectBadInput({"bench", "--tables", "micro", "--micro", "matchng"}, {"matchng", "matching"});
  ExpectBadInput({"bench", sequence, "--warm-up", "1"}, {"exactly 3 objects", "there are: 2", "--objects"});
  ExpectBadInput({"bench", sequence, "--format", "excel"}, {"excel"});
  folder.Write("kept/notes.txt", "mine");
  ExpectBadInput({"bench", "--tables", "micro", "--out", folder / "kept"},
                 {"kept", "not a finished benchmark"});
}

}  // namespace
}  // namespace armature
