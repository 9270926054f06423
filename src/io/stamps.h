// SPDX-License-Identifier: BSD-3-Clause
// Whether stamps can be seconds, as all of ours are.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace armature {

// "milliseconds", "microseconds" or "nanoseconds": what the number is since 1970 where it is too large for
// seconds; none where it is not.
std::optional<std::string> GuessStampUnit(double stamp);

// "1305031110.04 to 1305031113.2 s"; "1.3e+18 to 1.4e+18 (nanoseconds?)" of what is too large for seconds.
std::string DescribeStampRange(double first, double last);

// "41 years", "3 days", "2.5 hours", "12 s".
std::string DescribeDuration(double seconds);

}  // namespace armature
