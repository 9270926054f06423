// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "drawing/plots/gnuplot.h"
#include "drawing/plots/plot.h"
#include "drawing/plots/stacked_bars.h"
#include "drawing/plots/strips.h"
#include "support/expect_input_error.h"
#include "support/path_override.h"
#include "support/temp_folder.h"

namespace armature {
namespace {

using testing::PathOverride;
using testing::ReadFile;

Plot SamplePlot() {
  Plot plot;
  plot.title = "Time <ours> & 'theirs' @home";
  plot.x_label = "objects_{n}";
  plot.y_label = "ms";
  plot.log_y = true;
  plot.series = {{"lines", PlotSeries::Style::kLine, {1, 2, 4}, {8, 9, 12}, {7, 8, 10}, {9, 10, 15}, {}},
                 {"baseline", PlotSeries::Style::kPoints, {1, 2, 4}, {285, 570, 1140}, {}, {}, {}},
                 {"fit", PlotSeries::Style::kFitted, {1, 4}, {285, 1140}, {}, {}, 1}};
  return plot;
}

StackedBars SampleBars() {
  StackedBars bars;
  bars.title = "A frame with three objects";
  bars.stages = {"detection", "association"};
  bars.bars = {{"lines", {5, 3.3}}, {"keypoints", {855, 0}}};
  return bars;
}

size_t CountIn(const std::string& text, const std::string& part) {
  size_t count = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(Strips, HaveAPointAValueThatIsAboveZero) {
  const Strips strips{
      "Errors <of> rooms", "metres", {{"default", {0.1, 0.2, 0.4, 0}}, {"no_floor", {0.3, -1}}}};
  const std::string svg = DrawSvg(strips);
  EXPECT_EQ(CountIn(svg, "<use xlink:href='#gpPt6'"), 4U) << svg;
  for (const char* text : {"Errors &lt;of> rooms", "metres", "default", "no_floor"})
    EXPECT_NE(svg.find(text), std::string::npos) << text;
}

TEST(Strips, KeepTheNameOfOneWithoutValues) {
  const std::string svg = DrawSvg(Strips{"t", "m", {{"default", {0.1}}, {"none_found", {}}}});
  EXPECT_NE(svg.find("none_found"), std::string::npos);
  EXPECT_THROW(DrawSvg(Strips{"t", "m", {{"none_found", {0}}}}), std::logic_error);
}

TEST(Plot, WritesWhatItIsToldLiterally) {
  const testing::TempFolder folder;
  WriteSvg(SamplePlot(), folder / "plot.svg");
  const std::string svg = ReadFile(folder / "plot.svg");
  EXPECT_TRUE(svg.starts_with("<?xml"));
  EXPECT_NE(svg.find("width=\"900\" height=\"560\""), std::string::npos);
  EXPECT_NE(svg.find("Time &lt;ours> &amp; 'theirs' @home"), std::string::npos);
  for (const char* text : {"objects_{n}", ">lines<", ">baseline<", ">fit<"}) {
    EXPECT_NE(svg.find(text), std::string::npos) << text;
  }
  EXPECT_EQ(svg.substr(svg.size() - 9), "\n</svg>\n\n");
}

TEST(Plot, GivesTheSameBytesTwice) {
  const testing::TempFolder folder;
  WriteSvg(SamplePlot(), folder / "a.svg");
  WriteSvg(SamplePlot(), folder / "b.svg");
  EXPECT_EQ(ReadFile(folder / "a.svg"), ReadFile(folder / "b.svg"));
}

TEST(Plot, LeavesOutWhatALogarithmCannotShow) {
  const testing::TempFolder folder;
  Plot plot = SamplePlot();
  plot.series[0].y[1] = 0;
  plot.series[1].y[1] = std::nan("");
  WriteSvg(plot, folder / "plot.svg");
  EXPECT_NE(ReadFile(folder / "plot.svg").find(">lines<"), std::string::npos);
}

TEST(Plot, RefusesColumnsOfDifferentLengthsAndNothing) {
  Plot plot = SamplePlot();
  plot.series[1].x.pop_back();
  EXPECT_THROW(WriteSvg(plot, "never.svg"), std::logic_error);
  EXPECT_THROW(WriteSvg(Plot{}, "never.svg"), std::logic_error);
}

TEST(Plot, AsksForGnuplotWhereThereIsNone) {
  const testing::TempFolder folder;
  const PathOverride nowhere(folder.path());
  testing::ExpectInputError([&] { WriteSvg(SamplePlot(), folder / "plot.svg"); },
                            {"gnuplot", "apt-get install gnuplot-nox"});
  testing::ExpectInputError([] { CheckGnuplot(); }, {"gnuplot", "--no-plots"});
  EXPECT_FALSE(std::filesystem::exists(folder / "plot.svg"));
}

TEST(Plot, ReportsAFolderThatIsNotThere) {
  const testing::TempFolder folder;
  testing::ExpectInputError([&] { WriteSvg(SamplePlot(), folder / "absent" / "plot.svg"); },
                            {"absent/plot.svg", "cannot write"});
}

TEST(Gnuplot, ReportsAScriptThatFailsAndKeepsNoHalfPicture) {
  const testing::TempFolder folder;
  testing::ExpectInputError([&] { RunGnuplot("set no such thing\n", folder / "plot.svg"); },
                            {"plot.svg", "gnuplot failed"});
  EXPECT_FALSE(std::filesystem::exists(folder / "plot.svg"));
}

TEST(Gnuplot, QuotesAnyText) {
  EXPECT_EQ(GnuplotText("it's\n\"x\" \\n $1"), "'it''s \"x\" \\n $1'");
  EXPECT_EQ(GnuplotNumber(0.1), "0.1");
  EXPECT_EQ(GnuplotNumber(INFINITY), "NaN");
}

TEST(StackedBars, ShowsTotalsAndEnlargesSmallBars) {
  const testing::TempFolder folder;
  WriteSvg(SampleBars(), folder / "bars.svg");
  WriteSvg(SampleBars(), folder / "again.svg");
  const std::string svg = ReadFile(folder / "bars.svg");
  EXPECT_EQ(svg, ReadFile(folder / "again.svg"));
  for (const char* text : {"A frame with three objects", "the same up to 10.4 ms", ">8.3 ms<", ">855.0 ms<",
                           ">detection<", ">association<", ">keypoints<"}) {
    EXPECT_NE(svg.find(text), std::string::npos) << text;
  }
}

TEST(StackedBars, ShowsBarsOfOneSizeOnce) {
  const testing::TempFolder folder;
  StackedBars bars = SampleBars();
  bars.bars[1].parts[0] = 20;
  WriteSvg(bars, folder / "bars.svg");
  EXPECT_EQ(ReadFile(folder / "bars.svg").find("the same up to"), std::string::npos);
}

TEST(StackedBars, RefusesBarsWithoutTheirStagesAndNothing) {
  StackedBars bars = SampleBars();
  bars.bars[0].parts.pop_back();
  EXPECT_THROW(WriteSvg(bars, "never.svg"), std::logic_error);
  EXPECT_THROW(WriteSvg(StackedBars{}, "never.svg"), std::logic_error);
}

}  // namespace
}  // namespace armature
