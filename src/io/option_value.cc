// SPDX-License-Identifier: BSD-3-Clause
#include "io/option_value.h"

#include <fmt/format.h>

#include <cmath>

#include "base/errors.h"
#include "base/nearest_name.h"
#include "base/text.h"

namespace armature {
namespace {

// Throws with both values: "association.max_angle_deg 95 > 90".
void CheckRange(const OptionEntry& entry, double value, const std::string& where) {
  const bool low = value < entry.min;
  if (!low && value <= entry.max) return;
  throw InputError(fmt::format("{}: {} {} {} {}; choose a value in {}", where, entry.key, value,
                               low ? '<' : '>', low ? entry.min : entry.max, OptionDomain(entry)));
}

bool ParseBoolean(const std::string& text, const std::string& where) {
  if (text == "true") return true;
  if (text == "false") return false;
  throw InputError(fmt::format("{}: {} is neither true nor false; write one of them", where, Quoted(text)));
}

struct SetFromText {
  const OptionEntry& entry;
  const std::string& text;
  const std::string where;  // with the key, for messages about the type
  const std::string& place;

  void operator()(double* field) const {
    const double value = ParseNumber(text, where);
    CheckRange(entry, value, place);
    *field = value;
  }
  void operator()(int* field) const {
    const int value = ParseInteger(text, where);
    CheckRange(entry, value, place);
    *field = value;
  }
  void operator()(bool* field) const { *field = ParseBoolean(text, where); }
  void operator()(const EnumField& field) const {
    if (field.set(field.field, text)) return;
    throw InputError(
        fmt::format("{}: {}", place, UnknownNameMessage("value of " + entry.key, text, field.names())));
  }
};

struct CheckValue {
  const OptionEntry& entry;
  const std::string& where;

  void operator()(const double* field) const {
    if (!std::isfinite(*field)) throw InputError(fmt::format("{}: {} is not finite", where, entry.key));
    CheckRange(entry, *field, where);
  }
  void operator()(const int* field) const { CheckRange(entry, *field, where); }
  void operator()(const bool*) const {}
  void operator()(const EnumField&) const {}
};

struct ValueText {
  std::string operator()(const double* field) const { return fmt::format("{}", *field); }  // shortest exact
  std::string operator()(const int* field) const { return fmt::format("{}", *field); }
  std::string operator()(const bool* field) const { return *field ? "true" : "false"; }
  std::string operator()(const EnumField& field) const { return field.name(field.field); }
};

}  // namespace

void SetOption(const OptionEntry& entry, const std::string& text, const std::string& where) {
  std::visit(SetFromText{entry, text, fmt::format("{}: {}", where, entry.key), where}, entry.field);
}

void CheckOption(const OptionEntry& entry, const std::string& where) {
  std::visit(CheckValue{entry, where}, entry.field);
}

std::string OptionText(const OptionEntry& entry) { return std::visit(ValueText{}, entry.field); }

std::string OptionDomain(const OptionEntry& entry) {
  if (std::holds_alternative<bool*>(entry.field)) return "true|false";
  if (const auto* choice = std::get_if<EnumField>(&entry.field))
    return fmt::format("{}", fmt::join(choice->names(), "|"));
  const bool has_min = std::isfinite(entry.min);
  const bool has_max = std::isfinite(entry.max);
  if (has_min && has_max) return fmt::format("{}..{}", entry.min, entry.max);
  if (has_min) return fmt::format(">= {}", entry.min);
  if (has_max) return fmt::format("<= {}", entry.max);
  return std::holds_alternative<int*>(entry.field) ? "integer" : "number";
}

}  // namespace armature
