// SPDX-License-Identifier: BSD-3-Clause
// Pictures of a report as HTML.
#pragma once

#include <string>
#include <vector>

#include "eval/report/report_data.h"

namespace armature {

// Side by side where there is room; nothing of none.
std::string PlotsHtml(const std::vector<ReportPlot>& plots);

// Frames side by side, as many as fit.
std::string OverlaysHtml(const std::vector<OverlayFrame>& frames);

// A row an object: as it was seen, then its models, the true one marked. The rows of a run, which stand
// together, can be folded; those of the first are not.
std::string StripsHtml(const std::vector<RetrievalStrip>& strips);

}  // namespace armature
