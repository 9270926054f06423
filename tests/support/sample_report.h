// SPDX-License-Identifier: BSD-3-Clause
// A made-up report with something in every part.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>

#include "eval/report/report_data.h"
#include "eval/report/report_plots.h"

namespace armature::testing {

// A picture of one colour with a text in it.
inline ReportPicture SamplePicture(const std::string& text, const std::string& colour) {
  return {"image/svg+xml",
          fmt::format("<svg xmlns='http://www.w3.org/2000/svg' width='856' height='480'>"
                      "<rect width='856' height='480' fill='{}'/>"
                      "<text x='40' y='260' font-size='60'>{}</text></svg>",
                      colour, text),
          text};
}

inline ReportTable SampleObjectTable(const std::string& sequence) {
  const auto row = [](const std::string& approach, const std::string& category, double best, double average) {
    return std::vector<Cell>{TextCell(approach), TextCell(category), CountCell(7), NumberCell(best, 4),
                             NumberCell(average, 4)};
  };
  Table table{
      sequence + ": objects of the map",
      {"approach", "category", "found", "best [m]", "average [m]"},
      {row("odometry only", "chair", 0.0431, 0.1122), row("default", "chair", 0.0284, 0.0492),
       row("default", "laptop", 0.1001, 0.1001)},
      {"found: matched one-to-one within its category by the distance of the centres, at most 1 m.",
       "best, average: distance of the centres of the boxes, of the found ones alone. Each map is moved to "
       "the truth as its cameras are, by the first pose, at scale 1 unless told below."},
      "objects",
      sequence};
  table.rows.push_back({TextCell("no normal term"), TextCell("table"), NoCell(), NoCell(), NoCell()});
  return {ReportSection::kAccuracy, table};
}

inline ReportTable SampleTimingTable() {
  return {ReportSection::kTiming,
          {"seq1: median of each stage",
           {"stage", "lines [ms]", "keypoints [ms]"},
           {{TextCell("detection"), NumberCell(4.153, 3), NumberCell(855, 1)},
            {TextCell("resection"), NumberCell(0.412, 3), NoCell()}},
           {"detection: from the image in memory to segments."}}};
}

inline std::array<Eigen::Vector2d, 4> SquareAround(double x, double y) {
  return {Eigen::Vector2d(x - 0.3, y - 0.25), Eigen::Vector2d(x + 0.3, y - 0.25),
          Eigen::Vector2d(x + 0.3, y + 0.25), Eigen::Vector2d(x - 0.3, y + 0.25)};
}

// Three objects and a path, all moved by `shift` in x; errors are told for estimates (shift > 0) of the first
// two.
inline MapLayer SampleLayer(const std::string& name, double shift) {
  MapLayer layer{name, {}, {}};
  for (int i = 0; i <= 40; ++i) {
    const double angle = 0.05 * i;
    layer.trajectory.emplace_back(2.2 * std::cos(angle) + shift, 2.2 * std::sin(angle));
  }
  const auto error = [shift](bool told) { return shift > 0 && told ? std::optional(shift) : std::nullopt; };
  layer.objects.push_back({"chair0", "chair", SquareAround(shift, 0), {1, 0}, error(true)});
  layer.objects.push_back({"table0", "table", SquareAround(1 + shift, -1), {0, 1}, error(true)});
  layer.objects.push_back({"laptop0", "laptop", SquareAround(-1 + shift, 0.5), {0, 1}, error(false)});
  return layer;
}

// The twelve edges of a box of 0.6 m that stands on y = 0.
inline std::vector<SceneView::Line> BoxEdges(double x, double z) {
  std::vector<SceneView::Line> edges;
  for (int a = 0; a < 8; ++a) {
    for (const int bit : {1, 2, 4}) {
      const auto corner = [&](int i) {
        return Eigen::Vector3d(x + (i & 1 ? 0.3 : -0.3), i & 2 ? 0.6 : 0.0, z + (i & 4 ? 0.3 : -0.3));
      };
      if ((a & bit) == 0) edges.emplace_back(corner(a), corner(a | bit));
    }
  }
  return edges;
}

inline SceneView SampleScene(const std::string& sequence) {
  SceneView scene{sequence, "default", {0, 1, 0}, {}, {}, {}, {}};
  for (int i = 0; i <= 20; ++i) {
    const Eigen::Vector3d at(2 * std::cos(0.1 * i), 1.2, 2 * std::sin(0.1 * i));
    scene.path.push_back(at);
    scene.true_path.emplace_back(at + Eigen::Vector3d(0.05, 0, 0));
    const auto corner = [&](double x, double y) -> Eigen::Vector3d {
      return 0.9 * at + Eigen::Vector3d(x, y, 0);
    };
    if (i % 5 == 0) {
      scene.cameras.push_back(
          {at, corner(-0.1, -0.1), corner(0.1, -0.1), corner(0.1, 0.1), corner(-0.1, 0.1)});
    }
  }
  TriangleMesh cad;
  cad.vertices.resize(3, 4);
  cad.vertices << -0.3, 0.3, 0.3, -0.3, 0.3, 0.3, 0.3, 0.3, -0.3, -0.3, 0.3, 0.3;
  cad.triangles.resize(3, 2);
  cad.triangles << 0, 0, 1, 2, 2, 3;
  scene.objects.push_back({"chair0", "chair", "chair-0001", BoxEdges(0, 0), BoxEdges(0.05, 0), cad});
  scene.objects.push_back({"table0", "table", "", BoxEdges(1, -1), {}, {}});
  return scene;
}

inline RetrievalStrip SampleStrip(const std::string& object) {
  RetrievalStrip strip{"seq1", "default", object, SamplePicture(object, "#dde6ee"), "chair-0002", {}};
  for (int i = 1; i <= 5; ++i) {
    const std::string name = fmt::format("chair-000{}", i);
    strip.models.push_back({name, fmt::format("cost {}.80, distance 5.92", i), i == 2,
                            i < 5 ? std::optional(SamplePicture(name, "#eeeeee")) : std::nullopt});
  }
  return strip;
}

inline std::vector<StageBars> SampleStages() {
  StackedBars bars;
  bars.stages = {"detection", "association", "resection"};
  bars.bars = {{"lines:default", {4.153, 0.61, 0.41}},
               {"lines:fast", {0.841, 0.33, 0.25}},
               {"keypoints", {855, 0, 3.4}}};
  return {{"seq1", bars}};
}

inline std::vector<TimeCurves> SampleCurves() {
  Plot plot{.title = "",
            .x_label = "objects in the frame",
            .y_label = "front end [ms]",
            .log_y = true,
            .series = {}};
  plot.series = {{.name = "lines",
                  .x = {1, 2, 3},
                  .y = {4.2, 4.6, 5.1},
                  .low = {4.0, 4.3, 4.8},
                  .high = {4.9, 5.2, 6.0}},
                 {.name = "keypoints",
                  .x = {1, 2, 3},
                  .y = {290, 570, 860},
                  .low = {280, 560, 850},
                  .high = {310, 590, 900}}};
  return {{"seq2", plot}};
}

inline ReportData SampleReport() {
  ReportData data;
  data.title = "Armature: two sequences, two engines";
  data.remarks = {"seq3, preset fast: left out, its images are gone."};
  data.headline = {
      {"Localization error on seq1", "0.049 m", "0.12 m", 0.049, 0.12,
       "Generated sequences, not the paper's."},
      {"Faster than keypoints", "134 times", "100 times", 134, 100, "Medians of the front end, one thread."},
      {"Right model first", "62 %", "", 62, std::nullopt, "Of 19 objects; the paper gives none."}};
  data.tables = {SampleObjectTable("seq1"), SampleObjectTable("seq2"), SampleTimingTable()};
  data.stages = DrawStageBars(SampleStages(), 3, data.remarks);
  data.curves = DrawTimeCurves(SampleCurves(), data.remarks);
  data.ablations = DrawAblationBars(
      {{"seq1", "Azimuth error.", "deg", {{"default", 2.38}, {"no normal term", 7.9}}}}, data.remarks);
  data.maps = {{"seq1",
                SampleLayer("truth", 0),
                {SampleLayer("odometry only", 0.2), SampleLayer("default", 0.06), SampleLayer("fast", 0.1)},
                "Moved to the truth by the first pose, scale 1."},
               {"hall", std::nullopt, {SampleLayer("default", 0.06)}, "No truth is known."}};
  data.overlays = {{"seq1", "default", 1.5, "12 edges of 2 objects", SamplePicture("frame", "#b8c8d8")},
                   {"seq1", "default", 3, "9 edges of 1 object", SamplePicture("later", "#d8c8b8")}};
  data.strips = {SampleStrip("chair0"), SampleStrip("chair1")};
  data.scenes = {SampleScene("seq1"), SampleScene("seq2")};
  data.environment = {{"git commit", "c438c7e0c2dc, modified"}, {"machine", "2 cores"}};
  return data;
}

}  // namespace armature::testing
