// SPDX-License-Identifier: BSD-3-Clause
// The file of a search structure: four lines of text that say what it is and of what, then its bytes.
//
//   armature-index 1, FLANN 1.9.2
//   method kdtree trees=4 seed=1
//   features 7 x 1000, checksum 0123456789abcdef
//   payload 4711 bytes, checksum 0123456789abcdef
#pragma once

#include <Eigen/Core>
#include <filesystem>

#include "retrieval/instance_index.h"

namespace armature {

// Written aside and renamed. Throws InputError when it cannot be written.
void WriteIndex(const InstanceIndex& index, const std::filesystem::path& file);

// Throws InputError naming the file and the remedy: missing, cut short, corrupt, of another version, of
// another method or other parameters than `method`, of other features (D x N, see InstanceIndex).
InstanceIndex ReadIndex(const std::filesystem::path& file, Eigen::MatrixXf features,
                        const IndexMethod& method);

}  // namespace armature
