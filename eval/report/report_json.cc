// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <nlohmann/json.hpp>

#include "eval/report/report_page.h"
#include "io/json_fields.h"

// Of a struct the fields that are named, in this order; nlohmann's own macro sorts them.
#define ARMATURE_REPORT_FIELDS(Type, ...)                                    \
  template <typename Json>                                                   \
  void to_json(Json& nlohmann_json_j, const Type& nlohmann_json_t) {         \
    NLOHMANN_JSON_EXPAND(NLOHMANN_JSON_PASTE(NLOHMANN_JSON_TO, __VA_ARGS__)) \
  }

namespace armature {
namespace {

// Tenths of millimetres are more than a plot shows, and a third of the bytes.
double Rounded(double metres) { return std::round(metres * 1e4) / 1e4; }

}  // namespace
}  // namespace armature

namespace nlohmann {

// Points in metres.
template <int kSize>
struct adl_serializer<Eigen::Matrix<double, kSize, 1>> {
  template <typename Json>
  static void to_json(Json& json, const Eigen::Matrix<double, kSize, 1>& point) {
    json = Json::array();
    for (const double coordinate : point) json.push_back(armature::Rounded(coordinate));
  }
};

}  // namespace nlohmann

namespace armature {
namespace {

// The numbers of a matrix one after the other, a column (a vertex, a triangle) after the other.
template <typename Json, typename Matrix, typename Function>
Json FlatJson(const Matrix& matrix, Function function) {
  Json json = Json::array();
  for (const auto& value : matrix.reshaped()) json.push_back(function(value));
  return json;
}

}  // namespace

NLOHMANN_JSON_SERIALIZE_ENUM(ReportSection, {{ReportSection::kFurther, "other"},
                                             {ReportSection::kOverview, "overview"},
                                             {ReportSection::kAccuracy, "accuracy"},
                                             {ReportSection::kTiming, "timing"},
                                             {ReportSection::kRetrieval, "retrieval"},
                                             {ReportSection::kAblation, "ablation"}})

// As it is shown; null: nothing was measured.
template <typename Json>
void to_json(Json& json, const Cell& cell) {
  json = cell.text.empty() ? Json(nullptr) : Json(cell.text);
}

template <typename Json>
void to_json(Json& json, const ReportTable& item) {
  const Table& table = item.table;
  json = {{"section", item.section}, {"name", table.name},       {"sequence", table.sequence},
          {"title", table.title},    {"columns", table.columns}, {"rows", table.rows},
          {"notes", table.notes}};
}

template <typename Json>
void to_json(Json& json, const TriangleMesh& mesh) {
  const auto whole = [](auto value) { return static_cast<int>(value); };
  json = {{"vertices", FlatJson<Json>(mesh.vertices, Rounded)},
          {"triangles", FlatJson<Json>(mesh.triangles, whole)},
          {"colours", FlatJson<Json>(mesh.colours, whole)}};
}

// What stands in the page's HTML, such as pictures, is not here again.
ARMATURE_REPORT_FIELDS(HeadlineFigure, label, ours, paper, ours_value, paper_value, remark)
ARMATURE_REPORT_FIELDS(MapLayer::Object, id, category, footprint, front, error_m)
ARMATURE_REPORT_FIELDS(MapLayer, name, trajectory, objects)
ARMATURE_REPORT_FIELDS(TopDownMap, sequence, truth, estimates, note)
ARMATURE_REPORT_FIELDS(OverlayFrame, sequence, run, timestamp, caption)
ARMATURE_REPORT_FIELDS(RetrievalStrip::Model, name, detail, is_true)
ARMATURE_REPORT_FIELDS(RetrievalStrip, sequence, run, object, true_model, models)
ARMATURE_REPORT_FIELDS(SceneView::Object, id, category, model, wireframe, true_box, cad)
ARMATURE_REPORT_FIELDS(SceneView, sequence, run, up, path, true_path, cameras, objects)
ARMATURE_REPORT_FIELDS(ReportData, title, remarks, headline, tables, maps, overlays, strips, scenes,
                       environment)

nlohmann::ordered_json ReportJson(const ReportData& data) { return data; }

}  // namespace armature
