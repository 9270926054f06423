// SPDX-License-Identifier: BSD-3-Clause
#include "eval/report/report_plots.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/errors.h"
#include "drawing/plots/strips.h"

namespace armature {
namespace {

// For those who do not see it: what it shows, and of what.
template <typename Drawn>
ReportPicture DrawPicture(const Drawn& drawn, const std::string& shows, const std::vector<std::string>& of) {
  return {"image/svg+xml", DrawSvg(drawn), fmt::format("{}: {}", shows, fmt::join(of, ", "))};
}

// What the function draws of each item.
template <typename Item, typename Function>
std::vector<ReportPlot> DrawAll(const std::vector<Item>& items, std::vector<std::string>& remarks,
                                Function draw) {
  std::vector<ReportPlot> plots;
  try {
    for (const Item& item : items) plots.push_back(draw(item));
    return plots;
  } catch (const InputError& error) {
    remarks.push_back(fmt::format("The plots are left out: {}", error.what()));
    return {};
  }
}

std::vector<std::string> ListNames(const StackedBars& bars) {
  std::vector<std::string> names;
  for (const StackedBars::Bar& bar : bars.bars) names.push_back(bar.name);
  return names;
}

bool HasLength(const StackedBars& bars) {
  for (const StackedBars::Bar& bar : bars.bars) {
    for (const double part : bar.parts) {
      if (part > 0) return true;
    }
  }
  return false;
}

StackedBars MakeBars(const AblationBars& ablation) {
  StackedBars bars{.title = "", .unit = ablation.unit, .digits = 2, .stages = {""}, .bars = {}};
  for (const AblationBars::Bar& bar : ablation.bars) bars.bars.push_back({bar.run, {bar.value}});
  return bars;
}

bool HasPoints(const Plot& plot) {
  return std::any_of(plot.series.begin(), plot.series.end(), [](const auto& s) { return !s.y.empty(); });
}

Strips MakeErrorStrips(const std::vector<RoomErrorsRecord>& records) {
  Strips strips{.title = "", .label = "distance of the centre, metres", .strips = {}};
  for (const RoomErrorsRecord& record : records) {
    const std::string name =
        fmt::format("{}: {} found, {} missed", record.run, record.object_errors_m.size(), record.missed);
    strips.strips.push_back({name, record.object_errors_m});
  }
  return strips;
}

bool HasValues(const Strips& strips) {
  return std::any_of(strips.strips.begin(), strips.strips.end(), [](const Strips::Strip& strip) {
    return std::any_of(strip.values.begin(), strip.values.end(), [](double value) { return value > 0; });
  });
}

std::vector<std::string> ListNames(const Strips& strips) {
  std::vector<std::string> names;
  for (const Strips::Strip& strip : strips.strips) names.push_back(strip.name);
  return names;
}

}  // namespace

std::vector<ReportPlot> DrawStageBars(const std::vector<StageBars>& all, size_t objects,
                                      std::vector<std::string>& remarks) {
  std::vector<StageBars> shown = all;
  std::erase_if(shown, [](const StageBars& stages) { return !HasLength(stages.bars); });
  return DrawAll(shown, remarks, [&](const StageBars& stages) {
    const std::string caption =
        fmt::format("Median time of each stage, frames of {} with {} objects", stages.sequence, objects);
    return ReportPlot{stages.sequence, caption, DrawPicture(stages.bars, caption, ListNames(stages.bars))};
  });
}

std::vector<ReportPlot> DrawTimeCurves(const std::vector<TimeCurves>& all,
                                       std::vector<std::string>& remarks) {
  std::vector<TimeCurves> shown = all;
  std::erase_if(shown, [](const TimeCurves& curves) { return !HasPoints(curves.plot); });
  return DrawAll(shown, remarks, [](const TimeCurves& curves) {
    const std::string axes = fmt::format("{} against {}", curves.plot.y_label, curves.plot.x_label);
    std::vector<std::string> names;
    for (const PlotSeries& series : curves.plot.series) names.push_back(series.name);
    return ReportPlot{curves.sequence, axes + ": medians, from the 10th to the 90th percentile",
                      DrawPicture(curves.plot, axes, names)};
  });
}

std::vector<ReportPlot> DrawRoomErrors(const std::vector<RoomErrorsRecord>& records,
                                       std::vector<std::string>& remarks) {
  std::vector<Strips> shown{MakeErrorStrips(records)};
  std::erase_if(shown, [](const Strips& strips) { return !HasValues(strips); });
  return DrawAll(shown, remarks, [](const Strips& strips) {
    const std::string caption = "Errors of the found objects of all rooms; boxes: quartiles, lines: medians";
    return ReportPlot{"", caption, DrawPicture(strips, caption, ListNames(strips))};
  });
}

std::vector<ReportPlot> DrawAblationBars(const std::vector<AblationBars>& all,
                                         std::vector<std::string>& remarks) {
  std::vector<AblationBars> shown = all;
  std::erase_if(shown, [](const AblationBars& ablation) { return !HasLength(MakeBars(ablation)); });
  return DrawAll(shown, remarks, [](const AblationBars& ablation) {
    const StackedBars bars = MakeBars(ablation);
    return ReportPlot{ablation.sequence, ablation.caption,
                      DrawPicture(bars, ablation.caption, ListNames(bars))};
  });
}

}  // namespace armature
