// SPDX-License-Identifier: BSD-3-Clause
#include "bench/guard/calibration.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <memory>

namespace armature {
namespace {

constexpr int kProblems = 1000;
constexpr size_t kFloats = size_t{1} << 20;    // 4 MB
constexpr size_t kStride = size_t{16} * 4099;  // a prime number of cache lines: each is met once

// Every solution is bounded and starts the next problem, so nothing can be left out or run in parallel.
double Arithmetic() {
  using Matrix = Eigen::Matrix<double, 6, 6>;
  using Vector = Eigen::Matrix<double, 6, 1>;
  Vector x = Vector::LinSpaced(0.1, 0.6);
  double sum = 0;
  for (int i = 0; i < kProblems; ++i) {
    const Vector wave = x.unaryExpr([](double v) { return std::sin(v) + 0.5 * std::exp(-v * v); });
    const Matrix normal = wave * wave.transpose() + x * x.transpose() + Matrix::Identity();
    x = normal.ldlt().solve(Vector(wave + Vector::Constant(std::cos(0.001 * i))));
    sum += x.norm();
  }
  return sum;
}

double MemoryTraffic(std::vector<float>& memory) {
  for (size_t i = 0; i < memory.size(); ++i) memory[i] = static_cast<float>(i % 1024);
  for (size_t i = 1; i < memory.size(); ++i) memory[i - 1] = 0.5F * (memory[i - 1] + memory[i]);
  double sum = 0;
  for (size_t i = 0, at = 0; i < memory.size(); i += 16, at = (at + kStride) % memory.size())
    sum += static_cast<double>(memory[at]);
  return sum / static_cast<double>(memory.size());
}

}  // namespace

CalibrationLoop::CalibrationLoop() : memory_(kFloats) {}

double CalibrationLoop::Pass() { return Arithmetic() + MemoryTraffic(memory_); }

Contender CalibrationContender() {
  // The sum is kept, or the compiler could leave the work out.
  const auto loop = std::make_shared<CalibrationLoop>();
  const auto sum = std::make_shared<double>(0);
  return {.name = kCalibrationName,
          .every = 1,
          .start = {},
          .run =
              [loop, sum](size_t) {
                *sum += loop->Pass();
                return FrameOutcome{};
              },
          .calls = 1,
          // Brings the caches into the same state, whoever has been before.
          .before = [loop, sum] { *sum += loop->Pass(); }};
}

}  // namespace armature
