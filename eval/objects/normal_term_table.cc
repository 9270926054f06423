// SPDX-License-Identifier: BSD-3-Clause
#include "eval/objects/normal_term_table.h"

#include <cmath>
#include <numeric>
#include <optional>
#include <stdexcept>

#include "base/statistics.h"
#include "truth/observation_metrics.h"

namespace armature {
namespace {

// Absolute, degrees.
struct Tilts {
  std::vector<double> pitch, roll;

  void Add(double pitch_deg, double roll_deg) {
    pitch.push_back(std::abs(pitch_deg));
    roll.push_back(std::abs(roll_deg));
  }
};

// Of the map with objects in its graph; odometry places the same objects.
Tilts OfMap(const RunObjects& objects) {
  Tilts tilts;
  for (const EvaluatedMap& map : objects.maps) {
    if (map.is_by_odometry()) continue;
    for (const EvaluatedObject& object : map.by_distance) {
      if (object.error) tilts.Add(object.error->orientation.pitch_deg, object.error->orientation.roll_deg);
    }
  }
  return tilts;
}

Tilts OfObservations(const RunEvaluation& evaluation) {
  Tilts tilts;
  for (const EvaluatedDetection& detection : evaluation.detections) {
    if (detection.status == "ok" && detection.error)
      tilts.Add(detection.error->pitch_deg, detection.error->roll_deg);
  }
  return tilts;
}

std::optional<double> FindMean(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

std::optional<double> FindMedian(const std::vector<double>& values) {
  return values.empty() ? std::nullopt : std::optional(Median(values));
}

UprightnessRecord MakeUprightnessRecord(const std::string& sequence, const NamedObjects& run,
                                        const NamedEvaluation& evaluation) {
  const Tilts map = OfMap(run.objects), views = OfObservations(evaluation.evaluation);
  return {.sequence = sequence,
          .run = evaluation.run,
          .normal_term = run.objects.configuration.normal_term,
          .objects = static_cast<long>(map.pitch.size()),
          .object_pitch_mean_deg = FindMean(map.pitch),
          .object_pitch_median_deg = FindMedian(map.pitch),
          .object_roll_mean_deg = FindMean(map.roll),
          .object_roll_median_deg = FindMedian(map.roll),
          .views = static_cast<long>(views.pitch.size()),
          .view_pitch_mean_deg = FindMean(views.pitch),
          .view_pitch_median_deg = FindMedian(views.pitch),
          .view_roll_mean_deg = FindMean(views.roll),
          .view_roll_median_deg = FindMedian(views.roll)};
}

std::vector<Cell> UprightnessRow(const UprightnessRecord& r) {
  std::vector<Cell> row{TextCell(r.run), r.normal_term ? TextCell(*r.normal_term) : NoCell(),
                        CountCell(r.objects)};
  for (const auto& degrees :
       {r.object_pitch_mean_deg, r.object_pitch_median_deg, r.object_roll_mean_deg, r.object_roll_median_deg})
    row.push_back(NumberCell(degrees, 2));
  row.push_back(CountCell(r.views));
  for (const auto& degrees :
       {r.view_pitch_mean_deg, r.view_pitch_median_deg, r.view_roll_mean_deg, r.view_roll_median_deg})
    row.push_back(NumberCell(degrees, 2));
  return row;
}

}  // namespace

std::vector<UprightnessRecord> MakeUprightnessRecords(const SequenceObjects& sequence,
                                                      const std::vector<NamedEvaluation>& evaluations) {
  if (sequence.runs.size() != evaluations.size())
    throw std::invalid_argument("objects and observations are of different runs");
  std::vector<UprightnessRecord> records;
  for (size_t i = 0; i < evaluations.size(); ++i)
    records.push_back(MakeUprightnessRecord(sequence.sequence, sequence.runs[i], evaluations[i]));
  return records;
}

Table NormalTermTable(const SequenceObjects& sequence, const std::vector<NamedEvaluation>& evaluations) {
  Table table;
  table.title = sequence.sequence + ": pitch and roll, and the normal term [deg]";
  table.name = "normal";
  table.sequence = sequence.sequence;
  table.columns = {"run", "normal term"};
  for (const std::string of : {"objects", "observations"}) {
    for (const char* column : {"", ": pitch mean", ": pitch median", ": roll mean", ": roll median"})
      table.columns.push_back(of + column);
  }
  for (const UprightnessRecord& record : MakeUprightnessRecords(sequence, evaluations))
    table.rows.push_back(UprightnessRow(record));
  table.notes = {
      "normal term: resection.normal_term of the run's config.yaml.",
      "objects: those of the map that were found. observations: single views with status ok, of a true "
      "object.",
      "pitch, roll: absolute, of the object's y axis against the true one, about its own x and z axis."};
  for (std::string& note : ObjectNotes(sequence)) table.notes.push_back(std::move(note));
  return table;
}

}  // namespace armature
