// SPDX-License-Identifier: BSD-3-Clause
#include "eval/rooms/room_statistics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "eval/rooms/room_numbers.h"
#include "eval/statistics/room_difference.h"

namespace armature {
namespace {

constexpr double kShown = 0.1;  // of a's mean: the difference for which rooms are counted

std::optional<double> Summarise(const ValuesInRooms& values, RoomSummary summary, const RoomCounts& counts) {
  switch (summary) {
    case RoomSummary::kMean:
      return values.Mean(counts);
    case RoomSummary::kMedian:
      return values.Quantile(counts, 0.5);
    case RoomSummary::kP90:
      return values.Quantile(counts, 0.9);
    case RoomSummary::kWorst:
      return values.Quantile(counts, 1);
  }
  return std::nullopt;
}

ValuesInRooms CollectValues(const RoomVariant& variant, RoomQuantity quantity) {
  std::vector<std::pair<double, size_t>> values;
  for (size_t i = 0; i < variant.rooms.size(); ++i) {
    for (const double value : ValuesOf(variant.rooms[i], quantity)) values.emplace_back(value, i);
  }
  return ValuesInRooms(std::move(values));
}

RoomStatisticRecord ComputeStatistic(const RoomVariant& variant, const RoomStatistic& statistic,
                                     const RoomBootstrap& bootstrap) {
  const ValuesInRooms values = CollectValues(variant, statistic.quantity);
  RoomStatisticRecord record{
      .run = variant.name, .statistic = statistic.key, .rooms = static_cast<long>(variant.rooms.size())};
  record.value = Summarise(values, statistic.summary, bootstrap.Once());
  const auto interval =
      bootstrap.Of([&](const RoomCounts& counts) { return Summarise(values, statistic.summary, counts); });
  if (interval) {
    record.low = interval->low;
    record.high = interval->high;
  }
  return record;
}

Cell IntervalCell(const RoomStatisticRecord& record, const RoomStatistic& statistic) {
  if (!record.value) return NoCell();
  const auto text = [&](double value) {
    return fmt::format("{:.{}f}", statistic.unit * value, statistic.digits);
  };
  if (!record.low) return TextCell(text(*record.value));
  return TextCell(fmt::format("{} [{}, {}]", text(*record.value), text(*record.low), text(*record.high)));
}

// What a room has of a variant, to be paired.
struct PairedNumber {
  const char* key;
  std::function<std::optional<std::pair<double, double>>(const EvaluatedRoom&, const EvaluatedRoom&)> pair;
};

// The objects that both have found.
std::optional<std::pair<double, double>> CommonErrors(const EvaluatedRoom& a, const EvaluatedRoom& b) {
  double sum_a = 0, sum_b = 0;
  int n = 0;
  for (const RoomObject& of_a : a.objects) {
    const auto of_b = std::find_if(b.objects.begin(), b.objects.end(),
                                   [&](const RoomObject& o) { return o.of.true_id == of_a.of.true_id; });
    if (!of_a.of.error || of_b == b.objects.end() || !of_b->of.error) continue;
    sum_a += of_a.of.error->centre_m;
    sum_b += of_b->of.error->centre_m;
    ++n;
  }
  if (n == 0) return std::nullopt;
  return std::pair{sum_a / n, sum_b / n};
}

std::vector<PairedNumber> PairedNumbers() {
  std::vector<PairedNumber> numbers;
  for (const RoomStatistic& statistic : RoomStatistics()) {
    numbers.push_back({statistic.key, [&](const EvaluatedRoom& a, const EvaluatedRoom& b) {
                         const auto of_a = NumberOf(a, statistic), of_b = NumberOf(b, statistic);
                         return of_a && of_b ? std::optional(std::pair{*of_a, *of_b}) : std::nullopt;
                       }});
  }
  numbers.push_back({"object_error_mean_found_by_both_m", CommonErrors});
  numbers.push_back(
      {"object_error_mean_ln_m", [](const EvaluatedRoom& a, const EvaluatedRoom& b) {
         const auto of_a = a.mean_error_m(), of_b = b.mean_error_m();
         const bool known = of_a && of_b && *of_a > 0 && *of_b > 0;
         return known ? std::optional(std::pair{std::log(*of_a), std::log(*of_b)}) : std::nullopt;
       }});
  return numbers;
}

// A tenth more is ln 1.1 more of a logarithm.
double SizeToShow(const std::string& key, double mean_a) {
  return key == "object_error_mean_ln_m" ? std::log(1 + kShown) : kShown * std::abs(mean_a);
}

}  // namespace

std::vector<RoomStatisticRecord> ComputeRoomStatistics(const std::vector<RoomVariant>& variants) {
  std::vector<RoomStatisticRecord> records;
  for (const RoomVariant& variant : variants) {
    const RoomBootstrap bootstrap(variant.rooms.size());
    for (const RoomStatistic& statistic : RoomStatistics())
      records.push_back(ComputeStatistic(variant, statistic, bootstrap));
  }
  return records;
}

Table RoomTable(const std::vector<RoomVariant>& variants, const std::vector<RoomStatisticRecord>& records) {
  Table table{.title = "Variants over rooms, with 95 % intervals",
              .columns = {"variant", "rooms"},
              .rows = {},
              .notes = {},
              .name = "rooms"};
  for (const RoomStatistic& statistic : RoomStatistics()) table.columns.emplace_back(statistic.title);
  size_t next = 0;
  for (const RoomVariant& variant : variants) {
    auto& row = table.rows.emplace_back();
    row = {TextCell(variant.name), CountCell(static_cast<long>(variant.rooms.size()))};
    for (const RoomStatistic& statistic : RoomStatistics())
      row.push_back(IntervalCell(records[next++], statistic));
  }
  table.notes = {
      "found: of the objects that some detection was of; centre, azimuth, size: of all found objects of all "
      "rooms; "
      "scale off: absolute logarithm of estimated over true length of the cameras' path (sim3), of rooms "
      "where the camera "
      "moves; "
      "cameras: rmse of their positions; spurious, scale, cameras: means over rooms.",
      fmt::format(
          "[from, to]: 2.5th to 97.5th percentile over {} draws of rooms with replacement, each with all its "
          "objects (percentile bootstrap, seeded); too narrow for few rooms, and that of the worst cannot "
          "reach beyond it.",
          RoomBootstrap::kRepeats)};
  return table;
}

std::vector<RoomDifferenceRecord> CompareVariants(const RoomVariant& a, const RoomVariant& b) {
  std::vector<RoomDifferenceRecord> records;
  for (const PairedNumber& number : PairedNumbers()) {
    std::vector<std::pair<double, double>> pairs;
    for (const EvaluatedRoom& of_a : a.rooms) {
      const EvaluatedRoom* of_b = FindRoom(b, of_a.room);
      const auto pair = of_b ? number.pair(of_a, *of_b) : std::nullopt;
      if (pair) pairs.push_back(*pair);
    }
    const auto difference = CompareRooms(pairs);
    if (!difference) continue;
    records.push_back(
        {.statistic = number.key,
         .run_a = a.name,
         .run_b = b.name,
         .rooms = static_cast<long>(pairs.size()),
         .mean_a = difference->mean_a,
         .mean_b = difference->mean_b,
         .difference = difference->mean,
         .low = difference->interval.low,
         .high = difference->interval.high,
         .mark = MarkName(difference->mark),
         .rooms_to_show_a_tenth = RoomsToShow(*difference, SizeToShow(number.key, difference->mean_a))});
  }
  return records;
}

Table RoomDifferenceTable(const std::vector<RoomDifferenceRecord>& records) {
  Table table{.title = "Differences over rooms",
              .columns = {"number of a room", "A", "B", "mean A", "mean B", "B - A", "from", "to", "B is",
                          "rooms", "rooms for 10 %"},
              .rows = {},
              .notes = {},
              .name = "room_differences"};
  for (const RoomDifferenceRecord& record : records) {
    auto& row = table.rows.emplace_back();
    row = {TextCell(record.statistic), TextCell(record.run_a), TextCell(record.run_b)};
    for (const double value : {record.mean_a, record.mean_b, record.difference, record.low, record.high})
      row.push_back(NumberCell(value, 4));
    row.push_back(TextCell(record.mark));
    row.push_back(CountCell(record.rooms));
    row.push_back(record.rooms_to_show_a_tenth ? CountCell(*record.rooms_to_show_a_tenth) : NoCell());
  }
  table.notes = {
      "B - A: mean over the rooms that both have of the difference of that room's number; from, to: its 95 % "
      "interval "
      "(bootstrap over rooms). B is: lower or higher where 0 is outside of it; too few: fewer than six "
      "rooms. Of "
      "twenty rows, one is marked by chance.",
      "found_by_both: of the objects of the room that both found; ln: logarithm of the room's mean error, so "
      "that "
      "B - A is the logarithm of a ratio.",
      "rooms for 10 %: so many would show a difference of a tenth of A's mean, ((1.96 + 0.84) s / d)^2 with "
      "the "
      "standard deviation s of the rooms' differences (5 % two-sided, 80 % power)."};
  return table;
}

std::vector<RoomErrorsRecord> CollectRoomErrors(const std::vector<RoomVariant>& variants) {
  std::vector<RoomErrorsRecord> records;
  for (const RoomVariant& variant : variants) {
    RoomErrorsRecord& record = records.emplace_back(RoomErrorsRecord{.run = variant.name});
    for (const EvaluatedRoom& room : variant.rooms) {
      for (const double error : ValuesOf(room, RoomQuantity::kCentre))
        record.object_errors_m.push_back(error);
      record.missed += room.observed() - room.found();
    }
  }
  return records;
}

}  // namespace armature
