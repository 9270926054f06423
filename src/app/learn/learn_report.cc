// SPDX-License-Identifier: BSD-3-Clause
#include "app/learn/learn_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/number_format.h"
#include "category/learn.h"
#include "geometry/rotation.h"

namespace armature {
namespace {

std::string VarianceText(const CategoryModel& model) {
  const Eigen::VectorXd explained = 100 * ExplainedVariance(model);
  std::string text =
      fmt::format("{:>6} {:>14} {:>12} {:>12}\n", "mode", "deviation [m]", "variance [%]", "together [%]");
  double together = 0;
  for (int i = 0; i < model.modes(); ++i) {
    together += explained[i];
    text += fmt::format("{:>6} {:>14.4f} {:>12.2f} {:>12.2f}\n", i + 1, model.standard_deviations[i],
                        explained[i], together);
  }
  return text;
}

std::string HeldOutText(const LearnReport& report) {
  if (report.held_out.empty()) return "";
  const HeldOutRow& first = report.held_out.front();
  std::string text = fmt::format("\nHeld out: every {}-th plausible model ({}), learnt from the other {}.\n",
                                 report.held_out_every, first.error.models, first.training_models);
  text += fmt::format("{:>6} {:>14} {:>16}\n", "modes", "midpoint [m]", "direction [deg]");
  for (const HeldOutRow& row : report.held_out) {
    text += fmt::format("{:>6} {:>14.4f} {:>16.2f}\n", row.modes, row.error.midpoint,
                        row.error.direction / kDegree);
  }
  return text + "Mean error of an edge over all edges and models held out, nearest shape of the model.\n";
}

std::string ErrorText(const std::string& set, const ReconstructionError& error) {
  return fmt::format("{:>9} {:>7} {:>14.4f} {:>16.2f}\n", set, error.models, error.midpoint,
                     error.direction / kDegree);
}

std::string ComparisonText(const LearnReport& report) {
  if (!report.comparison) return "";
  const auto& [own, other, source, read] = *report.comparison;
  std::string text =
      fmt::format("\nCompared with {} plausible of {} models: {}.\n", other.error.models, read, source);
  text += fmt::format("{:>6} {:>10} {:>10} {:>12} {:>12}\n", "mode", "own mean", "own std", "others mean",
                      "others std");
  for (int i = 0; i < report.model.modes(); ++i) {
    text += fmt::format("{:>6} {:>10} {:>10} {:>12} {:>12}\n", i + 1, Fixed(own.coefficients.mean[i], 2),
                        Fixed(own.coefficients.deviation[i], 2), Fixed(other.coefficients.mean[i], 2),
                        Fixed(other.coefficients.deviation[i], 2));
  }
  text += "Coefficients of the models in the learnt modes, in the modes' standard deviations.\n\n";
  text += fmt::format("{:>9} {:>7} {:>14} {:>16}\n", "set", "models", "midpoint [m]", "direction [deg]");
  text += ErrorText("own", own.error) + ErrorText("others", other.error);
  return text + "Mean error of an edge, nearest shape of the model.\n";
}

nlohmann::ordered_json SetJson(const SetStatistics& set) {
  const auto& [mean, deviation] = set.coefficients;
  return {{"models", set.error.models},
          {"mean", std::vector<double>(mean.begin(), mean.end())},
          {"deviation", std::vector<double>(deviation.begin(), deviation.end())},
          {"midpoint_m", set.error.midpoint},
          {"direction_deg", set.error.direction / kDegree}};
}

}  // namespace

std::string ReportText(const LearnReport& report) {
  const CategoryModel& model = report.model;
  std::string text = fmt::format(
      "{}: learnt from {} plausible of {} models, {} edges, {} representative models\n\n", model.spec.name,
      model.training_models, report.models_read, model.spec.edges(), model.dictionary.size());
  text += VarianceText(model) + HeldOutText(report) + ComparisonText(report);
  if (!report.out.empty()) text += fmt::format("\nCategory model: {}\n", report.out);
  if (!report.library.empty()) text += fmt::format("Library of instances: {}\n", report.library);
  return text;
}

std::string ReportJson(const LearnReport& report) {
  const CategoryModel& model = report.model;
  const Eigen::VectorXd explained = ExplainedVariance(model);
  nlohmann::ordered_json json;
  json["category"] = model.spec.name;
  json["source"] = model.source;
  json["models_read"] = report.models_read;
  json["training_models"] = model.training_models;
  json["edges"] = model.spec.edges();
  json["explained_variance"] = std::vector<double>(explained.begin(), explained.end());
  json["standard_deviations_m"] =
      std::vector<double>(model.standard_deviations.begin(), model.standard_deviations.end());
  json["dictionary_size"] = model.dictionary.size();
  if (report.held_out_every != 0) json["held_out_every"] = report.held_out_every;
  for (const HeldOutRow& row : report.held_out) {
    json["held_out"].push_back({{"modes", row.modes},
                                {"models", row.error.models},
                                {"midpoint_m", row.error.midpoint},
                                {"direction_deg", row.error.direction / kDegree}});
  }
  if (report.comparison) {
    json["comparison"] = {{"with", report.comparison->other_source},
                          {"models_read", report.comparison->other_read},
                          {"own", SetJson(report.comparison->own)},
                          {"others", SetJson(report.comparison->other)}};
  }
  if (!report.out.empty()) json["out"] = report.out;
  if (!report.library.empty()) json["library"] = report.library;
  return json.dump(2) + "\n";
}

}  // namespace armature
