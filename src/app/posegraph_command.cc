// SPDX-License-Identifier: BSD-3-Clause
#include "app/posegraph_command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/console.h"
#include "base/errors.h"
#include "base/interrupt.h"
#include "base/nearest_name.h"
#include "cli/help.h"
#include "io/g2o.h"
#include "io/text_table.h"
#include "mapping/pose_graph.h"

namespace armature {
namespace {

// What an argument's values are called.
template <typename Value>
struct ValueName {
  const char* name;
  Value value;
};
constexpr ValueName<PoseGraphStart> kStartNames[] = {{"auto", PoseGraphStart::kAuto},
                                                     {"file", PoseGraphStart::kGiven},
                                                     {"odometry", PoseGraphStart::kOdometry},
                                                     {"chordal", PoseGraphStart::kChordal}};
constexpr ValueName<G2oWeights> kWeightNames[] = {{"full", G2oWeights::kFull},
                                                  {"isotropic", G2oWeights::kIsotropic}};
constexpr ValueName<PoseGraphLoss> kLossNames[] = {
    {"square", PoseGraphLoss::kSquare}, {"huber", PoseGraphLoss::kHuber}, {"cauchy", PoseGraphLoss::kCauchy}};

template <typename Value, size_t n>
Value FindValue(const ValueName<Value> (&names)[n], const std::string& name, const char* option,
                const char* what) {
  std::vector<std::string> known;
  for (const ValueName<Value>& entry : names) {
    if (name == entry.name) return entry.value;
    known.push_back(entry.name);
  }
  throw InputError(fmt::format("posegraph: {}: {}", option, UnknownNameMessage(what, name, known)));
}

std::string FormatName(PoseGraphStart start) {
  for (const auto& entry : kStartNames) {
    if (start == entry.value) return entry.name;
  }
  return "";
}

struct PoseGraphReport {
  const PoseGraphArguments& arguments;
  const PoseGraph& graph;
  const PoseGraphResult& result;
  double read_milliseconds = 0;
};

std::string LossText(const PoseGraphArguments& arguments) {
  if (arguments.loss == "square") return "r^T Omega r";
  return fmt::format("the {} loss (scale {:g}) of r^T Omega r", arguments.loss, arguments.loss_scale);
}

std::string ReportText(const PoseGraphReport& report) {
  const PoseGraphResult& result = report.result;
  Table table;
  table.columns = {"vertices",   "edges",     "init",      "initial cost", "final cost",
                   "iterations", "converged", "read [ms]", "init [ms]",    "solve [ms]"};
  table.rows = {{CountCell(static_cast<long>(report.graph.poses.size())),
                 CountCell(static_cast<long>(report.graph.edges.size())), TextCell(FormatName(result.start)),
                 NumberCell(result.initial_cost, 6), NumberCell(result.final_cost, 6),
                 CountCell(result.iterations), TextCell(result.converged ? "yes" : "no"),
                 NumberCell(report.read_milliseconds, 1), NumberCell(result.start_milliseconds, 1),
                 NumberCell(result.solve_milliseconds, 1)}};
  table.notes = {
      fmt::format("cost: sum of {} over the edges, r = Log(Z^-1 X_i^-1 X_j) in SE(3), no factor 1/2",
                  LossText(report.arguments)),
      "solve: from the start to the optimised poses, without reading, start and writing; one thread"};
  return FormatTable(table, TableFormat::kText) +
         fmt::format("\nPose graph: {}\n", report.arguments.out.string());
}

std::string ReportJson(const PoseGraphReport& report) {
  const PoseGraphResult& result = report.result;
  nlohmann::ordered_json json;
  json["graph"] = report.arguments.graph.string();
  json["vertices"] = report.graph.poses.size();
  json["edges"] = report.graph.edges.size();
  json["init"] = FormatName(result.start);
  json["weights"] = report.arguments.weights;
  json["loss"] = report.arguments.loss;
  json["loss_scale"] = report.arguments.loss_scale;
  json["initial_cost"] = result.initial_cost;
  json["final_cost"] = result.final_cost;
  json["iterations"] = result.iterations;
  json["converged"] = result.converged;
  json["read_ms"] = report.read_milliseconds;
  json["init_ms"] = result.start_milliseconds;
  json["solve_ms"] = result.solve_milliseconds;
  json["out"] = report.arguments.out.string();
  return json.dump(2) + "\n";
}

CommandHelp PoseGraphHelp() {
  return {
      .description =
          "Optimises the poses of a graph of relative measurements, in SE(3) with the file's information "
          "matrices, from a start of its own choice, and writes the graph with the poses that were found.",
      .files = {{"OUT", "the graph, its vertices optimised; edges as they were"}},
      .exit_status = {},
      .examples = {
          {"a graph of your own, from the best start", "armature posegraph graph.g2o --out optimised.g2o"},
          {"from chained odometry", "armature posegraph graph.g2o --out optimised.g2o --init odometry"},
          {"with loop closures that may be wrong",
           "armature posegraph graph.g2o --out optimised.g2o --loss cauchy"}}};
}

}  // namespace

int RunPoseGraph(const PoseGraphArguments& arguments) {
  PoseGraphOptions options;
  options.start = FindValue(kStartNames, arguments.init, "--init", "start");
  options.loss = FindValue(kLossNames, arguments.loss, "--loss", "loss");
  options.loss_scale = arguments.loss_scale;
  const G2oWeights weights = FindValue(kWeightNames, arguments.weights, "--weights", "weights");
  if (!(options.loss_scale > 0) || !std::isfinite(options.loss_scale)) {
    throw InputError(
        fmt::format("posegraph: --loss-scale {:g}: has to be greater than 0", options.loss_scale));
  }
  options.max_iterations = arguments.max_iterations;
  if (options.max_iterations < 0) {
    throw InputError(
        fmt::format("posegraph: --max-iterations {}: has to be 0 or more", options.max_iterations));
  }
  const auto clock = std::chrono::steady_clock::now();
  const G2oFile g2o = ReadG2o(arguments.graph, weights);
  for (const std::string& note : g2o.notes) Note(note);
  const std::chrono::duration<double, std::milli> read = std::chrono::steady_clock::now() - clock;

  const PoseGraphResult result = SolvePoseGraph(g2o.graph, options);
  ThrowIfInterrupted();
  WriteG2o(arguments.out, g2o, result.poses);
  const PoseGraphReport report{arguments, g2o.graph, result, read.count()};
  PrintResult(arguments.json ? ReportJson(report) : ReportText(report));
  return 0;
}

void AddPoseGraphCommand(CLI::App& app, int& exit_status) {
  const auto arguments = std::make_shared<PoseGraphArguments>();
  PoseGraphArguments& a = *arguments;
  CLI::App* command = app.add_subcommand("posegraph", "Optimise a pose graph in g2o's format");
  Describe(*command, PoseGraphHelp());
  BeginSection(*command, "Input");
  command
      ->add_option("GRAPH", a.graph,
                   "g2o file: VERTEX_SE3:QUAT, EDGE_SE3:QUAT, FIX; other kinds are left out")
      ->required()
      ->type_name("FILE");
  BeginSection(*command, "Output");
  command->add_option("--out", a.out, "g2o file to write")->required()->type_name("FILE");
  command->add_flag("--json", a.json, "print JSON instead of a table");
  BeginSection(*command, "Optimisation");
  OfferValues(*command
                   ->add_option("--init", a.init,
                                "start: the file's poses, odometry (edges chained), chordal (rotations, then "
                                "positions, by linear least squares); auto: the file's, or chordal where "
                                "those are poor")
                   ->type_name("auto|file|odometry|chordal"),
              {"auto", "file", "odometry", "chordal"})
      .capture_default_str();
  OfferValues(
      *command
           ->add_option("--weights", a.weights,
                        "what an edge counts: its full information matrix, or two numbers, for "
                        "rotation and translation, also where matrices are not positive semi-definite")
           ->type_name("full|isotropic"),
      {"full", "isotropic"})
      .capture_default_str();
  OfferValues(*command
                   ->add_option("--loss", a.loss,
                                "what large errors count: the square, or less, where edges may be wrong")
                   ->type_name("square|huber|cauchy"),
              {"square", "huber", "cauchy"})
      .capture_default_str();
  command
      ->add_option("--loss-scale", a.loss_scale,
                   "error from which huber and cauchy count less, standard deviations of an edge")
      ->type_name("X")
      ->capture_default_str();
  command->add_option("--max-iterations", a.max_iterations, "of the optimiser")
      ->type_name("N")
      ->capture_default_str();
  command->callback([arguments, &exit_status] { exit_status = RunPoseGraph(*arguments); });
}

}  // namespace armature
