// SPDX-License-Identifier: BSD-3-Clause
// `armature bench --against` as its users start it. No test asserts a time: references are spoilt instead.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/program.h"

namespace armature {
namespace {

using testing::ExpectBadInput;
using testing::ReadFile;
using testing::RunOk;
using testing::RunProgram;
using testing::TempFolder;
using Json = nlohmann::ordered_json;

class BenchAgainst : public ::testing::Test {
 protected:
  // One reference for all: of one micro-benchmark.
  static void SetUpTestSuite() {
    const TempFolder folder;
    RunOk({"bench", "--tables", "micro", "--micro", "matching:chair", "--out", folder / "out"});
    reference_ = Json::parse(ReadFile(folder / "out/bench.json"));
  }

  std::string Written(const Json& json) const { return folder_.Write("bench.json", json.dump()); }

  // All its times so many times as long.
  static Json Scaled(double factor) {
    Json json = reference_;
    for (const char* name :
         {"mean", "std", "median", "p10", "p90", "p99", "max", "median_low", "median_high"})
      json["spans"][0][name] = factor * json["spans"][0][name].get<double>();
    return json;
  }

  static inline Json reference_;
  TempFolder folder_;
};

TEST_F(BenchAgainst, MeasuresTheSameAgainWithTheReferenceAlone) {
  const auto result = RunProgram({"bench", "--against", Written(reference_), "--out", folder_ / "again"});
  EXPECT_TRUE(result.status == 0 || result.status == 1) << result.err;
  EXPECT_NE(result.out.find("Against the reference: "), std::string::npos) << result.out;
  const Json again = Json::parse(ReadFile(folder_ / "again/bench.json"));
  EXPECT_EQ(again["settings"], reference_["settings"]);
  ASSERT_EQ(again["tables"].size(), 2u);
  ASSERT_EQ(again["tables"][1]["rows"].size(), 1u);
  EXPECT_EQ(again["tables"][1]["rows"][0]["span"], "micro//matching:chair/call");
  EXPECT_EQ(again["spans"].size(), 2u);  // and the calibration
}

TEST_F(BenchAgainst, FailsWhenSomethingBecameSlower) {
  const auto result = RunProgram({"bench", "--against", Written(Scaled(1e-3))});
  EXPECT_EQ(result.status, 1) << result.err;
  EXPECT_NE(result.out.find("Against the reference: 1 slower"), std::string::npos) << result.out;
}

TEST_F(BenchAgainst, SucceedsWhenEverythingBecameFaster) {
  const auto result = RunOk({"bench", "--against", Written(Scaled(1e3))});
  EXPECT_NE(result.out.find("Against the reference: 0 slower, 1 faster"), std::string::npos) << result.out;
}

TEST_F(BenchAgainst, TheCommandLineGoesBeforeTheReference) {
  const auto result =
      RunProgram({"bench", "--against", Written(Scaled(1e3)), "--micro", "matching:chair,matching:table"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("1 faster, 0 same, 0 too few, 0 missing, 1 new"), std::string::npos)
      << result.out;
}

TEST_F(BenchAgainst, BadInput) {
  ExpectBadInput({"bench", "--against", folder_ / "absent.json"}, {"absent.json"});
  Json json = reference_;
  json.erase("settings");
  ExpectBadInput({"bench", "--against", Written(json)}, {"bench.json", "'sequences'", "give SEQUENCE"});
  json["settings"] = reference_["settings"];
  json["settings"]["frames"] = "many";
  ExpectBadInput({"bench", "--against", Written(json)}, {"'frames'", "give --frames"});
  json["settings"] = reference_["settings"];
  json["settings"]["frames"] = "many";
  json["settings"].erase("retrieval_sizes");  // the reference is older than this: its default
  ExpectBadInput({"bench", "--against", Written(json)}, {"'frames'", "give --frames"});
  json["settings"] = reference_["settings"];
  json["settings"]["sequences"] = {"absent/den"};
  ExpectBadInput({"bench", "--against", Written(json)}, {"'absent/den' is not here", "scripts/run.sh"});
  json["settings"] = reference_["settings"];
  json["spans"].erase(1);  // the calibration of the table
  json["spans"][0]["table"] = "comparison";
  json["spans"][0]["sequence"] = "seq1";
  ExpectBadInput({"bench", "--against", Written(json)}, {"nothing of the reference", "comparison of seq1"});
}

}  // namespace
}  // namespace armature
