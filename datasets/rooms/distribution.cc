// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/rooms/distribution.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/errors.h"
#include "base/nearest_name.h"
#include "base/text.h"

namespace armature {
namespace {

constexpr const char* kForms =
    "write a number, [low, high], {normal: [mean, deviation], within: [low, high]}, {choice: [...], weights: "
    "[...]} or {mixture: [{...}, ...], weights: [...]}";
constexpr int kNormalTries = 1000;
constexpr double kReach = 4;  // deviations from the mean within which a cut normal has to leave something

std::vector<double> ReadTwo(const YamlMap& map, const std::string& key, const char* form) {
  std::vector<double> values = map.Numbers(key);
  if (values.size() == 2) return values;
  throw InputError(map.At(key, fmt::format("has {} values; write the two of {}", values.size(), form)));
}

Distribution ReadUniform(const YamlMap& map, const std::string& key) {
  const std::vector<double> ends = ReadTwo(map, key, "[low, high]");
  if (ends[0] <= ends[1]) return Uniform(ends[0], ends[1]);
  throw InputError(
      map.At(key, fmt::format("goes from {} down to {}; write the lesser first", ends[0], ends[1])));
}

Distribution ReadNormal(const YamlMap& map) {
  map.CheckKeys({"normal", "within"});
  const std::vector<double> values = ReadTwo(map, "normal", "[mean, deviation]");
  if (values[1] < 0)
    throw InputError(map.At("normal", fmt::format("has the deviation {}; write 0 or more", values[1])));
  const double reach = kReach * values[1];
  Distribution normal = Normal(values[0], values[1], values[0] - reach, values[0] + reach);
  if (!map.Has("within")) return normal;
  const Distribution within = ReadUniform(map, "within");
  if (within.low > normal.high || within.high < normal.low) {
    throw InputError(
        map.At("within", fmt::format("[{}, {}] is more than {} deviations from the mean {}; move "
                                     "it there",
                                     within.low, within.high, kReach, values[0])));
  }
  normal.low = within.low;
  normal.high = within.high;
  return normal;
}

void ReadWeights(const YamlMap& map, size_t count, Distribution* distribution) {
  if (count == 0) throw InputError(map.At(map.Keys().front(), "is empty; name one value or more"));
  if (!map.Has("weights")) {
    distribution->weights.assign(count, 1);
    return;
  }
  distribution->weights = map.Numbers("weights");
  const std::vector<double>& weights = distribution->weights;
  if (weights.size() != count)
    throw InputError(map.At(
        "weights", fmt::format("has {} numbers for {} values; write one a value", weights.size(), count)));
  if (*std::min_element(weights.begin(), weights.end()) < 0 ||
      std::accumulate(weights.begin(), weights.end(), 0.0) <= 0)
    throw InputError(map.At("weights", "has to be of numbers of 0 or more, one of them greater"));
}

Distribution ReadMap(const YamlMap& map) {
  if (map.Has("uniform")) {
    map.CheckKeys({"uniform"});
    return ReadUniform(map, "uniform");
  }
  if (map.Has("normal")) return ReadNormal(map);
  Distribution distribution;
  if (map.Has("choice")) {
    map.CheckKeys({"choice", "weights"});
    distribution.kind = Distribution::Kind::kChoice;
    distribution.values = map.Texts("choice");
    ReadWeights(map, distribution.values.size(), &distribution);
    return distribution;
  }
  map.CheckKeys({"mixture", "weights", "uniform", "normal", "choice"});
  distribution.kind = Distribution::Kind::kMixture;
  for (const YamlMap& part : map.Maps("mixture")) distribution.parts.push_back(ReadMap(part));
  ReadWeights(map, distribution.parts.size(), &distribution);
  return distribution;
}

// What is wrong with the values as numbers in [min, max], if anything.
std::string NumberFault(const Distribution& d, double min, double max) {
  if (d.kind == Distribution::Kind::kMixture) {
    for (const Distribution& part : d.parts) {
      if (std::string fault = NumberFault(part, min, max); !fault.empty()) return fault;
    }
    return "";
  }
  if (d.kind != Distribution::Kind::kChoice) {
    if (d.low >= min && d.high <= max) return "";
    return fmt::format("reaches from {} to {}; stay within [{}, {}]", d.low, d.high, min, max);
  }
  for (const std::string& value : d.values) {
    double number = 0;
    try {
      number = ParseNumber(value, "");
    } catch (const InputError&) {
      return fmt::format("has the value {}; write numbers", Quoted(value));
    }
    if (number < min || number > max)
      return fmt::format("has the value {}; stay within [{}, {}]", value, min, max);
  }
  return "";
}

size_t PickWeighted(const std::vector<double>& weights, Random& random) {
  double rest = random.Uniform(0, std::accumulate(weights.begin(), weights.end(), 0.0));
  for (size_t i = 0; i < weights.size(); ++i) {
    if (rest < weights[i]) return i;
    rest -= weights[i];
  }
  return weights.size() - 1;
}

double DrawNormal(const Distribution& d, Random& random) {
  for (int i = 0; i < kNormalTries; ++i) {
    const double value = random.Normal(d.mean, d.deviation);
    if (value >= d.low && value <= d.high) return value;
  }
  return std::clamp(d.mean, d.low, d.high);
}

}  // namespace

Distribution Constant(double value) { return Uniform(value, value); }

Distribution Uniform(double low, double high) {
  Distribution distribution;
  distribution.low = low;
  distribution.high = high;
  return distribution;
}

Distribution Normal(double mean, double deviation, double low, double high) {
  Distribution distribution = Uniform(low, high);
  distribution.kind = Distribution::Kind::kNormal;
  distribution.mean = mean;
  distribution.deviation = deviation;
  return distribution;
}

Distribution Choice(std::vector<std::string> values, std::vector<double> weights) {
  Distribution distribution;
  distribution.kind = Distribution::Kind::kChoice;
  distribution.weights = weights.empty() ? std::vector<double>(values.size(), 1) : std::move(weights);
  distribution.values = std::move(values);
  return distribution;
}

Distribution Mixture(std::vector<Distribution> parts, std::vector<double> weights) {
  Distribution distribution;
  distribution.kind = Distribution::Kind::kMixture;
  distribution.parts = std::move(parts);
  distribution.weights = std::move(weights);
  return distribution;
}

bool IsDistribution(const YamlMap& map) {
  const std::vector<std::string> keys = map.Keys();
  return keys.empty() || std::any_of(keys.begin(), keys.end(), [](const std::string& key) {
           return key == "uniform" || key == "normal" || key == "choice" || key == "mixture";
         });
}

Distribution ReadAny(const YamlMap& map, const std::string& key) {
  if (map.IsMap(key)) {
    const YamlMap form = map.Map(key);
    if (form.Keys().empty()) throw InputError(map.At(key, fmt::format("is empty; {}", kForms)));
    return ReadMap(form);
  }
  if (map.IsList(key)) return ReadUniform(map, key);
  return Choice({map.Text(key)});
}

Distribution ReadNumbers(const YamlMap& map, const std::string& key, double min, double max) {
  Distribution distribution = ReadAny(map, key);
  const std::string fault = NumberFault(distribution, min, max);
  if (fault.empty()) return distribution;
  throw InputError(map.At(key, fault));
}

Distribution ReadWords(const YamlMap& map, const std::string& key, const std::vector<std::string>& words) {
  Distribution distribution = ReadAny(map, key);
  if (distribution.kind != Distribution::Kind::kChoice)
    throw InputError(map.At(key, "is about words; write one, or {choice: [...], weights: [...]}"));
  for (const std::string& value : distribution.values) {
    if (std::find(words.begin(), words.end(), value) == words.end())
      throw InputError(
          fmt::format("{}: {}", map.Where(key), UnknownNameMessage("value of " + key, value, words)));
  }
  return distribution;
}

double RoundDrawn(double value) { return std::round(value * 1e4) / 1e4; }

double DrawNumber(const Distribution& d, Random& random) {
  switch (d.kind) {
    case Distribution::Kind::kUniform:
      return RoundDrawn(random.Uniform(d.low, d.high));
    case Distribution::Kind::kNormal:
      return RoundDrawn(DrawNormal(d, random));
    case Distribution::Kind::kChoice:
      return ParseNumber(d.values[PickWeighted(d.weights, random)], "");
    case Distribution::Kind::kMixture:
      return DrawNumber(d.parts[PickWeighted(d.weights, random)], random);
  }
  std::abort();
}

int DrawInteger(const Distribution& d, Random& random) {
  if (d.kind == Distribution::Kind::kUniform) {
    const int low = static_cast<int>(std::ceil(d.low)), high = static_cast<int>(std::floor(d.high));
    return std::min(high, static_cast<int>(std::floor(random.Uniform(low, high + 1.0))));
  }
  if (d.kind == Distribution::Kind::kMixture)
    return DrawInteger(d.parts[PickWeighted(d.weights, random)], random);
  return static_cast<int>(std::lround(DrawNumber(d, random)));
}

std::string DrawWord(const Distribution& d, Random& random) {
  return d.values[PickWeighted(d.weights, random)];
}

std::string DrawText(const Distribution& d, Random& random) {
  if (d.kind == Distribution::Kind::kChoice) return DrawWord(d, random);
  if (d.kind == Distribution::Kind::kMixture)
    return DrawText(d.parts[PickWeighted(d.weights, random)], random);
  return fmt::format("{}", DrawNumber(d, random));
}

}  // namespace armature
