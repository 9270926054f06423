// SPDX-License-Identifier: BSD-3-Clause
// Rows that say by a stamp which image they are of.
#pragma once

#include <fmt/format.h>

#include <vector>

#include "base/errors.h"
#include "io/csv.h"
#include "io/sequence.h"

namespace armature {

class ImageStamps {
 public:
  // `images` by growing stamps.
  explicit ImageStamps(const std::vector<ImageEntry>& images) {
    stamps_.reserve(images.size());
    for (const ImageEntry& image : images) stamps_.push_back({.timestamp = image.timestamp});
  }

  // By the row's `timestamp`, within 1 ms. Throws InputError where there is no such image.
  size_t FindImage(const CsvRow& row) const {
    const double timestamp = row.Number("timestamp");
    if (const std::optional<size_t> index = FindStamp(stamps_, timestamp)) return *index;
    throw InputError(row.At(fmt::format(
        "rgb.txt lists no image within 1 ms of stamp {:.6f}; use the stamps of rgb.txt", timestamp)));
  }

 private:
  std::vector<TimedPose> stamps_;
};

}  // namespace armature
