// SPDX-License-Identifier: BSD-3-Clause
// The fuzzer of all readers, one program: `fuzz_readers READER [libFuzzer's options] [CORPUS...]`;
// `fuzz_readers list` names them. An input is put into a copy of tests/fuzz/sample, in memory, in place of
// the file that the reader reads; an InputError is what a reader is to answer with.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <fstream>

#include "base/console.h"
#include "base/errors.h"
#include "fuzz/reader_targets.h"

namespace armature::fuzzing {
namespace {

constexpr const char* kVariable = "ARMATURE_FUZZ_READER";  // for the processes that libFuzzer starts

const ReaderTarget* target = nullptr;
fs::path scratch;
std::string first_inputs;  // outlives libFuzzer's use of it

const ReaderTarget* FindTarget(const std::string& name) {
  const auto& targets = ReaderTargets();
  const auto found =
      std::find_if(targets.begin(), targets.end(), [&](const ReaderTarget& t) { return t.name == name; });
  return found == targets.end() ? nullptr : &*found;
}

[[noreturn]] void List() {
  for (const ReaderTarget& t : ReaderTargets()) fmt::print("{}\n", t.name);
  std::fflush(stdout);
  _exit(0);
}

void MakeFolder() {
  const fs::path memory = fs::exists("/dev/shm") ? "/dev/shm" : fs::temp_directory_path();
  scratch = memory / fmt::format("armature_fuzz_{}", getpid());
  fs::copy(fs::path(ARMATURE_SOURCE_DIR) / "tests/fuzz/sample", scratch, fs::copy_options::recursive);
  std::atexit([] {
    std::error_code ignored;
    fs::remove_all(scratch, ignored);
  });
}

// libFuzzer's option of what it starts from: the sample, and what is kept of the reader.
std::string FirstInputs() {
  const fs::path fuzz = fs::path(ARMATURE_SOURCE_DIR) / "tests/fuzz";
  std::vector<std::string> files{(fuzz / "sample" / target->file).string()};
  std::error_code none;
  for (const auto& kept : fs::directory_iterator(fuzz / "corpus" / target->name, none)) {
    files.push_back(kept.path().string());
  }
  std::sort(files.begin(), files.end());
  return fmt::format("-seed_inputs={}", fmt::join(files, ","));
}

// The reader's name is taken from the arguments, its first inputs are added to them.
void TakeReader(int& count, char**& arguments) {
  const std::string named = count > 1 ? arguments[1] : "";
  if (named == "list") List();
  target = FindTarget(named);
  if (target != nullptr) {
    setenv(kVariable, named.c_str(), 1);
    first_inputs = FirstInputs();
    arguments[1] = first_inputs.data();
    return;
  }
  if (const char* inherited = std::getenv(kVariable)) target = FindTarget(inherited);
  if (target != nullptr) return;
  fmt::print(stderr, "fuzz_readers: name a reader first; `fuzz_readers list` lists them\n");
  std::exit(2);
}

}  // namespace
}  // namespace armature::fuzzing

extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments) {
  using namespace armature::fuzzing;
  armature::SetVerbosity(armature::Verbosity::kQuiet);
  TakeReader(*count, *arguments);
  MakeFolder();
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, size_t size) {
  using namespace armature::fuzzing;
  const fs::path file = scratch / target->file;
  std::string bytes(reinterpret_cast<const char*>(data), size);
  if (target->seal != nullptr) bytes = target->seal(std::move(bytes));
  std::ofstream(file, std::ios::binary) << bytes;
  try {
    target->read(file);
  } catch (const armature::InputError&) {
  }
  return 0;
}
