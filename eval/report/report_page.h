// SPDX-License-Identifier: BSD-3-Clause
// The report as one HTML file that needs nothing else: no network, no other file.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "eval/report/report_data.h"

namespace armature {

// The data as the page's script reads it; all texts as they are, not escaped.
nlohmann::ordered_json ReportJson(const ReportData& data);

// A whole page: text, tables and headline as HTML, so that they are there without scripts, too; plots, maps
// and 3D views drawn by the inlined scripts from the inlined ReportJson. Every text is escaped.
std::string ReportPage(const ReportData& data);

}  // namespace armature
