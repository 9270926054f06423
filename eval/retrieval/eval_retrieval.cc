// SPDX-License-Identifier: BSD-3-Clause
#include "eval/retrieval/eval_retrieval.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>

#include "base/errors.h"
#include "base/interrupt.h"
#include "base/progress.h"
#include "category/category_lookup.h"
#include "cli/configuration.h"
#include "cli/help.h"
#include "cli/instance_libraries.h"
#include "eval/retrieval/retrieval_tables.h"
#include "eval/retrieval/retrieval_variant_tables.h"
#include "io/library_file.h"
#include "io/run_map.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

InstanceLibrary ReadNamedLibrary(const RetrievalTableArguments& arguments,
                                 const std::vector<CategoryModel>& models) {
  if (!arguments.library.empty()) return ReadLibrary(arguments.library, models);
  throw InputError(
      "the tables of retrieval are of a library of instances; name its file with --library "
      "(`armature retrieve --build` makes one)");
}

void CheckHasShapes(const RunToEvaluate& run) {
  for (const char* file : {"objects.csv", "shape_evidence.csv"}) {
    if (run.HasResult(file)) continue;
    throw InputError(
        fmt::format("{}: has no {}, which retrieval needs; run `armature run` on the sequence again",
                    run.run.folder.string(), file));
  }
}

// Each image is read once. The queries point to sequence and models.
std::vector<RetrievalQuery> MakeRunQuery(const RunToEvaluate& run, const Sequence& sequence,
                                         const std::vector<CategoryModel>& models, int most_views) {
  const fs::path& folder = run.run.folder;
  const RunResults results = LoadRun(folder);
  const Map map = ReadRunMap(results, models);
  const GroundTruth truth = TruthOfRun(LoadGroundTruth(run.truth), results);
  const ObjectPairs pairs = PairsBySight(map, results, truth);
  const ViewsOfCameras views =
      MakeViews(map, PickCameras(map, pairs, most_views), sequence, models, ReadRunOptions(folder));
  return MakeMapQueries(map, pairs, truth, views, most_views);
}

// Sequences are added: the queries point to them.
std::vector<RetrievalQuery> MakeRunQueries(const std::vector<RunToEvaluate>& runs,
                                           const std::vector<CategoryModel>& models,
                                           std::deque<Sequence>& sequences) {
  for (const RunToEvaluate& run : runs) CheckHasShapes(run);
  std::vector<RetrievalQuery> all;
  for (const RunToEvaluate& run : runs) {
    sequences.push_back(LoadSequence(run.truth, CategoryNames(models), {}, run.run.detections));
    for (RetrievalQuery& query : MakeRunQuery(run, sequences.back(), models, RetrievalOptions().views)) {
      query.run = run.name;
      query.sequence = run.run.sequence;
      all.push_back(std::move(query));
    }
  }
  return all;
}

bool IsNeeded(const std::string& variant, const std::vector<std::string>& tables) {
  const auto has = [&](const char* name) {
    return std::find(tables.begin(), tables.end(), name) != tables.end();
  };
  if (has("retrieval_variants") || variant == kDefaultVariant) return true;
  return has("each_query") && (variant == kPlainVariant || variant == kCovarianceVariant);
}

void EvaluateVariants(const std::vector<RetrievalVariant>& variants, RetrievalEvaluation& evaluation,
                      EvaluatedQueries& evaluated) {
  Progress progress("retrieval: variants", static_cast<long>(variants.size()));
  for (const RetrievalVariant& variant : variants) {
    ThrowIfInterrupted();
    evaluated.variants.push_back({variant, evaluation.Evaluate(variant.options)});
    progress.Step();
  }
}

void CheckArguments(const RetrievalTableArguments& arguments) {
  if (!(arguments.noise >= 0) || std::isinf(arguments.noise))
    throw InputError(fmt::format("--noise {:g}: give standard deviations, 0 or more", arguments.noise));
  if (arguments.every < 1) throw InputError(fmt::format("--every {}: give 1 or more", arguments.every));
}

}  // namespace

void AddRetrievalTableArguments(CLI::App& command, RetrievalTableArguments& a) {
  BeginSection(command, "Retrieval");
  command
      .add_option(
          "--library", a.library,
          "library of CAD instances, for the tables of retrieval; true models that it does not have are "
          "looked for in --cad")
      ->type_name("FILE");
  command.add_option("--noise", a.noise, "table library: noise of the coefficients, standard deviations")
      ->capture_default_str();
  command.add_option("--every", a.every, "table library: each so many-th instance of a category is a query")
      ->capture_default_str();
  command.add_option("--seed", a.seed, "table library: of the noise")->capture_default_str();
}

Evaluation MakeRunRetrievalTables(const std::vector<RunToEvaluate>& runs,
                                  const std::vector<CategoryModel>& models,
                                  const std::vector<std::string>& names, const fs::path& cad,
                                  const RetrievalTableArguments& arguments) {
  const InstanceLibrary library = ReadNamedLibrary(arguments, models);
  std::optional<InstanceLibrary> of_cad;
  if (!cad.empty()) of_cad = BuildFolderLibrary(cad, models);
  std::deque<Sequence> sequences;
  EvaluatedQueries evaluated{MakeRunQueries(runs, models, sequences), {}};
  RetrievalEvaluation evaluation(evaluated.queries, models, library, of_cad ? *of_cad : library,
                                 kSurfacePoints);
  std::vector<RetrievalVariant> variants = VariantsForSeen();
  std::erase_if(variants, [&](const RetrievalVariant& v) { return !IsNeeded(v.name, names); });
  EvaluateVariants(variants, evaluation, evaluated);
  Evaluation made;
  for (const std::string& name : names) {
    if (name == "retrieval") {
      evaluated.baselines = evaluation.Baselines();
      made.tables.push_back(RetrievalTable(evaluated));
      made.records.retrieval = MakeRetrievalRecords(evaluated);
    } else if (name == "retrieval_variants") {
      made.tables.push_back(RetrievalVariantTable(evaluated, models));
    } else {
      made.tables.push_back(EachQueryTable(evaluated, library));
    }
  }
  return made;
}

Table MakeLibraryTable(const std::vector<CategoryModel>& models, const RetrievalTableArguments& arguments) {
  CheckArguments(arguments);
  const InstanceLibrary library = ReadNamedLibrary(arguments, models);
  EvaluatedQueries evaluated;
  for (const CategoryInstances& instances : library.categories) {
    for (RetrievalQuery& query :
         MakeLibraryQueries(instances, arguments.every, arguments.noise, arguments.seed))
      evaluated.queries.push_back(std::move(query));
  }
  RetrievalEvaluation evaluation(evaluated.queries, models, library, library, kSurfacePoints);
  EvaluateVariants(VariantsForShapes(), evaluation, evaluated);
  return LibraryTable(
      evaluated, models, library,
      fmt::format("one in {} instances of a category, each of its coefficients with noise of {:g} standard "
                  "deviations, seed {}",
                  arguments.every, arguments.noise, arguments.seed));
}

}  // namespace armature
