// SPDX-License-Identifier: BSD-3-Clause
// Numbers that look random but are functions of a place: the same on every platform and thread.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

namespace armature {

// An integer well mixed (finalizer of MurmurHash3).
inline std::uint32_t Mixed(std::uint32_t x) {
  x = (x ^ (x >> 16)) * 0x85ebca6bu;
  x = (x ^ (x >> 13)) * 0xc2b2ae35u;
  return x ^ (x >> 16);
}

inline std::uint32_t Hash(int x, int y, int z, std::uint32_t seed) {
  return Mixed(static_cast<std::uint32_t>(x) * 0x9e3779b1u ^ static_cast<std::uint32_t>(y) * 0x85ebca77u ^
               static_cast<std::uint32_t>(z) * 0xc2b2ae3du ^ seed * 0x27d4eb2fu);
}

// Uniform in [0, 1).
inline float Unit(std::uint32_t hash) { return static_cast<float>(hash >> 8) * 0x1.0p-24f; }

// For cells of a pattern.
inline float CellNoise(int x, int y, std::uint32_t seed) { return Unit(Hash(x, y, 0, seed)); }

inline int Floor(float x) {
  const int i = static_cast<int>(x);
  return i - (x < static_cast<float>(i) ? 1 : 0);
}

inline float Smooth(float t) { return t * t * (3 - 2 * t); }

// Random values at whole coordinates, smoothly interpolated: in [-1, 1], mean 0, features of about size 1.
inline float SmoothNoise(const Eigen::Vector3f& p, std::uint32_t seed) {
  const int x = Floor(p.x()), y = Floor(p.y()), z = Floor(p.z());
  const float tx = Smooth(p.x() - static_cast<float>(x)), ty = Smooth(p.y() - static_cast<float>(y)),
              tz = Smooth(p.z() - static_cast<float>(z));
  std::array<float, 2> layers{};
  for (int k = 0; k < 2; ++k) {
    const float a = Unit(Hash(x, y, z + k, seed)), b = Unit(Hash(x + 1, y, z + k, seed));
    const float c = Unit(Hash(x, y + 1, z + k, seed)), d = Unit(Hash(x + 1, y + 1, z + k, seed));
    const float low = a + (b - a) * tx, high = c + (d - c) * tx;
    layers[static_cast<size_t>(k)] = low + (high - low) * ty;
  }
  return 2 * (layers[0] + (layers[1] - layers[0]) * tz) - 1;
}

}  // namespace armature
