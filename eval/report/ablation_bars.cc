// SPDX-License-Identifier: BSD-3-Clause
#include "eval/report/ablation_bars.h"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <set>
#include <string>

namespace armature {
namespace {

struct Angle {
  const char* caption;
  std::optional<double> UprightnessRecord::*mean_deg;
};

constexpr std::array kAngles{
    Angle{"Mean absolute pitch of observations", &UprightnessRecord::view_pitch_mean_deg},
    Angle{"Mean absolute roll of observations", &UprightnessRecord::view_roll_mean_deg},
    Angle{"Mean absolute pitch of objects", &UprightnessRecord::object_pitch_mean_deg},
    Angle{"Mean absolute roll of objects", &UprightnessRecord::object_roll_mean_deg}};

using Uprightness = std::vector<const UprightnessRecord*>;

// The first record with each normal term.
Uprightness PickFirstOfEachTerm(const std::vector<UprightnessRecord>& records, const std::string& sequence) {
  Uprightness picked;
  std::set<std::string> terms;
  for (const UprightnessRecord& record : records) {
    if (record.sequence == sequence && record.normal_term && terms.insert(*record.normal_term).second)
      picked.push_back(&record);
  }
  return picked;
}

AblationBars MakeAngleBars(const std::string& sequence, const Uprightness& records, const Angle& angle) {
  AblationBars bars{sequence, angle.caption, "deg", {}};
  for (const UprightnessRecord* record : records) {
    if (const std::optional<double>& mean_deg = record->*angle.mean_deg)
      bars.bars.push_back({fmt::format("{}: {}", *record->normal_term, record->run), *mean_deg});
  }
  return bars;
}

}  // namespace

std::vector<AblationBars> NormalTermBars(const std::vector<UprightnessRecord>& records) {
  std::vector<AblationBars> all;
  std::set<std::string> sequences;
  for (const UprightnessRecord& record : records) {
    if (!sequences.insert(record.sequence).second) continue;
    const Uprightness picked = PickFirstOfEachTerm(records, record.sequence);
    for (const Angle& angle : kAngles) {
      AblationBars bars = MakeAngleBars(record.sequence, picked, angle);
      if (bars.bars.size() > 1) all.push_back(std::move(bars));
    }
  }
  return all;
}

}  // namespace armature
