// SPDX-License-Identifier: BSD-3-Clause
// The tables of objects that `armature eval` prints.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "eval/objects/run_objects.h"
#include "io/evaluation_records.h"
#include "io/text_table.h"

namespace armature {

struct NamedObjects {
  std::string run;  // as shown
  RunObjects objects;
};

// The runs on one sequence, and what all their maps were compared with.
struct SequenceObjects {
  std::string sequence;
  std::string truth_source;  // what objects_gt.csv says about itself; empty: nothing
  ObjectEvaluationOptions options;
  std::vector<NamedObjects> runs;
};

// Of one category; of all where there is none.
ObjectRecord MakeObjectRecord(const SequenceObjects& sequence, const NamedObjects& run,
                              const EvaluatedMap& map, MatchedBy matched_by,
                              const std::optional<std::string>& category);

// A record a run, approach, way of matching and category, and one of all categories.
std::vector<ObjectRecord> MakeObjectRecords(const SequenceObjects& sequence);

// A row a run, approach and category, and one of all categories; matched by distance.
Table ObjectSummaryTable(const SequenceObjects& sequence);

// A row a run, approach and object: the true ones, then the spurious ones.
Table EachObjectTable(const SequenceObjects& sequence);

// Lines under every table of objects: how the maps were aligned and with which scale, which runs have no map,
// and where the truth is from.
std::vector<std::string> ObjectNotes(const SequenceObjects& sequence);

// A row a run, approach, matching and object, from all of which the tables can be computed; CSV. Empty
// fields: not known.
std::string RawObjectsCsv(const std::vector<SequenceObjects>& sequences);

}  // namespace armature
