// SPDX-License-Identifier: BSD-3-Clause
#include "eval/report/report_sources.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <set>

#include "eval/report/ablation_bars.h"
#include "eval/report/headline.h"
#include "eval/report/overlay_frames.h"
#include "eval/report/report_plots.h"
#include "eval/report/reported_bench.h"
#include "eval/report/retrieval_strips.h"
#include "eval/report/run_environment.h"
#include "eval/report/scene_view.h"
#include "eval/report/sequence_runs.h"
#include "eval/report/top_down_map.h"

namespace armature {
namespace {

template <typename T>
void AddAll(std::vector<T> more, std::vector<T>& all) {
  std::move(more.begin(), more.end(), std::back_inserter(all));
}

// Of a table of `armature eval`, by its name.
ReportSection FindSection(const std::string& table) {
  if (table == "rooms") return ReportSection::kOverview;
  if (table == "normal") return ReportSection::kAblation;
  for (const char* name : {"retrieval", "retrieval_variants", "each_query", "library"}) {
    if (table == name) return ReportSection::kRetrieval;
  }
  for (const char* name :
       {"room_differences", "stability", "worst_rooms", "room_factors", "room_groups", "paper", "objects",
        "each_object", "trajectory", "observations", "observations_ok", "edges"}) {
    if (table == name) return ReportSection::kAccuracy;
  }
  return ReportSection::kFurther;
}

// What is looked for first comes first, whatever the order in which it was evaluated.
std::vector<Table> ByImportance(std::vector<Table> tables) {
  constexpr std::array kFirst{"rooms",        "room_differences", "stability", "worst_rooms",
                              "room_factors", "room_groups",      "paper",     "objects",
                              "trajectory",   "observations",     "edges"};
  const auto place = [&](const Table& table) { return std::find(kFirst.begin(), kFirst.end(), table.name); };
  std::stable_sort(tables.begin(), tables.end(),
                   [&](const Table& a, const Table& b) { return place(a) < place(b); });
  return tables;
}

void AddTables(const ReportSources& sources, ReportData& data) {
  for (const Table& table : sources.overview) data.tables.push_back({ReportSection::kOverview, table});
  for (Table& table : ByImportance(sources.tables)) {
    const ReportSection section = FindSection(table.name);
    data.tables.push_back({section, std::move(table)});
  }
  AddAll(LocalizationFigures(sources.records), data.headline);
  data.distributions = DrawRoomErrors(sources.records.room_errors, data.remarks);
  data.ablations = DrawAblationBars(NormalTermBars(sources.records.uprightness), data.remarks);
}

// The headline is of the first benchmark that has one.
void AddBenches(const ReportSources& sources, ReportData& data) {
  bool has_headline = false;
  for (const std::filesystem::path& folder : sources.benches) {
    const ReportedBench bench = ReadReportedBench(folder);
    for (const Table& table : bench.tables) data.tables.push_back({ReportSection::kTiming, table});
    AddAll(DrawStageBars(MakeStageBars(bench), bench.objects, data.remarks), data.stages);
    AddAll(DrawTimeCurves(bench.curves, data.remarks), data.curves);
    MergeEnvironment(bench.environment, data.environment);
    if (has_headline) continue;
    std::vector<HeadlineFigure> figures = TimingFigures(bench);
    has_headline = !figures.empty();
    AddAll(std::move(figures), data.headline);
  }
}

void AddSequence(const SequenceRuns& sequence, const ReportSources& sources, ReportData& data) {
  if (auto map = MakeTopDownMap(sequence)) {
    data.maps.push_back(std::move(*map));
  } else {
    data.remarks.push_back(fmt::format("{}: no run has a map with objects", sequence.name));
  }
  AddAll(MakeOverlayFrames(sequence, sources.models, data.remarks), data.overlays);
  std::vector<RetrievalStrip> strips = MakeRetrievalStrips(sequence, sources.library, data.remarks);
  AddAll(std::move(strips), data.strips);
  if (auto scene = MakeSceneView(sequence, sources.models, sources.library, data.remarks))
    data.scenes.push_back(std::move(*scene));
}

// Of the first run of each sequence, which is the one that is shown.
void RemarkOnRetrieval(const std::vector<SequenceRuns>& sequences, ReportData& data) {
  std::vector<std::string> without;
  for (const SequenceRuns& sequence : sequences) {
    const bool has_models =
        std::any_of(data.strips.begin(), data.strips.end(),
                    [&](const RetrievalStrip& strip) { return strip.sequence == sequence.name; });
    if (!has_models && sequence.runs.front().map) without.push_back(sequence.name);
  }
  if (!without.empty())
    data.remarks.push_back(fmt::format("No CAD models were retrieved for {}; see `armature retrieve`",
                                       fmt::join(without, ", ")));
}

// The maps of rooms are of the worst ones: many rooms are no page.
void RemarkOnRooms(const EvaluationRecords& records, size_t shown, ReportData& data) {
  long rooms = 0;
  for (const RoomStatisticRecord& record : records.rooms) rooms = std::max(rooms, record.rooms);
  if (rooms > static_cast<long>(shown) && !records.worst_rooms.empty())
    data.remarks.push_back(
        fmt::format("Tables are of {} rooms; maps and pictures of the {} in which '{}' did worst", rooms,
                    shown, records.worst_rooms.front().run));
}

// Each once, in their order.
void RemoveRepeated(std::vector<std::string>& texts) {
  std::set<std::string> seen;
  std::erase_if(texts, [&](const std::string& text) { return !seen.insert(text).second; });
}

}  // namespace

ReportData CollectReport(const ReportSources& sources) {
  ReportData data;
  data.title = sources.title;
  AddTables(sources, data);
  for (const ReportSources::Run& run : sources.runs)
    MergeEnvironment(RunEnvironment(run.folder), data.environment);
  AddBenches(sources, data);
  AddAll(RetrievalFigures(sources.records), data.headline);
  const std::vector<SequenceRuns> sequences = LoadSequenceRuns(sources, data.remarks);
  RemarkOnRooms(sources.records, sequences.size(), data);
  for (const SequenceRuns& sequence : sequences) AddSequence(sequence, sources, data);
  RemarkOnRetrieval(sequences, data);
  if (!data.strips.empty() && sources.library.categories.empty())
    data.remarks.push_back("Retrieved CAD models are not drawn: no library is given; name it with --library");
  RemoveRepeated(data.remarks);
  return data;
}

}  // namespace armature
