// SPDX-License-Identifier: BSD-3-Clause
#include "io/category_yaml.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <set>

#include "base/errors.h"
#include "category/learn.h"
#include "io/atomic_write.h"
#include "io/category_spec_yaml.h"

namespace armature {
namespace {

constexpr double kOrthonormalTolerance = 1e-6;

YamlMap LoadRoot(const std::filesystem::path& file) {
  const YamlMap root = YamlMap::Load(file);
  std::vector<std::string> keys = CategorySpecKeys();
  keys.insert(keys.end(), {"training", "model"});
  root.CheckKeys(keys);
  return root;
}

Eigen::VectorXd ReadVector(const YamlMap& map, const std::string& key, size_t size) {
  const std::vector<double> numbers = map.Numbers(key);
  if (numbers.size() != size) {
    throw InputError(map.At(key, fmt::format("has {} numbers where {} are needed", numbers.size(), size)));
  }
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(size));
}

// A map of every edge to the six numbers M D.
Eigen::VectorXd ReadShape(const YamlMap& map, const CategorySpec& spec) {
  map.CheckKeys(spec.edge_names);
  Eigen::VectorXd shape(6 * spec.edges());
  for (int i = 0; i < spec.edges(); ++i) {
    shape.segment<6>(6 * i) = ReadVector(map, spec.edge_names[static_cast<size_t>(i)], 6);
  }
  return shape;
}

void CheckBasis(const YamlMap& section, const CategoryModel& model) {
  const Eigen::MatrixXd gram = model.basis.transpose() * model.basis;
  if ((gram - Eigen::MatrixXd::Identity(model.modes(), model.modes())).cwiseAbs().maxCoeff() >
      kOrthonormalTolerance) {
    throw InputError(section.At("basis", "is not orthonormal; learn the model again"));
  }
  if ((model.standard_deviations.array() <= 0).any()) {
    throw InputError(section.At("standard_deviations", "have to be positive"));
  }
  if (model.total_variance < model.standard_deviations.squaredNorm() * (1 - kOrthonormalTolerance)) {
    throw InputError(section.At("total_variance", "is less than the modes' variance; learn the model again"));
  }
}

void CheckBaseEdges(const YamlMap& root, const CategoryModel& model) {
  const Wireframe mean = WireframeFromVector(model.mean);
  const Eigen::Vector3d first = mean.directions.col(model.spec.base_edges[0]);
  const Eigen::Vector3d second = mean.directions.col(model.spec.base_edges[1]);
  if (first.cross(second).normalized().y() < 0.5) {
    throw InputError(
        root.At("base_edges", "first cross second does not point up (+y); swap them or choose others"));
  }
}

CategoryModel ReadModel(const YamlMap& section, const CategorySpec& spec) {
  section.CheckKeys(
      {"source", "training_models", "total_variance", "standard_deviations", "mean", "basis", "dictionary"});
  CategoryModel model;
  model.spec = spec;
  model.source = section.Text("source");
  model.training_models = section.Integer("training_models");
  model.total_variance = section.Number("total_variance");
  model.mean = ReadShape(section.Map("mean"), spec);
  const size_t modes = section.Numbers("standard_deviations").size();
  if (modes == 0) throw InputError(section.At("standard_deviations", "is empty; learn the model again"));
  if (modes > kMaxModes) {
    throw InputError(section.At("standard_deviations",
                                fmt::format("has {} modes, at most {} are supported", modes, kMaxModes)));
  }
  model.standard_deviations = ReadVector(section, "standard_deviations", modes);
  const YamlMap basis = section.Map("basis");
  if (basis.Keys().size() != modes) {
    throw InputError(section.At(
        "basis", fmt::format("has {} modes for {} standard deviations", basis.Keys().size(), modes)));
  }
  model.basis.resize(6 * spec.edges(), static_cast<Eigen::Index>(modes));
  for (int i = 0; i < model.modes(); ++i) {
    model.basis.col(i) = ReadShape(basis.Map(fmt::format("mode_{}", i + 1)), spec);
  }
  const YamlMap dictionary = section.Map("dictionary");
  for (const std::string& entry : dictionary.Keys()) {
    model.dictionary.push_back(ReadVector(dictionary, entry, modes));
  }
  if (model.dictionary.empty()) throw InputError(section.At("dictionary", "is empty; learn the model again"));
  CheckBasis(section, model);
  return model;
}

std::string NumbersText(const Eigen::VectorXd& numbers) {
  return fmt::format("[{:.9g}]", fmt::join(numbers.data(), numbers.data() + numbers.size(), ", "));
}

std::string ShapeText(const CategorySpec& spec, const Eigen::VectorXd& shape, const std::string& indent) {
  std::string text;
  for (int i = 0; i < spec.edges(); ++i) {
    text += fmt::format("{}{}: {}\n", indent, spec.edge_names[static_cast<size_t>(i)],
                        NumbersText(shape.segment<6>(6 * i)));
  }
  return text;
}

std::string HeaderText(const CategoryModel& model) {
  const Eigen::VectorXd explained = 100 * ExplainedVariance(model);
  return fmt::format(
      "# Category model of a {}, written by `armature learn`.\n"
      "# Learnt from: {}\n"
      "# Models: {}. Variance held by each mode, in %: {:.1f}; together {:.1f}.\n"
      "# Object frame: y up, front +z, origin at the centre of the bounding box; metres.\n",
      model.spec.name, model.source, model.training_models,
      fmt::join(explained.data(), explained.data() + explained.size(), " "), explained.sum());
}

// Double-quoted YAML of one line.
std::string QuotedText(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c == '\n' ? ' ' : c;
  }
  return quoted + "\"";
}

}  // namespace

CategorySpec LoadCategorySpec(const std::filesystem::path& file) { return ReadCategorySpec(LoadRoot(file)); }

TrainingSpec LoadTrainingSpec(const std::filesystem::path& file) {
  const YamlMap root = LoadRoot(file);
  return ReadTraining(root.Map("training"), ReadCategorySpec(root));
}

CategoryModel LoadCategory(const std::filesystem::path& file) {
  const YamlMap root = LoadRoot(file);
  const CategorySpec spec = ReadCategorySpec(root);
  if (!root.Has("model"))
    throw InputError(root.At("model", "is missing; add it with `armature learn --spec`"));
  const CategoryModel model = ReadModel(root.Map("model"), spec);
  CheckBaseEdges(root, model);
  return model;
}

std::vector<CategoryModel> LoadCategories(const std::filesystem::path& directory) {
  std::error_code error;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(directory, error)) {
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  }
  if (files.empty()) {
    throw InputError(fmt::format("{}: no category model (*.yaml) is there; write one with `armature learn`",
                                 directory.string()));
  }
  std::sort(files.begin(), files.end());
  std::vector<CategoryModel> models;
  std::set<std::string> names;
  for (const std::filesystem::path& file : files) {
    models.push_back(LoadCategory(file));
    if (!names.insert(models.back().spec.name).second) {
      throw InputError(fmt::format("{}: a second model of category '{}'; keep one of them", file.string(),
                                   models.back().spec.name));
    }
  }
  return models;
}

std::string CategoryText(const CategoryModel& model) {
  std::string text = HeaderText(model) + CategorySpecText(model.spec);
  text += fmt::format(
      "model:\n  source: {}\n  training_models: {}\n  total_variance: {:.9g}  # metres^2, of all modes\n",
      QuotedText(model.source), model.training_models, model.total_variance);
  text +=
      "  # Each edge: its midpoint x y z, its direction x y z (from start to end, as long as the edge), "
      "metres.\n";
  text += "  mean:\n" + ShapeText(model.spec, model.mean, "    ");
  text += fmt::format("  standard_deviations: {}  # of the modes, metres\n",
                      NumbersText(model.standard_deviations));
  text += "  basis:  # orthonormal; shape = mean + sum of coefficient * standard deviation * mode\n";
  for (int i = 0; i < model.modes(); ++i) {
    text += fmt::format("    mode_{}:\n{}", i + 1, ShapeText(model.spec, model.basis.col(i), "      "));
  }
  text += "  dictionary:  # coefficients of representative models, in standard deviations\n";
  for (size_t i = 0; i < model.dictionary.size(); ++i) {
    text += fmt::format("    model_{}: {}\n", i + 1, NumbersText(model.dictionary[i]));
  }
  return text;
}

void WriteCategory(const CategoryModel& model, const std::filesystem::path& file) {
  AtomicWrite(file, CategoryText(model));
}

}  // namespace armature
