// SPDX-License-Identifier: BSD-3-Clause
#include "eval/objects/paper_object_errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/errors.h"
#include "io/csv.h"

namespace armature {
namespace {

// Half a unit of the last printed digit.
double FindRounding(const std::string& printed) {
  const size_t point = printed.find('.');
  const size_t digits = point == std::string::npos ? 0 : printed.size() - point - 1;
  return 0.5 * std::pow(10.0, -static_cast<double>(digits));
}

double Value(const std::string& printed) { return ParseNumber(printed, "a printed number"); }

// n numbers of which one is the best and one the worst average at least ((n - 1) best + worst) / n, and at
// most (best + (n - 1) worst) / n.
std::vector<std::string> OddAverage(const PaperObjectErrors& row) {
  const double n = row.objects, best = Value(row.best), worst = Value(row.worst),
               average = Value(row.average);
  const double least = ((n - 1) * best + worst) / n, most = (best + (n - 1) * worst) / n;
  const double rounding = FindRounding(row.best) + FindRounding(row.average);
  const std::string start = fmt::format("paper {}, {}: {} objects between {} and {} average {}", row.sequence,
                                        row.approach, row.objects, row.best, row.worst, row.average);
  if (average < least - rounding || average > most + rounding)
    return {start + ", which cannot be; kept as printed."};
  if (row.objects < 3) return {};  // the other one or two are the best or the worst
  if (average < least + rounding) return {start + " only if all but one are the best; kept as printed."};
  if (average > most - rounding) return {start + " only if all but one are the worst; kept as printed."};
  return {};
}

std::vector<std::string> WorseThanTheFirst(const std::vector<PaperObjectErrors>& paper) {
  std::vector<std::string> notes;
  std::map<std::string, const PaperObjectErrors*> firsts;
  for (const PaperObjectErrors& row : paper) {
    const PaperObjectErrors& first = *firsts.emplace(row.sequence, &row).first->second;
    std::vector<std::string> worse;
    const auto compare = [&](const char* what, const std::string& value, const std::string& reference) {
      if (Value(value) > Value(reference))
        worse.push_back(fmt::format("{} ({} > {})", what, value, reference));
    };
    compare("best", row.best, first.best);
    compare("worst", row.worst, first.worst);
    compare("average", row.average, first.average);
    if (worse.empty()) continue;
    notes.push_back(fmt::format("paper {}: {} is worse than {} in {}.", row.sequence, row.approach,
                                first.approach, fmt::join(worse, ", ")));
  }
  return notes;
}

// Of all its objects: by detections, where observations name objects.
ObjectRecord MakePaperLikeRecord(const SequenceObjects& sequence, const NamedObjects& run,
                                 const EvaluatedMap& map) {
  return MakeObjectRecord(sequence, run, map,
                          map.by_detections.empty() ? MatchedBy::kDistance : MatchedBy::kDetections,
                          std::nullopt);
}

// How many runs of the sequence have a map by the approach: with several, rows name the run.
std::string ApproachText(const SequenceObjects& sequence, const NamedObjects& run, const EvaluatedMap& map) {
  int count = 0;
  for (const NamedObjects& other : sequence.runs) {
    for (const EvaluatedMap& m : other.objects.maps) count += m.approach == map.approach ? 1 : 0;
  }
  const std::string approach = ApproachTitle(map.approach);
  return count > 1 ? fmt::format("{} ({})", approach, run.run) : approach;
}

std::vector<Cell> OurRow(const std::string& approach, const ObjectRecord& record) {
  std::vector<Cell> row{TextCell(record.sequence), TextCell(approach), CountCell(record.found)};
  for (const auto& metres :
       {record.object_error_best_m, record.object_error_worst_m, record.object_error_mean_m})
    row.push_back(NumberCell(metres, 4));
  return row;
}

std::vector<Cell> PaperRow(const PaperObjectErrors& row) {
  const auto printed = [](const std::string& number) { return Cell{number, true}; };
  return {TextCell("paper " + row.sequence),
          TextCell(row.approach),
          CountCell(row.objects),
          printed(row.best),
          printed(row.worst),
          printed(row.average)};
}

std::string OurNote(const std::string& approach, const ObjectRecord& record, double gate_m) {
  std::string note = fmt::format("{}, {}: {} of {} observed objects, {} spurious.", record.sequence, approach,
                                 record.found, record.observed, record.spurious);
  if (record.matched_by == MatchedBy::kDistance)
    note += fmt::format(" Matched by distance, at most {} m: observations name no objects.", gate_m);
  return note;
}

void AddSequence(const SequenceObjects& sequence, Table& table) {
  for (const NamedObjects& run : sequence.runs) {
    for (const EvaluatedMap& map : run.objects.maps) {
      const ObjectRecord record = MakePaperLikeRecord(sequence, run, map);
      const std::string approach = ApproachText(sequence, run, map);
      table.rows.push_back(OurRow(approach, record));
      table.notes.push_back(OurNote(approach, record, sequence.options.gate_m));
    }
  }
  for (const std::string& note : ObjectNotes(sequence))
    table.notes.push_back(fmt::format("{}: {}", sequence.sequence, note));
}

void AddPaper(const std::vector<PaperObjectErrors>& paper, Table& table) {
  for (const PaperObjectErrors& row : paper) table.rows.push_back(PaperRow(row));
  if (paper.empty()) return;
  table.notes.emplace_back(
      "paper 1, 2, ...: the paper's own numbers, as printed; its sequences are others, rows are not "
      "comparable.");
  table.notes.emplace_back(
      "The paper scales a trajectory by its end points, as --object-alignment end_points does here.");
  for (std::string& note : OddEntries(paper)) table.notes.push_back(std::move(note));
}

}  // namespace

std::vector<PaperObjectErrors> ReadPaperObjectErrors(const std::filesystem::path& file) {
  const CsvTable table(file, {"sequence", "approach", "objects", "best", "worst", "average"});
  std::vector<PaperObjectErrors> rows;
  for (const CsvRow& row : table.rows()) {
    for (const char* column : {"best", "worst", "average"}) row.Number(column);
    if (row.Integer("objects") < 1) throw InputError(row.At("column 'objects' has to be at least 1"));
    rows.push_back({row.Text("sequence"), row.Text("approach"), row.Integer("objects"), row.Text("best"),
                    row.Text("worst"), row.Text("average")});
  }
  return rows;
}

std::vector<PaperRecord> MakePaperRecords(const std::vector<PaperObjectErrors>& paper) {
  std::vector<PaperRecord> records;
  for (const PaperObjectErrors& row : paper)
    records.push_back(
        {row.sequence, row.approach, row.objects, Value(row.best), Value(row.worst), Value(row.average)});
  return records;
}

std::vector<std::string> OddEntries(const std::vector<PaperObjectErrors>& paper) {
  std::vector<std::string> notes = WorseThanTheFirst(paper);
  for (const PaperObjectErrors& row : paper) {
    for (std::string& note : OddAverage(row)) notes.push_back(std::move(note));
  }
  return notes;
}

Table PaperTable(const std::vector<SequenceObjects>& sequences, const std::vector<PaperObjectErrors>& paper) {
  Table table;
  table.title = "Object localization error [m], as the paper tells it";
  table.name = "paper";
  table.columns = {"Sequence", "Approach", "# Objects", "Best", "Worst", "Average"};
  table.notes = {
      "Best, worst, average: distance of the centres, of the objects counted under # Objects. An object of "
      "the",
      "map is the true object that most of its observations are of, however far away it was placed."};
  for (const SequenceObjects& sequence : sequences) AddSequence(sequence, table);
  AddPaper(paper, table);
  return table;
}

}  // namespace armature
