// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/bench_record.h"
#include "support/expect_input_error.h"
#include "support/temp_folder.h"

namespace armature {
namespace {

BenchRecord JsonRecord() {
  BenchRecord record;
  record.cpu = "Processor \"X\"";
  record.calibration = ComputeStatistics({5.1, 5.2, 5.4}).value();
  record.spans = {{"comparison", "seq1", "lines:default", "total", ComputeStatistics({1.0 / 3, 0.7}).value()},
                  {"micro", "", "neighbours:10000", "call", ComputeStatistics({0.009}).value()}};
  return record;
}

nlohmann::ordered_json JsonOfRecord() {
  nlohmann::ordered_json json;
  AddBenchRecord(JsonRecord(), json);
  return json;
}

class SpanJson : public ::testing::Test {
 protected:
  void ExpectRefused(const std::string& text, const std::vector<std::string>& parts) {
    const auto file = folder_.Write("bench.json", text);
    testing::ExpectInputError([&] { ReadBenchRecord(file); }, parts);
  }

  testing::TempFolder folder_;
};

TEST_F(SpanJson, ReadsBackEveryDigit) {
  const BenchRecord written = JsonRecord();
  const BenchRecord read = ReadBenchRecord(folder_.Write("bench.json", JsonOfRecord().dump(2)));
  EXPECT_EQ(read.cpu, written.cpu);
  EXPECT_EQ(read.calibration.median, written.calibration.median);
  ASSERT_EQ(read.spans.size(), 2U);
  for (size_t i = 0; i < 2; ++i) {
    const SpanStatistics &a = read.spans[i].milliseconds, &b = written.spans[i].milliseconds;
    EXPECT_EQ(read.spans[i].Key(), written.spans[i].Key());
    EXPECT_EQ(a.n, b.n);
    EXPECT_EQ(a.mean, b.mean);
    EXPECT_EQ(a.deviation, b.deviation);
    EXPECT_EQ(a.median, b.median);
    EXPECT_EQ(a.p10, b.p10);
    EXPECT_EQ(a.p90, b.p90);
    EXPECT_EQ(a.p99, b.p99);
    EXPECT_EQ(a.max, b.max);
    EXPECT_EQ(a.median_low, b.median_low);
    EXPECT_EQ(a.median_high, b.median_high);
  }
}

TEST_F(SpanJson, KeepsWhatElseTheObjectHolds) {
  nlohmann::ordered_json json = {{"program", "armature bench"}, {"environment", {{"cores", 2}}}};
  AddBenchRecord(JsonRecord(), json);
  EXPECT_EQ(json["program"], "armature bench");
  EXPECT_EQ(json["environment"]["cores"], 2);
  EXPECT_EQ(ReadBenchRecord(folder_.Write("bench.json", json.dump())).spans.size(), 2U);
}

TEST_F(SpanJson, RefusesAnAbsentFile) {
  testing::ExpectInputError([&] { ReadBenchRecord(folder_ / "absent.json"); }, {"absent.json"});
}

TEST_F(SpanJson, RefusesWhatIsNotJson) {
  ExpectRefused("{\"schema\": 1,", {"bench.json", "not JSON", "armature bench"});
}

TEST_F(SpanJson, RefusesAnotherSchema) {
  auto json = JsonOfRecord();
  json["schema"] = 2;
  ExpectRefused(json.dump(), {"bench.json", "schema '2', not 1", "armature bench"});
  ExpectRefused("{}", {"bench.json", "no 'schema'"});
  ExpectRefused("[1]", {"bench.json", "no 'schema'"});
}

TEST_F(SpanJson, RefusesNoSpans) {
  auto json = JsonOfRecord();
  json["spans"].clear();
  ExpectRefused(json.dump(), {"bench.json", "no spans", "armature bench"});
}

TEST_F(SpanJson, RefusesMissingAndMistypedMembers) {
  auto json = JsonOfRecord();
  json["spans"][0].erase("p90");
  ExpectRefused(json.dump(), {"bench.json", "p90"});
  json = JsonOfRecord();
  json["spans"][0]["median"] = "fast";
  ExpectRefused(json.dump(), {"bench.json", "'median' has to be a number"});
  json = JsonOfRecord();
  json["spans"] = 3;
  ExpectRefused(json.dump(), {"bench.json", "'spans' has to be there, as a list"});
}

TEST_F(SpanJson, RefusesWhatCannotBeDividedBy) {
  auto json = JsonOfRecord();
  json["calibration_ms"]["median"] = 0;
  ExpectRefused(json.dump(), {"bench.json", "calibration's median"});
  json = JsonOfRecord();
  json["spans"][0]["median"] = -1;
  ExpectRefused(json.dump(), {"bench.json", "comparison/seq1/lines:default/total"});
}

TEST_F(SpanJson, RefusesASpanThatIsThereTwice) {
  auto json = JsonOfRecord();
  json["spans"].push_back(json["spans"][1]);
  ExpectRefused(json.dump(), {"bench.json", "micro//neighbours:10000/call", "twice"});
}

}  // namespace
}  // namespace armature
