// SPDX-License-Identifier: BSD-3-Clause
// The tag by which cameras say how they were held.
#pragma once

#include <string_view>

namespace armature {

// 1 to 8 of the EXIF tag 0x0112 in the bytes of a JPEG, PNG or TIFF file: 1: upright, or there is no such
// tag; 5 and more: a viewer swaps width and height.
int FindExifOrientation(std::string_view bytes);

}  // namespace armature
