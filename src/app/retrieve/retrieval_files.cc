// SPDX-License-Identifier: BSD-3-Clause
#include "app/retrieve/retrieval_files.h"

#include <fmt/format.h>

#include <map>

#include "base/csv_fields.h"
#include "base/number_format.h"
#include "base/text.h"
#include "io/atomic_write.h"
#include "io/csv.h"

namespace armature {
namespace {

// tx,ty,tz,qx,qy,qz,qw,scale; nothing where the instance was not fitted.
std::string FitFields(const std::optional<InstanceFit>& fit) {
  if (!fit) return ",,,,,,,,";
  const Eigen::Vector3d t = fit->T_world_object.translation();
  const Eigen::Quaterniond q = CanonicalQuaternion(fit->T_world_object.linear());
  return fmt::format("{},{},{},{},{},{},{},{},{}", Fixed(fit->cost, 6), Fixed(t.x(), 6), Fixed(t.y(), 6),
                     Fixed(t.z(), 6), Fixed(q.x(), 9), Fixed(q.y(), 9), Fixed(q.z(), 9), Fixed(q.w(), 9),
                     Fixed(fit->scale, 6));
}

std::string RetrievalText(const RunRetrieval& retrieval) {
  std::string text = "object,rank,instance,distance,cost,tx,ty,tz,qx,qy,qz,qw,scale\n";
  for (const ObjectInstances& found : retrieval.objects) {
    for (size_t i = 0; i < found.instances.size(); ++i) {
      const RetrievedInstance& instance = found.instances[i];
      text += fmt::format("{},{},{},{},{}\n", CsvField(retrieval.map.objects[found.object].id), i + 1,
                          CsvField(found.library->ids[static_cast<size_t>(instance.instance)]),
                          Fixed(instance.distance, 6), FitFields(instance.fit));
    }
  }
  return text;
}

// The table with the column `instance` anew; everything else stays as it is.
std::string WithInstances(const std::filesystem::path& file,
                          const std::map<std::string, std::string>& of_object) {
  const CsvTable table(file, {"id", "instance"});
  const size_t column = table.ColumnIndex("instance"), id = table.ColumnIndex("id");
  std::string text;
  bool is_header = true;
  for (const TextLine& line : ReadTextLines(file)) {
    std::vector<std::string> fields = SplitCsvFields(line.text);
    if (!is_header) {
      const auto found = of_object.find(fields[id]);
      fields[column] = found == of_object.end() ? "" : found->second;
    }
    is_header = false;
    for (std::string& field : fields) field = CsvField(field);
    text += fmt::format("{}\n", fmt::join(fields, ","));
  }
  return text;
}

}  // namespace

void WriteRetrieval(const RunRetrieval& retrieval, const std::filesystem::path& folder) {
  std::map<std::string, std::string> of_object;
  for (const ObjectInstances& found : retrieval.objects) {
    if (found.instances.empty()) continue;
    of_object[retrieval.map.objects[found.object].id] =
        found.library->ids[static_cast<size_t>(found.instances.front().instance)];
  }
  const std::string objects = WithInstances(retrieval.run / "objects.csv", of_object);
  AtomicWrite(folder / "retrieval.csv", RetrievalText(retrieval));
  AtomicWrite(folder / "objects.csv", objects);
}

}  // namespace armature
