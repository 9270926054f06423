// SPDX-License-Identifier: BSD-3-Clause
#include "io/library_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <span>
#include <string_view>

#include "base/checksum.h"
#include "base/errors.h"
#include "base/text.h"
#include "category/category_lookup.h"
#include "io/atomic_write.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kMagic = "armature library of instances\n";
constexpr std::uint32_t kLibraryVersion = 1;
constexpr const char* kBuildAgain = "build it again with 'armature retrieve --build'";

[[noreturn]] void RefuseLibrary(const fs::path& file, const std::string& why) {
  throw InputError(fmt::format("{}: {}; {}", file.string(), why, kBuildAgain));
}

void CheckModel(const fs::path& file, const CategoryInstances& instances, const CategoryModel& model) {
  const bool fits = instances.model_checksum == ModelChecksum(model);
  if (fits && (instances.coefficients.rows() != model.modes() || instances.edges.rows() != model.mean.size()))
    RefuseLibrary(file, fmt::format("is damaged: its instances of {} have other shapes than their model",
                                    Quoted(instances.category)));
  if (fits) return;
  throw InputError(
      fmt::format("{}: its instances of {} are of another category model; name that with --categories, or {}",
                  file.string(), Quoted(instances.category), kBuildAgain));
}

// Numbers and texts one after the other; a text is its length and its bytes.
class Bytes {
 public:
  template <typename Number>
  void Add(Number number) {
    AddRaw(&number, sizeof(number));
  }
  void Add(const std::string& text) {
    Add(static_cast<std::uint64_t>(text.size()));
    AddRaw(text.data(), text.size());
  }
  void Add(const std::vector<std::string>& texts) {
    for (const std::string& text : texts) Add(text);
  }
  template <typename Derived>
  void AddFloats(const Eigen::PlainObjectBase<Derived>& matrix) {
    AddRaw(matrix.data(), sizeof(float) * static_cast<size_t>(matrix.size()));
  }
  std::string& all() { return all_; }

 private:
  void AddRaw(const void* data, size_t size) { all_.append(static_cast<const char*>(data), size); }
  std::string all_;
};

// Takes them back. A right checksum does not say that sizes are: none is believed before the bytes are there.
class Reader {
 public:
  Reader(const fs::path& file, std::string_view rest) : file_(file), rest_(rest) {}

  template <typename Number>
  Number Take() {
    Number number;
    std::memcpy(&number, TakeRaw(sizeof(number)), sizeof(number));
    return number;
  }
  std::string TakeText() {
    const auto size = Take<std::uint64_t>();
    return {TakeRaw(size), static_cast<size_t>(size)};
  }
  std::vector<std::string> TakeTexts(Eigen::Index count) {
    CheckLeft(static_cast<std::uint64_t>(count), sizeof(std::uint64_t));
    std::vector<std::string> texts(static_cast<size_t>(count));
    for (std::string& text : texts) text = TakeText();
    return texts;
  }
  template <typename Matrix>
  void TakeFloats(Eigen::Index rows, Eigen::Index columns, Matrix& matrix) {
    CheckLeft(static_cast<std::uint64_t>(rows), sizeof(float));
    const size_t of_column = sizeof(float) * static_cast<size_t>(rows);
    if (of_column > 0) CheckLeft(static_cast<std::uint64_t>(columns), of_column);
    const size_t size = of_column * static_cast<size_t>(columns);
    const char* data = TakeRaw(size);
    matrix.resize(rows, columns);
    if (size > 0) std::memcpy(matrix.data(), data, size);
    if (!matrix.allFinite()) RefuseLibrary(file_, "is damaged: a number is not finite");
  }
  // A number of things. Throws where there are not as many bytes.
  Eigen::Index TakeCount() {
    const auto count = Take<std::uint64_t>();
    CheckLeft(count, 1);
    return static_cast<Eigen::Index>(count);
  }
  bool AtEnd() const { return rest_.empty(); }
  [[noreturn]] void Refuse(const std::string& why) const { RefuseLibrary(file_, why); }

 private:
  void CheckLeft(std::uint64_t count, size_t bytes) const {
    if (count > rest_.size() / bytes) RefuseLibrary(file_, "is damaged: it says more than it holds");
  }
  const char* TakeRaw(std::uint64_t size) {
    CheckLeft(size, 1);
    const char* data = rest_.data();
    rest_.remove_prefix(size);
    return data;
  }
  const fs::path& file_;
  std::string_view rest_;
};

void AddCategory(const CategoryInstances& instances, Bytes& bytes) {
  bytes.Add(instances.category);
  bytes.Add(instances.model_checksum);
  bytes.Add(static_cast<std::int64_t>(instances.coefficients.rows()));
  bytes.Add(static_cast<std::int64_t>(instances.edges.rows()));
  bytes.Add(static_cast<std::int64_t>(instances.size()));
  bytes.AddFloats(instances.coefficients);
  bytes.AddFloats(instances.sizes);
  bytes.AddFloats(instances.edges);
  bytes.AddFloats(instances.size_sigmas);
  bytes.AddFloats(instances.T_object_geometry);
  bytes.Add(instances.ids);
  bytes.Add(instances.geometries);
}

CategoryInstances TakeCategory(Reader& reader) {
  CategoryInstances instances{.category = reader.TakeText()};
  instances.model_checksum = reader.Take<std::uint64_t>();
  const Eigen::Index modes = reader.TakeCount(), rows = reader.TakeCount(), count = reader.TakeCount();
  reader.TakeFloats(modes, count, instances.coefficients);
  reader.TakeFloats(3, count, instances.sizes);
  reader.TakeFloats(rows, count, instances.edges);
  reader.TakeFloats(count, 1, instances.size_sigmas);
  reader.TakeFloats(12, count, instances.T_object_geometry);
  instances.ids = reader.TakeTexts(count);
  instances.geometries = reader.TakeTexts(count);
  const bool is_real = (instances.sizes.array() >= 0).all() && (instances.size_sigmas.array() >= 0).all();
  if (!is_real) reader.Refuse("is damaged: a size is below zero");
  return instances;
}

std::uint64_t SumStages(std::string_view bytes) { return Checksum(std::as_bytes(std::span(bytes))); }

// What is between magic, version and checksum, once these are right.
std::string_view Checked(const fs::path& file, std::string_view bytes) {
  if (!bytes.starts_with(kMagic)) RefuseLibrary(file, "is not a library of instances");
  const size_t start = kMagic.size() + sizeof(kLibraryVersion);
  if (bytes.size() < start + sizeof(std::uint64_t)) RefuseLibrary(file, "is cut short");
  Reader reader(file, bytes.substr(kMagic.size()));
  if (const auto version = reader.Take<std::uint32_t>(); version != kLibraryVersion)
    RefuseLibrary(file, fmt::format("is of version {}, not {}", version, kLibraryVersion));
  const size_t end = bytes.size() - sizeof(std::uint64_t);
  Reader sum(file, bytes.substr(end));
  if (sum.Take<std::uint64_t>() != SumStages(bytes.substr(0, end)))
    RefuseLibrary(file, "is damaged or cut short");
  return bytes.substr(start, end - start);
}

fs::path RelativeTo(const fs::path& folder, const fs::path& root) {
  const fs::path relative =
      fs::absolute(root).lexically_normal().lexically_relative(fs::absolute(folder).lexically_normal());
  return relative.empty() ? fs::absolute(root) : relative;
}

}  // namespace

void WriteLibrary(const InstanceLibrary& library, const fs::path& file) {
  Bytes bytes;
  bytes.all() = kMagic;
  bytes.Add(kLibraryVersion);
  bytes.Add(RelativeTo(fs::absolute(file).parent_path(), library.root).string());
  bytes.Add(static_cast<std::uint64_t>(library.categories.size()));
  for (const CategoryInstances& instances : library.categories) AddCategory(instances, bytes);
  bytes.Add(SumStages(bytes.all()));
  AtomicWrite(file, bytes.all());
}

InstanceLibrary ReadLibrary(const fs::path& file, const std::vector<CategoryModel>& models) {
  const std::string content = ReadTextFile(file);
  Reader reader(file, Checked(file, content));
  InstanceLibrary library;
  library.root = (fs::absolute(file).parent_path() / reader.TakeText()).lexically_normal();
  const Eigen::Index categories = reader.TakeCount();
  for (Eigen::Index i = 0; i < categories; ++i) {
    CategoryInstances instances = TakeCategory(reader);
    const CategoryModel* model = FindModel(models, instances.category);
    if (model == nullptr) continue;
    CheckModel(file, instances, *model);
    if (library.Of(instances.category) != nullptr)
      RefuseLibrary(file, fmt::format("is damaged: it has {} twice", Quoted(instances.category)));
    library.categories.push_back(std::move(instances));
  }
  if (!reader.AtEnd()) RefuseLibrary(file, "is damaged: it holds more than it says");
  return library;
}

}  // namespace armature
