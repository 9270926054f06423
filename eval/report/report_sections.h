// SPDX-License-Identifier: BSD-3-Clause
// The sections of a report's page as HTML.
#pragma once

#include <string>
#include <vector>

#include "eval/report/report_data.h"

namespace armature {

struct PageSection {
  std::string id, title;
  std::string html;  // what stands under the title
};

// In the order of the page, without those that have nothing to show. What scripts draw stands in a figure
// with the attributes data-plot (the kind, as in ReportJson) and data-index (which of that kind).
std::vector<PageSection> ReportSections(const ReportData& data);

}  // namespace armature
