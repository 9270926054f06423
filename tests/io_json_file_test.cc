// SPDX-License-Identifier: BSD-3-Clause
// JSON of others: what is wrong with it is told with the file and the key.
#include <gtest/gtest.h>

#include "io/bench_record.h"
#include "io/json_fields.h"
#include "io/json_file.h"
#include "io/run_folder.h"
#include "io/run_results.h"
#include "support/expect_input_error.h"
#include "support/temp_folder.h"

namespace armature {
namespace {

using Json = nlohmann::ordered_json;
using testing::ExpectInputError;

TEST(JsonFile, WhatIsNoJsonOrTooDeepIsRefused) {
  const testing::TempFolder folder;
  const auto refuse = [&](const std::string& content, const std::string& why) {
    const auto file = folder.Write("a.json", content);
    ExpectInputError([&] { ReadJsonObject(file, "make it again"); }, {"a.json", why, "make it again"});
    EXPECT_FALSE(FindJsonObject(file));
  };
  refuse("", "not JSON");
  refuse("{\"a\": 1", "not JSON");
  refuse("[1]", "no JSON object");
  refuse("{\"a\": " + std::string(1'000'000, '['), "levels deep");
  refuse("{\"a\": 1e999}", "too large");
  EXPECT_FALSE(FindJsonObject(folder / "none.json"));
  EXPECT_EQ(ReadJson(folder.Write("a.json", "[1]"), ""), Json::array({1}));
}

TEST(JsonFields, AreTakenByTheirTypeAlone) {
  const Json json =
      Json::parse(R"({"n": -1, "big": 1e30, "text": "a", "yes": true, "list": ["a", 1], "none": null,
                                    "huge": 18446744073709551615})");
  EXPECT_EQ(JsonField<int>(json, "n"), -1);
  EXPECT_EQ(JsonField<double>(json, "n"), -1);
  EXPECT_EQ(JsonField<std::string>(json, "text"), "a");
  EXPECT_EQ(JsonField<std::optional<int>>(json, "none"), std::nullopt);
  EXPECT_EQ(JsonFieldOr(json, "absent", 3), 3);
  ExpectInputError([&] { JsonField<size_t>(json, "n"); }, {"'n'", "a count", "'-1'"});
  ExpectInputError([&] { JsonField<int>(json, "big"); }, {"'big'", "a whole number"});
  ExpectInputError([&] { JsonField<int>(json, "huge"); }, {"'huge'", "a whole number"});
  ExpectInputError([&] { JsonField<double>(json, "yes"); }, {"'yes'", "a number", "'true'"});
  ExpectInputError([&] { JsonField<double>(json, "none"); }, {"'none'", "a number"});
  ExpectInputError([&] { JsonField<std::vector<std::string>>(json, "list"); }, {"'list'[1]", "a text"});
  ExpectInputError([&] { JsonField<int>(json, "absent"); }, {"'absent'", "missing"});
  ExpectInputError([&] { JsonField<int>(json["list"], "n"); }, {"'n'", "object"});
  ExpectInputError([&] { JsonFieldOr(json, "text", 3); }, {"'text'", "a whole number"});
  ExpectInputError([&] { JsonObject(json, "list"); }, {"'list'", "an object"});
}

TEST(JsonFiles, OfRunsAndBenchmarksNameFileAndKey) {
  const testing::TempFolder folder;
  folder.Write("summary.json", R"({"complete": true, "sequence": ["den"]})");
  EXPECT_TRUE(IsCompleteRun(folder.path()));
  ExpectInputError([&] { IdentifyRun(folder.path()); },
                   {"summary.json", "'sequence'", "a text", "run` again"});
  for (const char* not_complete : {R"({"complete": 1})", R"(["complete"])", R"({"complete": "true"})", "{"}) {
    folder.Write("summary.json", not_complete);
    EXPECT_FALSE(IsCompleteRun(folder.path())) << not_complete;
  }
  const auto bench = folder.Write("bench.json", R"({"schema": 1, "environment": {"cpu": 3}})");
  ExpectInputError([&] { ReadBenchRecord(bench); }, {"bench.json", "'cpu'", "a text", "armature bench"});
}

}  // namespace
}  // namespace armature
