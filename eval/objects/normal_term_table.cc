// SPDX-License-Identifier: BSD-3-Clause
#include "eval/objects/normal_term_table.h"

#include <cmath>
#include <numeric>
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
    if (map.by_odometry) continue;
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

void PushMeanAndMedian(const std::vector<double>& values, std::vector<Cell>& row) {
  if (values.empty()) {
    row.insert(row.end(), 2, NoCell());
    return;
  }
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  row.push_back(NumberCell(sum / static_cast<double>(values.size()), 2));
  row.push_back(NumberCell(Median(values), 2));
}

void PushTilts(const Tilts& tilts, std::vector<Cell>& row) {
  row.push_back(CountCell(static_cast<long>(tilts.pitch.size())));
  PushMeanAndMedian(tilts.pitch, row);
  PushMeanAndMedian(tilts.roll, row);
}

}  // namespace

Table NormalTermTable(const SequenceObjects& sequence, const std::vector<NamedEvaluation>& evaluations) {
  if (sequence.runs.size() != evaluations.size())
    throw std::invalid_argument("objects and observations are of different runs");
  Table table;
  table.title = sequence.sequence + ": pitch and roll, and the normal term [deg]";
  table.name = "normal";
  table.sequence = sequence.sequence;
  table.columns = {"run", "normal term"};
  for (const std::string of : {"objects", "observations"}) {
    for (const char* column : {"", ": pitch mean", ": pitch median", ": roll mean", ": roll median"})
      table.columns.push_back(of + column);
  }
  for (size_t i = 0; i < evaluations.size(); ++i) {
    const auto& term = sequence.runs[i].objects.configuration.normal_term;
    std::vector<Cell> row{TextCell(evaluations[i].run), term ? TextCell(*term) : NoCell()};
    PushTilts(OfMap(sequence.runs[i].objects), row);
    PushTilts(OfObservations(evaluations[i].evaluation), row);
    table.rows.push_back(row);
  }
  table.notes = {
      "normal term: resection.normal_term of the run's config.yaml.",
      "objects: those of the map that were found. observations: single views with status ok, of a true "
      "object.",
      "pitch, roll: absolute, of the object's y axis against the true one, about its own x and z axis."};
  for (std::string& note : ObjectNotes(sequence)) table.notes.push_back(std::move(note));
  return table;
}

}  // namespace armature
