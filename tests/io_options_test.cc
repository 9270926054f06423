// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "base/nearest_name.h"
#include "io/option_value.h"
#include "io/options_yaml.h"
#include "support/expect_input_error.h"
#include "support/temp_folder.h"

namespace armature {
namespace {

using testing::ExpectInputError;

enum class Detector { kLsd, kEdLines, kFld };

}  // namespace

template <>
struct EnumNames<Detector> {
  static constexpr NamedValue<Detector> kTable[] = {
      {Detector::kLsd, "lsd"}, {Detector::kEdLines, "edlines"}, {Detector::kFld, "fld"}};
};

namespace {

struct SampleOptions {
  int seed = 1;
  double max_angle = 10;
  Detector detector = Detector::kLsd;
  bool visibility = true;
  double weight = 0.1;
};

std::vector<OptionEntry> SampleTable(SampleOptions& o) {
  return {
      Option("seed", &o.seed, "of all random choices", 0),
      Option("association.max_angle_deg", &o.max_angle, "between edge and segment, degrees", 0, 90),
      Option("association.detector", &o.detector, "of line segments"),
      Option("association.cost.visibility", &o.visibility, "hide edges behind faces"),
      Option("resection.weight", &o.weight, "of the shape prior"),
  };
}

class OptionsTest : public ::testing::Test {
 protected:
  void ExpectYamlError(const std::string& yaml, const std::vector<std::string>& texts) {
    const auto file = folder_.Write("config.yaml", yaml);
    ExpectInputError([&] { ApplyYaml(file, table_); }, texts);
  }
  void ExpectSettingError(const std::string& setting, const std::vector<std::string>& texts) {
    ExpectInputError([&] { ApplySetting(setting, table_); }, texts);
  }

  SampleOptions options_;
  std::vector<OptionEntry> table_ = SampleTable(options_);
  testing::TempFolder folder_;
};

TEST_F(OptionsTest, YamlIsPartial) {
  ApplyYaml(folder_.Write("c.yaml", "association:\n  detector: edlines\n  cost: {visibility: false}\n"),
            table_);
  EXPECT_EQ(options_.detector, Detector::kEdLines);
  EXPECT_FALSE(options_.visibility);
  EXPECT_EQ(options_.max_angle, 10);
  ApplyYaml(folder_.Write("empty.yaml", "# nothing\n"), table_);
  EXPECT_EQ(options_.detector, Detector::kEdLines);
}

TEST_F(OptionsTest, YamlNamesTheNearestOfAnUnknownKey) {
  ExpectYamlError("seed: 2\nassociation:\n  detectr: lsd\n",
                  {"config.yaml:3", "'association.detectr'", "'association.detector'"});
  ExpectYamlError("asociation:\n  detector: lsd\n", {"config.yaml:1", "'asociation'"});
}

TEST_F(OptionsTest, YamlReportsTypesAndRanges) {
  ExpectYamlError("association:\n  max_angle_deg: 95\n",
                  {"config.yaml:2", "association.max_angle_deg 95 > 90"});
  ExpectYamlError("seed: -1\n", {"config.yaml:1", "seed -1 < 0", ">= 0"});
  ExpectYamlError("seed: 1.5\n", {"config.yaml:1", "seed", "whole"});
  ExpectYamlError("seed: many\n", {"config.yaml:1", "seed", "'many'"});
  ExpectYamlError("seed: [1]\n", {"config.yaml:1", "single value"});
  ExpectYamlError("seed:\n", {"config.yaml:1", "single value"});
  ExpectYamlError("association: 3\n", {"config.yaml:1", "map"});
  ExpectYamlError("association:\n  detector: [lsd]\n", {"config.yaml:2", "single value"});
  ExpectYamlError("association:\n  detector: lds\n", {"config.yaml:2", "'lds'", "'lsd'", "edlines"});
  ExpectYamlError("association:\n  cost:\n    visibility: 7\n", {"config.yaml:3", "true"});
  ExpectYamlError("seed: 1\nseed: 2\n", {"config.yaml:2", "twice"});
  ExpectYamlError("seed: {\n", {"config.yaml:", "not valid YAML"});
}

TEST_F(OptionsTest, BadValuesLeaveTheFieldAsItWas) {
  ExpectSettingError("association.max_angle_deg=95", {"95 > 90"});
  EXPECT_EQ(options_.max_angle, 10);
  ExpectSettingError("association.detector=edlinse", {"'edlinse'", "did you mean 'edlines'?"});
  EXPECT_EQ(options_.detector, Detector::kLsd);
}

TEST_F(OptionsTest, SettingsAreCheckedAsYaml) {
  ApplySetting("association.max_angle_deg=20", table_);
  EXPECT_EQ(options_.max_angle, 20);
  ApplySetting("association.detector = fld", table_);
  EXPECT_EQ(options_.detector, Detector::kFld);
  ExpectSettingError("association.max_angle_deg=-1", {"--set", "association.max_angle_deg -1 < 0"});
  ExpectSettingError("association.detector=hough", {"--set", "'hough'", "edlines"});
  ExpectSettingError("seed", {"--set", "key=value"});
  ExpectSettingError("max_angle_deg=3", {"--set", "'association.max_angle_deg'"});
}

TEST_F(OptionsTest, CheckFindsValuesSetInCode) {
  CheckOptions(table_);
  options_.max_angle = 95;
  ExpectInputError([&] { CheckOptions(table_); }, {"association.max_angle_deg 95 > 90"});
  options_.max_angle = std::nan("");
  ExpectInputError([&] { CheckOptions(table_); }, {"max_angle_deg", "finite"});
}

TEST_F(OptionsTest, EffectiveYamlIsNestedAndStable) {
  EXPECT_EQ(EffectiveYaml(table_),
            "seed: 1\nassociation:\n  max_angle_deg: 10\n  detector: lsd\n  cost:\n    visibility: true\n"
            "resection:\n  weight: 0.1\n");
}

TEST_F(OptionsTest, EffectiveYamlRestoresTheSameValues) {
  options_.max_angle = std::nextafter(10.0, 11.0);
  options_.weight = 1.0 / 3.0 * 1e-9;
  options_.detector = Detector::kFld;
  const auto file = folder_.Write("c.yaml", EffectiveYaml(table_));
  SampleOptions restored;
  const std::vector<OptionEntry> table = SampleTable(restored);
  ApplyYaml(file, table);
  EXPECT_EQ(restored.max_angle, options_.max_angle);
  EXPECT_EQ(restored.weight, options_.weight);
  EXPECT_EQ(restored.detector, options_.detector);
  EXPECT_EQ(EffectiveYaml(table), EffectiveYaml(table_));
}

TEST_F(OptionsTest, DomainsNameRangesAndChoices) {
  EXPECT_EQ(OptionDomain(table_[0]), ">= 0");
  EXPECT_EQ(OptionDomain(table_[1]), "0..90");
  EXPECT_EQ(OptionDomain(table_[2]), "lsd|edlines|fld");
  EXPECT_EQ(OptionDomain(table_[3]), "true|false");
  EXPECT_EQ(OptionDomain(table_[4]), "number");
}

TEST(EnumNames, NamesAndValuesBelongTogether) {
  EXPECT_STREQ(ToName(Detector::kEdLines), "edlines");
  EXPECT_EQ(FromName<Detector>("fld"), Detector::kFld);
  EXPECT_FALSE(FromName<Detector>("FLD"));
  EXPECT_EQ(ListNames<Detector>(), (std::vector<std::string>{"lsd", "edlines", "fld"}));
}

TEST(NearestName, CountsEdits) {
  EXPECT_EQ(EditDistance("", "abc"), 3);
  EXPECT_EQ(EditDistance("kitten", "sitting"), 3);
  EXPECT_EQ(EditDistance("lds", "lsd"), 1);
  EXPECT_EQ(NearestName("tabel", {"chair", "table"}), "table");
  EXPECT_EQ(NearestName("x", {}), "");
  EXPECT_EQ(NearestName("association.detector", {"association.rounds", "lines.detector"}), "lines.detector");
  EXPECT_EQ(NearestName("trakcs.enabled", {"floor.enabled", "tracks.enabled"}), "tracks.enabled");
}

}  // namespace
}  // namespace armature
