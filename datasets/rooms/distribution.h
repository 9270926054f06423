// SPDX-License-Identifier: BSD-3-Clause
// What a recipe leaves to chance: numbers and words with their distributions (datasets/README.md).
//
//   0.45                                        always the same
//   [0.2, 0.4]  {uniform: [0.2, 0.4]}           evenly between the two; of whole numbers both ends count
//   {normal: [0.45, 0.03], within: [0.4, 0.5]}  mean and standard deviation; drawn again while outside
//   {choice: [boards, tiles], weights: [2, 1]}  one of them; weights: all the same unless given
//   {mixture: [{normal: ...}, ...], weights: [9, 1]}  drawn from one of these
#pragma once

#include <string>
#include <vector>

#include "geometry/random.h"
#include "io/yaml_support.h"

namespace armature {

struct Distribution {
  enum class Kind { kUniform, kNormal, kChoice, kMixture };

  Kind kind = Kind::kUniform;
  double low = 0, high = 0;         // of kUniform, and where kNormal is cut
  double mean = 0, deviation = 0;   // of kNormal
  std::vector<std::string> values;  // of kChoice
  std::vector<Distribution> parts;  // of kMixture
  std::vector<double> weights;      // of values or parts; add up to more than 0
};

Distribution Constant(double value);
Distribution Uniform(double low, double high);
Distribution Normal(double mean, double deviation, double low, double high);
Distribution Choice(std::vector<std::string> values, std::vector<double> weights = {});
Distribution Mixture(std::vector<Distribution> parts, std::vector<double> weights);

// Of a key that has to be there. Throw InputError naming file, line and remedy: another form, weights of
// another number, and values that are no numbers in [min, max] or none of the words.
Distribution ReadNumbers(const YamlMap& map, const std::string& key, double min, double max);
Distribution ReadWords(const YamlMap& map, const std::string& key, const std::vector<std::string>& words);
Distribution ReadAny(const YamlMap& map, const std::string& key);

// Numbers are rounded to a ten-thousandth, so that what is written down is what was drawn.
double DrawNumber(const Distribution& distribution, Random& random);
int DrawInteger(const Distribution& distribution, Random& random);
std::string DrawWord(const Distribution& distribution, Random& random);
// A number as text, or a word.
std::string DrawText(const Distribution& distribution, Random& random);

double RoundDrawn(double value);

// Whether the map says how a value is distributed, and is no section of keys.
bool IsDistribution(const YamlMap& map);

}  // namespace armature
