// SPDX-License-Identifier: BSD-3-Clause
// shape_evidence.csv of a run folder: what the images say of each object's shape, as its map holds it:
// `id,model,information,vector`; the checksum of the category model that the coefficients are of
// (hexadecimal), of the symmetric information the lower triangle row by row, `;` between numbers.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "mapping/solve_map.h"

namespace armature {

struct StoredEvidence {
  ShapeEvidence evidence;
  std::uint64_t model_checksum = 0;  // ModelChecksum of the object's model
};

std::string ShapeEvidenceText(const std::vector<MapObject>& objects);

// By the objects' ids. Throws InputError: missing or malformed file, an id twice, numbers that are no
// triangle or do not fit together.
std::map<std::string, StoredEvidence> ReadShapeEvidence(const std::filesystem::path& file);

}  // namespace armature
