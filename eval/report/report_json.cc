// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <nlohmann/json.hpp>

#include "eval/report/report_page.h"

namespace armature {
namespace {

using Json = nlohmann::ordered_json;

// Tenths of millimetres are more than a plot shows, and a third of the bytes.
double Rounded(double metres) { return std::round(metres * 1e4) / 1e4; }

template <typename Vector>
Json VectorJson(const Vector& vector) {
  Json json = Json::array();
  for (Eigen::Index i = 0; i < vector.size(); ++i) json.push_back(Rounded(vector[i]));
  return json;
}

// An array of what the function makes of each item.
template <typename Items, typename Function>
Json ArrayJson(const Items& items, Function function) {
  Json json = Json::array();
  for (const auto& item : items) json.push_back(function(item));
  return json;
}

template <typename Points>
Json PointsJson(const Points& points) {
  return ArrayJson(points, [](const auto& point) { return VectorJson(point); });
}

template <typename Value>
Json OptionalJson(const std::optional<Value>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json FigureJson(const HeadlineFigure& figure) {
  return {{"label", figure.label},
          {"ours", figure.ours},
          {"paper", figure.paper},
          {"ours_value", OptionalJson(figure.ours_value)},
          {"paper_value", OptionalJson(figure.paper_value)},
          {"remark", figure.remark}};
}

const char* SectionName(ReportSection section) {
  switch (section) {
    case ReportSection::kOverview:
      return "overview";
    case ReportSection::kAccuracy:
      return "accuracy";
    case ReportSection::kTiming:
      return "timing";
    case ReportSection::kRetrieval:
      return "retrieval";
    case ReportSection::kAblation:
      return "ablation";
    case ReportSection::kOther:
      break;
  }
  return "other";
}

// Cells as they are shown; null: nothing was measured.
Json ReportTableJson(const ReportTable& item) {
  const auto cell = [](const Cell& c) { return c.text.empty() ? Json(nullptr) : Json(c.text); };
  const auto row = [&](const std::vector<Cell>& cells) { return ArrayJson(cells, cell); };
  const Table& table = item.table;
  return {{"section", SectionName(item.section)},
          {"name", table.name},
          {"sequence", table.sequence},
          {"title", table.title},
          {"columns", table.columns},
          {"rows", ArrayJson(table.rows, row)},
          {"notes", table.notes}};
}

Json StagesJson(const StageBars& stages) {
  const auto bar = [](const StageBars::Bar& b) {
    return Json{{"engine", b.engine}, {"milliseconds", b.milliseconds}};
  };
  return {{"sequence", stages.sequence},
          {"caption", stages.caption},
          {"stages", stages.stages},
          {"bars", ArrayJson(stages.bars, bar)}};
}

Json CurvesJson(const TimeCurves& curves) {
  const auto point = [](const TimeCurves::Point& p) {
    return Json{{"x", p.x}, {"median", p.median}, {"p10", p.p10}, {"p90", p.p90}};
  };
  const auto curve = [&](const TimeCurves::Curve& c) {
    return Json{{"name", c.name}, {"points", ArrayJson(c.points, point)}};
  };
  return {{"sequence", curves.sequence},
          {"x_label", curves.x_label},
          {"y_label", curves.y_label},
          {"curves", ArrayJson(curves.curves, curve)}};
}

Json AblationJson(const AblationBars& ablation) {
  const auto bar = [](const AblationBars::Bar& b) { return Json{{"run", b.run}, {"value", b.value}}; };
  return {{"sequence", ablation.sequence},
          {"caption", ablation.caption},
          {"unit", ablation.unit},
          {"bars", ArrayJson(ablation.bars, bar)}};
}

Json LayerJson(const MapLayer& layer) {
  const auto object = [](const auto& o) {
    return Json{{"id", o.id},
                {"category", o.category},
                {"footprint", PointsJson(o.footprint)},
                {"front", VectorJson(o.front)},
                {"error_m", OptionalJson(o.error_m)}};
  };
  return {{"name", layer.name},
          {"trajectory", PointsJson(layer.trajectory)},
          {"objects", ArrayJson(layer.objects, object)}};
}

Json MapJson(const TopDownMap& map) {
  return {{"sequence", map.sequence},
          {"truth", map.truth ? LayerJson(*map.truth) : Json(nullptr)},
          {"estimates", ArrayJson(map.estimates, LayerJson)},
          {"note", map.note}};
}

// The numbers of a matrix one after the other, a column (a vertex, a triangle) after the other.
template <typename Matrix, typename Function>
Json FlatJson(const Matrix& matrix, Function function) {
  Json json = Json::array();
  for (const auto& value : matrix.reshaped()) json.push_back(function(value));
  return json;
}

Json SceneObjectJson(const SceneView::Object& object) {
  const auto line = [](const SceneView::Line& l) { return PointsJson(std::array{l.first, l.second}); };
  const auto whole = [](auto value) { return static_cast<int>(value); };
  return {{"id", object.id},
          {"category", object.category},
          {"model", object.model},
          {"wireframe", ArrayJson(object.wireframe, line)},
          {"true_box", ArrayJson(object.true_box, line)},
          {"cad",
           {{"vertices", FlatJson(object.cad.vertices, Rounded)},
            {"triangles", FlatJson(object.cad.triangles, whole)},
            {"colours", FlatJson(object.cad.colours, whole)}}}};
}

Json SceneJson(const SceneView& scene) {
  const auto pyramid = [](const auto& corners) { return PointsJson(corners); };
  return {{"sequence", scene.sequence},
          {"run", scene.run},
          {"up", VectorJson(scene.up)},
          {"path", PointsJson(scene.path)},
          {"true_path", PointsJson(scene.true_path)},
          {"cameras", ArrayJson(scene.cameras, pyramid)},
          {"objects", ArrayJson(scene.objects, SceneObjectJson)}};
}

Json StripJson(const RetrievalStrip& strip) {
  const auto model = [](const RetrievalStrip::Model& m) {
    return Json{{"name", m.name}, {"detail", m.detail}, {"is_true", m.is_true}};
  };
  return {{"sequence", strip.sequence},
          {"run", strip.run},
          {"object", strip.object},
          {"true_model", strip.true_model},
          {"models", ArrayJson(strip.models, model)}};
}

}  // namespace

nlohmann::ordered_json ReportJson(const ReportData& data) {
  const auto overlay = [](const OverlayFrame& o) {
    return Json{{"sequence", o.sequence}, {"run", o.run}, {"timestamp", o.timestamp}, {"caption", o.caption}};
  };
  const auto fact = [](const auto& f) { return Json::array({f.first, f.second}); };
  return {{"title", data.title},
          {"remarks", data.remarks},
          {"headline", ArrayJson(data.headline, FigureJson)},
          {"tables", ArrayJson(data.tables, ReportTableJson)},
          {"stages", ArrayJson(data.stages, StagesJson)},
          {"curves", ArrayJson(data.curves, CurvesJson)},
          {"ablations", ArrayJson(data.ablations, AblationJson)},
          {"maps", ArrayJson(data.maps, MapJson)},
          {"overlays", ArrayJson(data.overlays, overlay)},
          {"strips", ArrayJson(data.strips, StripJson)},
          {"scenes", ArrayJson(data.scenes, SceneJson)},
          {"environment", ArrayJson(data.environment, fact)}};
}

}  // namespace armature
