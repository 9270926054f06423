// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "bench/sections/section_plots.h"
#include "support/temp_folder.h"

namespace armature {
namespace {

using testing::ReadFile;
using testing::TempFolder;

NamedSpan StageSpan(const std::string& contender, const std::string& stage, double median) {
  NamedSpan span{"comparison", "den", contender, stage, {}};
  span.milliseconds.median = median;
  return span;
}

BenchSeries SeriesNamed(const std::string& contender, double first) {
  BenchSeries series{.contender = contender, .x_label = "how many", .y_label = "how long [ms]"};
  for (const double x : {1.0, 2.0, 20.0}) {
    SpanStatistics ms;
    ms.median = first * x;
    ms.p10 = 0.9 * ms.median;
    ms.p90 = 1.2 * ms.median;
    series.points.push_back({x, ms});
  }
  series.fit = LineFit{0, first};
  return series;
}

void ExpectTexts(const std::filesystem::path& svg, const std::vector<std::string>& texts) {
  const std::string content = ReadFile(svg);
  EXPECT_NE(content.find("<svg"), std::string::npos) << svg;
  for (const std::string& text : texts) EXPECT_NE(content.find(text), std::string::npos) << text;
}

TEST(SectionPlots, ComparisonHasBarsOfEnginesAndOfThePaper) {
  const TempFolder folder;
  BenchSection section{.name = "comparison", .sequence = "den"};
  section.spans = {StageSpan("lines:default", "detection", 4), StageSpan("lines:default", "total", 9),
                   StageSpan("keypoints:published", "detection", 570)};
  WriteSectionPlots(section, 2, folder.path());
  ExpectTexts(folder / "comparison-den.svg",
              {"lines:default", "keypoints:published", "paper: lines", "4.0 ms", "240.2 ms", "2 objects"});
}

TEST(SectionPlots, ObjectsHaveACurveAnEngineAndThePapers) {
  const TempFolder folder;
  BenchSection section{.name = "objects", .sequence = "den"};
  section.series = {SeriesNamed("lines:default", 8), SeriesNamed("keypoints:wait", 285)};
  WriteSectionPlots(section, 3, folder.path());
  ExpectTexts(folder / "objects-den.svg",
              {"lines:default", "keypoints:wait", "paper: lines", "paper: keypoints", "how long [ms]"});
}

TEST(SectionPlots, ScalingHasAPictureALoad) {
  const TempFolder folder;
  BenchSection section{.name = "scaling", .sequence = "den"};
  section.series = {SeriesNamed("image size", 3), SeriesNamed("segments", 1)};
  WriteSectionPlots(section, 3, folder.path());
  ExpectTexts(folder / "scaling-image-size-den.svg", {"image size", "how many"});
  ExpectTexts(folder / "scaling-segments-den.svg", {"segments"});
}

TEST(SectionPlots, RetrievalHasACurveAnIndexWithItsRecall) {
  const TempFolder folder;
  BenchSection section{.name = "retrieval", .sequence = ""};
  section.series = {SeriesNamed("kdtree_single", 0.01), SeriesNamed("kmeans:32", 0.001)};
  section.series[1].remark = " (0.51)";
  WriteSectionPlots(section, 3, folder.path());
  ExpectTexts(folder / "retrieval.svg", {"kdtree_single", "kmeans:32 (0.51)", "how many", "how long [ms]"});
}

TEST(SectionPlots, OtherSectionsHaveNone) {
  const TempFolder folder;
  WriteSectionPlots({.name = "micro", .sequence = ""}, 3, folder.path());
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  EXPECT_FALSE(IsDrawnTable("micro"));
}

}  // namespace
}  // namespace armature
