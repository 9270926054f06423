// SPDX-License-Identifier: BSD-3-Clause
#include "io/category_spec_yaml.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/errors.h"
#include "base/nearest_name.h"

namespace armature {
namespace {

using Measure = MetricReference::Measure;

// Names become keys of YAML and fields of CSV, so they are kept plain.
void CheckName(const YamlMap& map, const std::string& key, const std::string& name) {
  const auto plain = [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; };
  if (name.empty() || !std::all_of(name.begin(), name.end(), plain)) {
    throw InputError(map.At(key, fmt::format("has the name '{}'; use letters, digits, '_' and '-'", name)));
  }
}

std::vector<std::string> ReadEdgeNames(const YamlMap& root) {
  const std::vector<std::string> names = root.Texts("edges");
  if (names.size() < 2) throw InputError(root.At("edges", "needs at least 2 edges"));
  std::set<std::string> seen;
  for (const std::string& name : names) {
    CheckName(root, "edges", name);
    if (!seen.insert(name).second) throw InputError(root.At("edges", fmt::format("names '{}' twice", name)));
  }
  return names;
}

int EdgeIndex(const YamlMap& map, const std::string& key, const std::vector<std::string>& names,
              const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<int>(found - names.begin());
  throw InputError(fmt::format("{}: {}", map.Where(key), UnknownNameMessage("edge", name, names)));
}

std::array<int, 2> ReadBaseEdges(const YamlMap& root, const std::vector<std::string>& names) {
  const std::vector<std::string> base = root.Texts("base_edges");
  if (base.size() != 2 || base[0] == base[1])
    throw InputError(root.At("base_edges", "has to name two edges"));
  return {EdgeIndex(root, "base_edges", names, base[0]), EdgeIndex(root, "base_edges", names, base[1])};
}

EdgeEnd ReadCorner(const YamlMap& faces, const std::string& face, const std::vector<std::string>& names,
                   const std::string& corner) {
  const size_t dot = corner.rfind('.');
  const std::string end = dot == std::string::npos ? "" : corner.substr(dot + 1);
  if (end != "start" && end != "end") {
    throw InputError(
        faces.At(face, fmt::format("has the corner '{}'; write EDGE.start or EDGE.end", corner)));
  }
  return {EdgeIndex(faces, face, names, corner.substr(0, dot)), end == "end" ? 1 : 0};
}

std::vector<Face> ReadFaces(const YamlMap& root, const std::vector<std::string>& names) {
  if (!root.Has("faces")) return {};
  const YamlMap map = root.Map("faces");
  std::vector<Face> faces;
  for (const std::string& name : map.Keys()) {
    CheckName(map, name, name);
    Face face{name, {}};
    for (const std::string& corner : map.Texts(name))
      face.corners.push_back(ReadCorner(map, name, names, corner));
    if (face.corners.size() < 3) throw InputError(map.At(name, "needs at least 3 corners"));
    if (face.corners.size() > kMaxFaceCorners) {
      throw InputError(map.At(name, fmt::format("has more than {} corners", kMaxFaceCorners)));
    }
    faces.push_back(std::move(face));
  }
  return faces;
}

MetricReference ReadReference(const YamlMap& map, const std::vector<std::string>& names) {
  map.CheckKeys({"measure", "edges", "metres"});
  MetricReference reference;
  const std::string measure = map.Text("measure");
  if (measure != "height_above_ground" && measure != "length") {
    throw InputError(map.At("measure", fmt::format("is '{}'; use height_above_ground or length", measure)));
  }
  reference.measure = measure == "length" ? Measure::kLength : Measure::kHeightAboveGround;
  for (const std::string& name : map.Texts("edges")) {
    reference.edges.push_back(EdgeIndex(map, "edges", names, name));
  }
  if (reference.edges.empty()) throw InputError(map.At("edges", "names no edge"));
  reference.metres = map.Number("metres");
  if (reference.metres <= 0) throw InputError(map.At("metres", "has to be positive"));
  return reference;
}

// One number for all axes, or one for each.
Eigen::Vector3d ReadPadding(const YamlMap& root) {
  const bool is_list = root.IsList("padding");
  const std::vector<double> values =
      is_list ? root.Numbers("padding") : std::vector<double>(3, root.Number("padding"));
  const bool is_negative = std::any_of(values.begin(), values.end(), [](double v) { return v < 0; });
  if (values.size() != 3 || is_negative)
    throw InputError(root.At("padding", "has to be one length or [x, y, z], in metres, not below 0"));
  return {values[0], values[1], values[2]};
}

SlabOutline ReadSlab(const YamlMap& map, const std::vector<std::string>& names) {
  map.CheckKeys({"edges", "drop"});
  SlabOutline slab;
  for (const std::string& name : map.Texts("edges"))
    slab.edges.push_back(EdgeIndex(map, "edges", names, name));
  if (slab.edges.size() < 3) throw InputError(map.At("edges", "needs the edges around a board, at least 3"));
  slab.drop = map.Number("drop");
  if (slab.drop < 0) throw InputError(map.At("drop", "is a length in metres downwards, at least 0"));
  return slab;
}

int ReadCount(const YamlMap& map, const std::string& key, int fallback) {
  if (!map.Has(key)) return fallback;
  const int count = map.Integer(key);
  if (count < 1) throw InputError(map.At(key, fmt::format("is {}; it has to be at least 1", count)));
  return count;
}

std::string EdgeList(const CategorySpec& spec, const std::vector<int>& edges) {
  std::vector<std::string> names;
  for (const int edge : edges) names.push_back(spec.edge_names[static_cast<size_t>(edge)]);
  return fmt::format("[{}]", fmt::join(names, ", "));
}

std::string FacesText(const CategorySpec& spec) {
  if (spec.faces.empty()) return "faces: {}\n";
  std::string text = "faces:\n";
  for (const Face& face : spec.faces) {
    std::vector<std::string> corners;
    for (const EdgeEnd& corner : face.corners) {
      const std::string& name = spec.edge_names[static_cast<size_t>(corner.edge)];
      corners.push_back(fmt::format("{}.{}", name, corner.end == 1 ? "end" : "start"));
    }
    text += fmt::format("  {}: [{}]\n", face.name, fmt::join(corners, ", "));
  }
  return text;
}

std::string PaddingText(const Eigen::Vector3d& padding) {
  if (padding == Eigen::Vector3d::Constant(padding.x())) return fmt::format("{}", padding.x());
  return fmt::format("[{}, {}, {}]", padding.x(), padding.y(), padding.z());
}

}  // namespace

std::vector<std::string> CategorySpecKeys() {
  return {"category", "edges", "base_edges", "faces",      "symmetry_order", "stands_on_floor",
          "padding",  "slab",  "reference",  "size_sigma", "dictionary_size"};
}

CategorySpec ReadCategorySpec(const YamlMap& root) {
  CategorySpec spec;
  spec.name = root.Text("category");
  CheckName(root, "category", spec.name);
  spec.edge_names = ReadEdgeNames(root);
  spec.base_edges = ReadBaseEdges(root, spec.edge_names);
  spec.faces = ReadFaces(root, spec.edge_names);
  spec.symmetry_order = ReadCount(root, "symmetry_order", spec.symmetry_order);
  if (root.Has("padding")) spec.padding = ReadPadding(root);
  if (root.Has("slab")) spec.slab = ReadSlab(root.Map("slab"), spec.edge_names);
  if (root.Has("stands_on_floor")) spec.stands_on_floor = root.Boolean("stands_on_floor");
  spec.reference = ReadReference(root.Map("reference"), spec.edge_names);
  if (root.Has("size_sigma")) {
    spec.size_sigma = root.Number("size_sigma");
    if (!(spec.size_sigma > 0)) throw InputError(root.At("size_sigma", "has to be positive"));
  }
  spec.dictionary_size = ReadCount(root, "dictionary_size", spec.dictionary_size);
  return spec;
}

TrainingSpec ReadTraining(const YamlMap& training, const CategorySpec& category) {
  training.CheckKeys({"modes", "mirrored", "plausible"});
  TrainingSpec spec{category, {}};
  spec.modes = ReadCount(training, "modes", spec.modes);
  if (spec.modes > kMaxModes) {
    throw InputError(
        training.At("modes", fmt::format("is {}; at most {} are supported", spec.modes, kMaxModes)));
  }
  if (training.Has("mirrored")) spec.mirrored = training.Boolean("mirrored");
  if (!training.Has("plausible")) return spec;
  const YamlMap plausible = training.Map("plausible");
  const std::vector<std::string> axes = {"width", "height", "depth"};  // x, y, z
  plausible.CheckKeys(axes);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const std::string& key = axes[static_cast<size_t>(axis)];
    if (!plausible.Has(key)) continue;
    const std::vector<double> range = plausible.Numbers(key);
    if (range.size() != 2 || range[0] > range[1]) {
      throw InputError(plausible.At(key, "has to be [least, greatest], in metres"));
    }
    spec.plausible.min[axis] = range[0];
    spec.plausible.max[axis] = range[1];
  }
  return spec;
}

std::string CategorySpecText(const CategorySpec& spec) {
  const auto& [base_a, base_b] = spec.base_edges;
  std::string text = fmt::format("category: {}\nedges: [{}]\n", spec.name, fmt::join(spec.edge_names, ", "));
  text += fmt::format("base_edges: {}\n", EdgeList(spec, {base_a, base_b}));
  text += FacesText(spec);
  text += fmt::format("symmetry_order: {}\nstands_on_floor: {}\npadding: {}\n", spec.symmetry_order,
                      spec.stands_on_floor, PaddingText(spec.padding));
  if (spec.slab && spec.slab->drop > 0)
    text +=
        fmt::format("slab:\n  edges: {}\n  drop: {}\n", EdgeList(spec, spec.slab->edges), spec.slab->drop);
  const bool length = spec.reference.measure == Measure::kLength;
  text += fmt::format("reference:\n  measure: {}\n  edges: {}\n  metres: {:.9g}\n",
                      length ? "length" : "height_above_ground", EdgeList(spec, spec.reference.edges),
                      spec.reference.metres);
  return text +
         fmt::format("size_sigma: {:.9g}\ndictionary_size: {}\n", spec.size_sigma, spec.dictionary_size);
}

}  // namespace armature
