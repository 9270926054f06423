// SPDX-License-Identifier: BSD-3-Clause
// The plots of a report, drawn by gnuplot as those of `armature bench`.
#pragma once

#include <string>
#include <vector>

#include "eval/report/ablation_bars.h"
#include "eval/report/report_data.h"
#include "eval/report/reported_bench.h"
#include "io/evaluation_records.h"

namespace armature {

// Each a picture of every item that has something to show. Where gnuplot is missing or fails there are none,
// and a remark says why.

// `objects`: in each frame.
std::vector<ReportPlot> DrawStageBars(const std::vector<StageBars>& all, size_t objects,
                                      std::vector<std::string>& remarks);
std::vector<ReportPlot> DrawTimeCurves(const std::vector<TimeCurves>& all, std::vector<std::string>& remarks);
// A strip a run's name, of the errors of its objects over all rooms.
std::vector<ReportPlot> DrawRoomErrors(const std::vector<RoomErrorsRecord>& records,
                                       std::vector<std::string>& remarks);
std::vector<ReportPlot> DrawAblationBars(const std::vector<AblationBars>& all,
                                         std::vector<std::string>& remarks);

}  // namespace armature
