// SPDX-License-Identifier: BSD-3-Clause
// All that a report shows, as plain data: what is read from runs, evaluations and benchmarks, and what a page
// is made of. Lengths are metres in the frame of the true world where a sequence has a truth, else in that of
// the map.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/triangle_mesh.h"
#include "io/text_table.h"

namespace armature {

// A number that people look for first, beside the paper's.
struct HeadlineFigure {
  std::string label;                 // "Localization error on seq1, average"
  std::string ours, paper;           // with unit, "0.049 m"; empty: there is none
  std::optional<double> ours_value;  // for comparing
  std::optional<double> paper_value;
  std::string remark;  // what makes them comparable, or not
};

// Where in the report a table stands.
enum class ReportSection { kOverview, kAccuracy, kTiming, kRetrieval, kAblation, kFurther };

struct ReportTable {
  ReportSection section = ReportSection::kFurther;
  Table table;
};

// What lies in one map, true or estimated, seen from above. x to the right, y up on the page; the gravity
// axis is left out.
struct MapLayer {
  std::string name;                         // "truth", "odometry only", "default: objects, loop closure"
  std::vector<Eigen::Vector2d> trajectory;  // in order of time
  struct Object {
    std::string id, category;
    std::array<Eigen::Vector2d, 4> footprint;  // of its box, in order around
    Eigen::Vector2d front{0, 0};               // unit: where its front (+z) points
    std::optional<double> error_m;  // distance of the centre from the true one; none: no true object
  };
  std::vector<Object> objects;
};

struct TopDownMap {
  std::string sequence;
  std::optional<MapLayer> truth;
  std::vector<MapLayer> estimates;  // the first two are shown first, side by side
  std::string note;                 // how the estimates were brought to the truth
};

// A picture to be shown: an encoded JPEG or PNG file.
struct ReportPicture {
  std::string mime;   // "image/jpeg", "image/png"
  std::string bytes;  // of the file
  std::string alt;    // what it shows, for those who do not see it
};

// Numbers as bars or curves, drawn.
struct ReportPlot {
  std::string sequence, caption;
  ReportPicture picture;
};

// A frame with its associated edges and wireframes.
struct OverlayFrame {
  std::string sequence, run;
  double timestamp = 0;  // seconds
  std::string caption;
  ReportPicture picture;
};

// An object as it was seen, and its nearest CAD models.
struct RetrievalStrip {
  std::string sequence, run, object;
  ReportPicture query;
  std::string true_model;  // empty: not known
  struct Model {
    std::string name;
    std::string detail;  // "cost 4.80, distance 5.92"
    bool is_true = false;
    std::optional<ReportPicture> picture;  // none: it has no surface
  };
  std::vector<Model> models;  // nearest first
};

// A map to be turned with the mouse.
struct SceneView {
  std::string sequence, run;
  Eigen::Vector3d up{0, 1, 0};                          // unit
  std::vector<Eigen::Vector3d> path, true_path;         // cameras in order of time; true ones may be absent
  std::vector<std::array<Eigen::Vector3d, 5>> cameras;  // some of them as pyramids: the centre, then the base
  using Line = std::pair<Eigen::Vector3d, Eigen::Vector3d>;
  struct Object {
    std::string id, category, model;  // model: the retrieved CAD model's name, or empty
    std::vector<Line> wireframe;
    std::vector<Line> true_box;  // twelve edges, or none
    TriangleMesh cad;            // without triangles: there is none
  };
  std::vector<Object> objects;
};

// A normal term's effect: mean errors with and without it.
struct AblationBars {
  std::string sequence, caption, unit;
  struct Bar {
    std::string run;
    double value = 0;
  };
  std::vector<Bar> bars;
};

struct ReportData {
  std::string title;
  std::vector<std::string> remarks;  // what a reader has to know first: cells that failed, pictures left out
  std::vector<HeadlineFigure> headline;
  std::vector<ReportTable> tables;
  std::vector<ReportPlot> stages, curves;  // median times as stacked bars, and against something that grows
  std::vector<ReportPlot> distributions;   // of errors over rooms
  std::vector<ReportPlot> ablations;       // what the normal term does
  std::vector<TopDownMap> maps;
  std::vector<OverlayFrame> overlays;
  std::vector<RetrievalStrip> strips;
  std::vector<SceneView> scenes;
  std::vector<std::pair<std::string, std::string>> environment;  // "git commit" -> "c438c7e4..., modified"
};

}  // namespace armature
