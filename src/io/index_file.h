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
#include <string>

namespace armature {

// Written aside and renamed. Throws InputError when it cannot be written.
void WriteIndexFile(const std::filesystem::path& file, const std::string& method,
                    const Eigen::MatrixXf& features, const std::string& payload);

// The bytes, when the lines say what is expected. Throws InputError as InstanceIndex::Load.
std::string ReadIndexFile(const std::filesystem::path& file, const std::string& method,
                          const Eigen::MatrixXf& features);

}  // namespace armature
