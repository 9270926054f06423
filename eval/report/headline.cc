// SPDX-License-Identifier: BSD-3-Clause
#include "eval/report/headline.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/number_format.h"
#include "base/paper_figures.h"
#include "eval/report/table_lookup.h"
#include "io/named_span.h"

namespace armature {
namespace {

constexpr const char* kPaperPrefix = "paper ";  // of the paper's own sequences in the table "paper"

// Only the embedded sequences are made after the paper's.
std::optional<TableRow> PaperRowFor(const Table& table, const std::string& sequence) {
  if (!sequence.starts_with("seq")) return std::nullopt;
  return FindRow(table, [&](const TableRow& row) {
    return row.Text("Sequence") == kPaperPrefix + sequence.substr(3) && row.Text("Approach") == "Ours";
  });
}

HeadlineFigure LocalizationFigure(const Table& table, const TableRow& ours) {
  const std::string sequence = ours.Text("Sequence");
  HeadlineFigure figure;
  figure.label = fmt::format("Localization error on {}, average", sequence);
  figure.ours_value = ours.Number("Average");
  figure.ours = ours.Text("Average") + " m";
  figure.remark = fmt::format("{} objects; {}", ours.Text("# Objects"), ours.Text("Approach"));
  if (const auto paper = PaperRowFor(table, sequence)) {
    figure.paper_value = paper->Number("Average");
    figure.paper = paper->Text("Average") + " m";
    figure.remark +=
        fmt::format("; the paper's is of {} objects in a sequence of its own", paper->Text("# Objects"));
  }
  return figure;
}

HeadlineFigure TimeFigure(const std::string& label, double ours_ms, double paper_ms,
                          const std::string& remark) {
  return {label, Fixed(ours_ms, 2) + " ms", Fixed(paper_ms, 2) + " ms", ours_ms, paper_ms, remark};
}

// The paired ratio of the baseline over ours, as the table of ratios has it.
std::optional<HeadlineFigure> RatioFigure(const BenchResults& bench, const std::string& sequence,
                                          const std::string& engine, const std::string& baseline) {
  const std::string column = "times " + engine;
  for (const Table* table : TablesNamed(bench.tables, "comparison")) {
    if (table->sequence != sequence) continue;
    const auto row = FindRow(*table, [&](const TableRow& r) { return r.Text("engine") == baseline; });
    const auto ratio = row ? row->Number(column) : std::nullopt;
    if (!ratio) continue;
    const double n = static_cast<double>(bench.objects);
    const double paper_ratio = paper::KeypointsMs(n) / paper::LinesMs(n);
    return HeadlineFigure{
        "Faster than the keypoint network",
        Fixed(*ratio, 1) + " times",
        Fixed(paper_ratio, 2) + " times",
        ratio,
        paper_ratio,
        fmt::format("median ratio on the same frames of {}, on one machine: the figure to compare",
                    sequence)};
  }
  return std::nullopt;
}

}  // namespace

std::vector<HeadlineFigure> LocalizationFigures(const std::vector<Table>& tables) {
  std::vector<HeadlineFigure> figures;
  for (const Table* table : TablesNamed(tables, "paper")) {
    std::set<std::string> shown;
    for (const std::vector<Cell>& cells : table->rows) {
      const TableRow row(*table, cells);
      const bool is_ours = !row.Text("Sequence").starts_with(kPaperPrefix) &&
                           row.Text("Approach").starts_with("objects") && row.Number("Average");
      if (is_ours && shown.insert(row.Text("Sequence")).second)
        figures.push_back(LocalizationFigure(*table, row));
    }
  }
  return figures;
}

std::vector<HeadlineFigure> TimingFigures(const BenchResults& bench) {
  const auto is_total = [](const NamedSpan& s) { return s.table == "comparison" && s.stage == kTotal; };
  const auto ours = std::find_if(bench.spans.begin(), bench.spans.end(), is_total);
  if (ours == bench.spans.end()) return {};
  const double n = static_cast<double>(bench.objects);
  std::vector<HeadlineFigure> figures{
      TimeFigure(fmt::format("A frame with {} objects, lines", bench.objects), ours->milliseconds.median,
                 paper::LinesMs(n),
                 fmt::format("{} on {}, median total; the paper's machine is another one: compare the ratios",
                             ours->contender, ours->sequence))};
  const auto baseline = std::find_if(bench.spans.begin(), bench.spans.end(), [&](const NamedSpan& s) {
    return is_total(s) && s.sequence == ours->sequence && s.contender.starts_with("keypoints:");
  });
  if (baseline == bench.spans.end()) return figures;
  if (auto ratio = RatioFigure(bench, ours->sequence, ours->contender, baseline->contender))
    figures.push_back(std::move(*ratio));
  figures.push_back(TimeFigure(fmt::format("The same {} objects, keypoint network", bench.objects),
                               baseline->milliseconds.median, paper::KeypointsMs(n),
                               baseline->contender + "; the paper's ran on a Titan X"));
  return figures;
}

std::vector<HeadlineFigure> RetrievalFigures(const std::vector<Table>& tables) {
  const std::vector<const Table*> named = TablesNamed(tables, "retrieval");
  if (named.empty() || named.front()->rows.empty()) return {};
  const Table& table = *named.front();
  const std::string run = TableRow(table, table.rows.front()).Text("run");
  const auto is_chairs = [&](const TableRow& row) {
    return row.Text("run") == run && row.Text("category") == "chair";
  };
  auto row = FindRow(table, [&](const TableRow& r) { return is_chairs(r) && r.Text("sequence") == "all"; });
  if (!row) row = FindRow(table, is_chairs);
  if (!row) return {};
  const std::string sequence = row->Text("sequence");
  const std::string chairs =
      fmt::format("{} chairs of {}", row->Text("queries"), sequence == "all" ? "all sequences" : sequence);
  std::vector<HeadlineFigure> figures;
  const auto add = [&](const char* label, const char* column, const char* unit, const std::string& remark) {
    if (const auto value = row->Number(column))
      figures.push_back({label, row->Text(column) + unit, "", value, std::nullopt, remark});
  };
  add("Chair's true CAD model found first", "top-1 [%]", " %", chairs + "; the paper gives no number");
  add("... among the first five", "top-5 [%]", " %", chairs);
  add("Chair surfaces apart (Chamfer)", "Chamfer [cm]", " cm",
      chairs + ", their true models taken out of the library");
  return figures;
}

}  // namespace armature
