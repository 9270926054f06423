// SPDX-License-Identifier: BSD-3-Clause
#include "app/retrieve/retrieve_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "app/retrieve/place_models.h"
#include "app/retrieve/retrieval_files.h"
#include "app/retrieve/retrieve_run.h"
#include "base/console.h"
#include "base/errors.h"
#include "base/interrupt.h"
#include "base/number_format.h"
#include "base/progress.h"
#include "cli/help.h"
#include "cli/instance_libraries.h"
#include "cli/printed_tables.h"
#include "io/index_file.h"
#include "io/library_file.h"
#include "io/run_folder.h"
#include "io/run_results.h"
#include "io/text_table.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

constexpr int kMostColumns = 5;

std::string InstanceText(const ObjectInstances& found, const RetrievedInstance& instance) {
  return fmt::format("{} ({})", found.library->ids[static_cast<size_t>(instance.instance)],
                     Fixed(instance.fit ? instance.fit->cost : instance.distance, 2));
}

std::string NumberMeaning(const RetrievalOptions& options) {
  if (options.rerank) {
    return "in brackets: what re-ranking orders by, the mean over the views of the cost of visible edges "
           "without segment and of the box; smaller is better";
  }
  if (options.covariance) {
    return "in brackets: distance from the estimated coefficients in standard deviations of their covariance";
  }
  return options.features.space == FeatureSpace::kRaw
             ? "in brackets: distance of the coefficients in metres"
             : "in brackets: distance of the coefficients in standard deviations";
}

// A row an object: its nearest instances with their distances, or what their edges leave unexplained.
Table RetrievalTable(const std::vector<RunRetrieval>& runs, const RetrievalOptions& options) {
  const int columns = std::min(options.k, kMostColumns);
  Table table{.title = "Nearest CAD models", .columns = {"run", "object", "views"}, .rows = {}, .notes = {}};
  for (int i = 0; i < columns; ++i) table.columns.push_back(fmt::format("{}", i + 1));
  for (const RunRetrieval& run : runs) {
    for (const ObjectInstances& found : run.objects) {
      const MapObject& object = run.map.objects[found.object];
      std::vector<Cell> row{TextCell(run.sequence), TextCell(object.id), CountCell(object.observations)};
      for (size_t i = 0; i < static_cast<size_t>(columns); ++i) {
        row.push_back(i < found.instances.size() ? TextCell(InstanceText(found, found.instances[i]))
                                                 : NoCell());
      }
      table.rows.push_back(std::move(row));
    }
  }
  table.notes = {"views: detections that the map explains with the object", NumberMeaning(options)};
  if (options.k > kMostColumns)
    table.notes.push_back(fmt::format("the {} nearest of each are in retrieval.csv of the runs", options.k));
  return table;
}

// A row a category.
Table LibraryTable(const InstanceLibrary& library) {
  Table table{.title = "Library of instances",
              .columns = {"category", "instances", "with surface", "coefficients"},
              .rows = {},
              .notes = {"with surface: has a mesh or boxes, which placing and surface distances need"}};
  for (const CategoryInstances& instances : library.categories) {
    const auto without = std::count(instances.geometries.begin(), instances.geometries.end(), "");
    table.rows.push_back({TextCell(instances.category), CountCell(instances.size()),
                          CountCell(instances.size() - without), CountCell(instances.coefficients.rows())});
  }
  return table;
}

void CheckArguments(const RetrieveArguments& arguments) {
  if (arguments.build) {
    if (arguments.cad.empty() || arguments.out.empty())
      throw InputError(
          "retrieve: --build needs --cad DIR, the annotated CAD models, and --out FILE, the library");
    if (!arguments.runs.empty() || !arguments.library.empty())
      throw InputError("retrieve: --build makes a library and looks at no run; build first, then retrieve");
    return;
  }
  if (arguments.runs.empty()) throw InputError("retrieve: give run folders, or --build to make a library");
  if (arguments.library.empty())
    throw InputError(
        "retrieve: give --library FILE; make one with 'armature retrieve --build --cad DIR --out FILE'");
  if (!arguments.cad.empty() || !arguments.out.empty() || arguments.save_index)
    throw InputError(
        "retrieve: --cad, --out and --save-index are about --build; results go into the run folders");
}

// An index of an older library under this name would be refused with the new one.
void WriteIndices(const fs::path& file, const InstanceLibrary& library,
                  const std::vector<CategoryModel>& models, const RetrieveArguments& arguments) {
  const RetrievalOptions options = LoadRetrievalOptions(arguments.retrieval);
  for (const CategoryModel& model : models) {
    std::error_code absent;
    fs::remove(IndexFile(file, model.spec.name), absent);
    const CategoryInstances* instances = library.Of(model.spec.name);
    if (arguments.save_index && instances)
      WriteIndex(BuildIndex(model, *instances, options), IndexFile(file, model.spec.name));
  }
}

int Build(const RetrieveArguments& arguments, TableFormat format) {
  const std::vector<CategoryModel> models = LoadModels(arguments.configuration);
  const InstanceLibrary library = BuildFolderLibrary(arguments.cad, models);
  WriteLibrary(library, arguments.out);
  WriteIndices(arguments.out, library, models, arguments);
  PrintResult(FormatTables({LibraryTable(library)}, format));
  return 0;
}

// What the user would otherwise wonder at.
void NoteShortages(const RunRetrieval& run, const OpenLibrary& library, const RetrievalOptions& options) {
  for (const ObjectInstances& found : run.objects) {
    const std::string& category = run.map.objects[found.object].model->spec.name;
    if (!found.library) {
      Note(fmt::format("{}: {} has no instance: the library has no {}", run.sequence,
                       run.map.objects[found.object].id, category));
    }
  }
  for (const CategoryInstances& instances : library.library.categories) {
    if (instances.size() >= options.k) continue;
    Note(fmt::format("the library has {} {}s, fewer than retrieval.k = {}: all of them are listed",
                     instances.size(), instances.category, options.k));
  }
}

void WritePlaced(const RunRetrieval& run, const fs::path& root, const fs::path& folder) {
  const PlacedScene placed = PlaceModels(run, root);
  for (const std::string& line : placed.missing) Note(line);
  WriteScene(placed.scene, folder);
}

// All files at once: beside the run's own in a folder that then takes its place.
void WriteResults(const RunRetrieval& run, const RetrieveArguments& arguments, const fs::path& root) {
  RunFolder results(run.run);
  results.TakeOver();
  if (arguments.place) WritePlaced(run, root, results.partial());
  WriteRetrieval(run, results.partial());
  results.Publish();
}

int Retrieve(const RetrieveArguments& arguments, TableFormat format) {
  const RetrievalOptions options = LoadRetrievalOptions(arguments.retrieval);
  const std::vector<CategoryModel> models = LoadModels(arguments.configuration);
  const auto library = OpenLibraryFile(arguments.library, models, options);
  std::vector<fs::path> folders;
  for (const fs::path& given : arguments.runs) {
    for (const fs::path& run : RunsIn(given)) folders.push_back(run);
  }
  Progress progress("retrieval: runs", static_cast<long>(folders.size()));
  std::vector<RunRetrieval> runs;
  std::vector<std::string> finished;
  for (const fs::path& folder : folders) {
    runs.push_back(InterruptedAfter(finished, [&] {
      RunRetrieval run = RetrieveRun(folder, arguments.sequence, models, *library, options);
      WriteResults(run, arguments, library->library.root);
      return run;
    }));
    finished.push_back(folder.string());
    NoteShortages(runs.back(), *library, options);
    progress.Step();
  }
  PrintResult(FormatTables({RetrievalTable(runs, options)}, format));
  return 0;
}

CommandHelp RetrieveHelp() {
  return {
      .description =
          "Names the CAD models of a library that are nearest to each object of finished runs: by the shape "
          "coefficients, weighed by what the images say of them, then ordered by how well each model's own "
          "edges explain the segments of the images. With --build it makes the library, from annotated CAD "
          "models.",
      .files = {{"RUN/retrieval.csv", "a row an instance, nearest first; objects.csv names the nearest, too"},
                {"RUN/map.ply, map.png", "with --place: the map with the CAD models in it"},
                {"OUT", "with --build: the library; with --save-index its search indices beside it"}},
      .exit_status = {},
      .examples = {
          {"a library of the generated CAD models",
           "armature retrieve --build --cad datasets/generated/cad --categories "
           "results/reproduce/categories --out runs/instances.armlib"},
          {"the three nearest to each object of all runs, placed in the map",
           "armature retrieve results/reproduce/runs/objects --library results/reproduce/library.armlib "
           "--categories results/reproduce/categories --place --set retrieval.k=3"}}};
}

}  // namespace

int RunRetrieve(const RetrieveArguments& arguments) {
  const TableFormat format = arguments.json ? TableFormat::kJson : TableFormatFromName(arguments.format);
  CheckArguments(arguments);
  return arguments.build ? Build(arguments, format) : Retrieve(arguments, format);
}

void AddRetrieveCommand(CLI::App& app, int& exit_status) {
  const auto arguments = std::make_shared<RetrieveArguments>();
  RetrieveArguments& a = *arguments;
  CLI::App* retrieve = app.add_subcommand("retrieve", "Name the CAD models nearest to each object of runs");
  Describe(*retrieve, RetrieveHelp());
  BeginSection(*retrieve, "Retrieving");
  retrieve->add_option("RUN", a.runs, "run folders, or folders of run folders")->type_name("DIR");
  retrieve->add_option("--library", a.library, "library of instances")->type_name("FILE");
  retrieve
      ->add_option("--sequence", a.sequence, "sequence folder, for re-ranking (default: where the run says)")
      ->type_name("DIR");
  retrieve->add_flag("--place", a.place, "also write map.ply and map.png: the map with the CAD models in it");
  BeginSection(*retrieve, "Building a library");
  retrieve->add_flag("--build", a.build, "make a library instead: --cad DIR --out FILE");
  retrieve->add_option("--cad", a.cad, "folder of annotated CAD models (datasets/README.md)")
      ->type_name("DIR");
  retrieve->add_option("--out", a.out, "library file to write")->type_name("FILE");
  retrieve->add_flag("--save-index", a.save_index, "also write its search indices beside it");
  BeginSection(*retrieve, "Output");
  AddFormatArguments(*retrieve, a.format, a.json);
  AddCategoriesArguments(*retrieve, a.configuration);
  AddRetrievalArguments(*retrieve, a.retrieval);
  retrieve->callback([arguments, &exit_status] { exit_status = RunRetrieve(*arguments); });
}

}  // namespace armature
