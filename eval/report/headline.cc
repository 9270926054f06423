// SPDX-License-Identifier: BSD-3-Clause
#include "eval/report/headline.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/number_format.h"
#include "base/paper_figures.h"
#include "eval/objects/run_objects.h"
#include "io/named_span.h"

namespace armature {
namespace {

constexpr const char* kPapersMethod = "Ours";  // in the paper's table

// Only the embedded sequences are made after the paper's.
const PaperRecord* FindPaperRecord(const EvaluationRecords& records, const std::string& sequence) {
  if (!sequence.starts_with("seq")) return nullptr;
  const auto found = std::find_if(records.paper.begin(), records.paper.end(), [&](const PaperRecord& record) {
    return record.sequence == sequence.substr(3) && record.approach == kPapersMethod;
  });
  return found == records.paper.end() ? nullptr : &*found;
}

// By detections where there is such a record of the same map, as the paper's table has it.
bool IsOfPaperTable(const ObjectRecord& record, const EvaluationRecords& records) {
  if (record.category || record.matched_by == MatchedBy::kDetections) return !record.category;
  return std::none_of(records.objects.begin(), records.objects.end(), [&](const ObjectRecord& other) {
    return other.matched_by == MatchedBy::kDetections && other.sequence == record.sequence &&
           other.run == record.run && other.approach == record.approach;
  });
}

HeadlineFigure LocalizationFigure(const ObjectRecord& ours, const PaperRecord* paper) {
  HeadlineFigure figure;
  figure.label = fmt::format("Localization error on {}, average", ours.sequence);
  figure.ours_value = ours.object_error_mean_m;
  figure.ours = Fixed(*ours.object_error_mean_m, 4) + " m";
  figure.remark = fmt::format("{} objects; {} ({})", ours.found, ApproachTitle(ours.approach), ours.run);
  if (paper != nullptr) {
    figure.paper_value = paper->object_error_mean_m;
    figure.paper = fmt::format("{} m", paper->object_error_mean_m);
    figure.remark += fmt::format("; the paper's is of {} objects in a sequence of its own", paper->objects);
  }
  return figure;
}

HeadlineFigure TimeFigure(const std::string& label, double ours_ms, double paper_ms,
                          const std::string& remark) {
  return {label, Fixed(ours_ms, 2) + " ms", Fixed(paper_ms, 2) + " ms", ours_ms, paper_ms, remark};
}

// The paired ratio of the baseline over ours.
std::optional<HeadlineFigure> RatioFigure(const ReportedBench& bench, const std::string& sequence,
                                          const std::string& engine, const std::string& baseline) {
  const auto found = std::find_if(bench.ratios.begin(), bench.ratios.end(), [&](const NamedRatio& r) {
    return r.sequence == sequence && r.contender == baseline && r.reference == engine;
  });
  if (found == bench.ratios.end()) return std::nullopt;
  const double ratio = found->ratio.median;
  const double n = static_cast<double>(bench.objects);
  const double paper_ratio = paper::KeypointsMs(n) / paper::LinesMs(n);
  return HeadlineFigure{
      "Faster than the keypoint network",
      Fixed(ratio, 1) + " times",
      Fixed(paper_ratio, 2) + " times",
      ratio,
      paper_ratio,
      fmt::format("median ratio on the same frames of {}, on one machine: the figure to compare", sequence)};
}

// The chairs of the first run: of all its sequences, where there is such a record.
const RetrievalRecord* FindChairs(const std::vector<RetrievalRecord>& records) {
  const RetrievalRecord* chairs = nullptr;
  for (const RetrievalRecord& record : records) {
    if (record.run != records.front().run || record.category != "chair") continue;
    if (!record.sequence) return &record;
    if (chairs == nullptr) chairs = &record;
  }
  return chairs;
}

}  // namespace

std::vector<HeadlineFigure> LocalizationFigures(const EvaluationRecords& records) {
  std::vector<HeadlineFigure> figures;
  std::set<std::string> shown;
  for (const ObjectRecord& record : records.objects) {
    const bool is_ours = record.approach != Approach::kOdometryOnly && record.object_error_mean_m &&
                         IsOfPaperTable(record, records);
    if (is_ours && shown.insert(record.sequence).second)
      figures.push_back(LocalizationFigure(record, FindPaperRecord(records, record.sequence)));
  }
  return figures;
}

std::vector<HeadlineFigure> TimingFigures(const ReportedBench& bench) {
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

std::vector<HeadlineFigure> RetrievalFigures(const EvaluationRecords& records) {
  const RetrievalRecord* found = FindChairs(records.retrieval);
  if (found == nullptr) return {};
  const std::string chairs =
      fmt::format("{} chairs of {}", found->queries, found->sequence.value_or("all sequences"));
  std::vector<HeadlineFigure> figures;
  const auto add = [&](const char* label, const std::optional<double>& value, double unit, int digits,
                       const char* unit_name, const std::string& remark) {
    if (value)
      figures.push_back(
          {label, Fixed(*value * unit, digits) + unit_name, "", *value * unit, std::nullopt, remark});
  };
  add("Chair's true CAD model found first", found->top_1_share, 100, 1, " %",
      chairs + "; the paper gives no number");
  add("... among the first five", found->top_5_share, 100, 1, " %", chairs);
  add("Chair surfaces apart (Chamfer)", found->chamfer_m, 100, 2, " cm",
      chairs + ", their true models taken out of the library");
  return figures;
}

}  // namespace armature
