// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <vector>

#include "io/sequence.h"

namespace armature {

// The pictures of a generated sequence, or drawings of its lines where it has none.
class SequencePictures {
 public:
  // Throws InputError as ReadImageList and ReadSegments.
  explicit SequencePictures(const std::filesystem::path& sequence);

  size_t size() const { return images_.size(); }

  // 8-bit BGR. Throws InputError: it cannot be read.
  cv::Mat Read(size_t index) const;

 private:
  std::vector<ImageEntry> images_;
  Camera camera_;
  std::vector<std::vector<Segment>> segments_;  // empty: there are pictures
};

}  // namespace armature
