// SPDX-License-Identifier: BSD-3-Clause
#include "cli/help.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <sstream>

#include "cli/wrapped_text.h"

namespace armature {
namespace {

constexpr size_t kNameColumn = 2, kMeaningColumn = 28, kColumns = 100;

const std::vector<HelpEntry> kExitStatus = {
    {"0", "done"},
    {"1", "began and failed"},
    {"2", "bad usage or bad input: one line says where, what and the remedy"},
    {"130, 143, 129",
     "interrupted by Ctrl-C, SIGTERM or a hang-up; what was written is whole, the line says what"}};

std::string EntryText(const HelpEntry& entry) {
  return TwoColumns(entry.name, entry.meaning, {kNameColumn, kMeaningColumn, kColumns});
}

std::string Section(const std::string& heading, const std::vector<HelpEntry>& entries) {
  if (entries.empty()) return "";
  std::string text = "\n" + heading + ":\n";
  for (const HelpEntry& entry : entries) text += EntryText(entry);
  return text;
}

std::string FormatName(const CLI::Option& option) {
  std::string name = option.get_positional() ? option.get_name(true) : option.get_name(false, true);
  for (size_t comma = 0; (comma = name.find(',', comma)) != std::string::npos; ++comma)
    name.replace(comma, 1, ", ");
  if (!FormatType(option).empty() && !option.get_positional()) name += " " + FormatType(option);
  return option.get_items_expected_max() > 1 && option.get_expected_max() > 1 ? name + " ..." : name;
}

std::string FormatMeaning(const CLI::Option& option) {
  std::string meaning = option.get_description();
  if (option.get_required() && !option.get_positional()) meaning += " (required)";
  std::string initial = option.get_default_str();
  if (initial.starts_with("[")) initial = initial.substr(1, initial.size() - 2);  // a list's own brackets
  if (!initial.empty()) meaning += fmt::format(" [{}]", initial);
  return meaning;
}

HelpEntry MakeEntry(const CLI::Option& option) { return {FormatName(option), FormatMeaning(option)}; }

// The headed options of a command, without --help.
std::string OptionSections(const CLI::App& command) {
  std::string text;
  for (const std::string& heading : command.get_groups()) {
    std::vector<HelpEntry> entries;
    for (const CLI::Option* option : command.get_options()) {
      if (option->get_group() == heading && option != command.get_help_ptr())
        entries.push_back(MakeEntry(*option));
    }
    text += Section(heading, entries);
  }
  return text;
}

std::string GlobalOptions(const CLI::App& program) {
  std::vector<HelpEntry> entries;
  for (const CLI::Option* option : program.get_options()) entries.push_back(MakeEntry(*option));
  return Section("Global options", entries);
}

std::string UsageLine(const CLI::App& command) {
  std::string usage = "armature " + command.get_name() + " [OPTIONS]";
  for (const bool positional : {false, true}) {
    for (const CLI::Option* option : command.get_options()) {
      if (option->get_positional() != positional || (!positional && !option->get_required())) continue;
      usage += option->get_required() ? " " + FormatName(*option) : " [" + FormatName(*option) + "]";
    }
  }
  return "Usage: " + usage + "\n";
}

std::string Examples(const std::vector<HelpExample>& examples) {
  std::string text = "\nExamples:\n";
  for (const auto& [purpose, line] : examples) {
    text += fmt::format("  # {}\n  ", purpose);
    std::istringstream parts(Wrapped(line, kColumns - 6));  // with indent and " \\"
    std::string part;
    for (bool is_first = true; std::getline(parts, part); is_first = false)
      text += (is_first ? "" : " \\\n    ") + part;
    text += '\n';
  }
  return text;
}

std::string CommandText(const CLI::App& command, const CommandHelp& help) {
  std::vector<HelpEntry> status = kExitStatus;
  for (const HelpEntry& own : help.exit_status) {
    for (HelpEntry& common : status) {
      if (common.name == own.name) common.meaning += "; " + own.meaning;
    }
  }
  std::string text = fmt::format("armature {}: {}\n\n", command.get_name(), command.get_description());
  text += UsageLine(command) + "\n" + Wrapped(help.description, kColumns) + OptionSections(command) +
          GlobalOptions(*command.get_parent()) + Section("Files written", help.files) +
          Section("Exit status", status) + Examples(help.examples);
  const std::string footer = command.get_footer();
  return footer.empty() ? text : text + "\n" + footer;
}

std::string ProgramText(const CLI::App& program) {
  std::vector<HelpEntry> commands;
  for (const CLI::App* command : program.get_subcommands({}))
    commands.push_back({command->get_name(), command->get_description()});
  return program.get_description() + "\n\nUsage: armature COMMAND [OPTIONS]\n" +
         Section("Commands", commands) + GlobalOptions(program) + Section("Exit status", kExitStatus) +
         "\n'armature COMMAND --help' describes a command, with examples.\n";
}

}  // namespace

void Describe(CLI::App& command, CommandHelp help) {
  const auto shown = std::make_shared<const CommandHelp>(std::move(help));
  command.formatter_fn([shown](const CLI::App* app, const std::string&, CLI::AppFormatMode) {
    return CommandText(*app, *shown);
  });
}

void DescribeProgram(CLI::App& program) {
  program.formatter_fn(
      [](const CLI::App* app, const std::string&, CLI::AppFormatMode) { return ProgramText(*app); });
}

void BeginSection(CLI::App& command, const std::string& heading) {
  command.option_defaults()->group(heading);
}

// CLI11 appends what validators say of themselves to the type name, the one place that belongs to an option.
CLI::Option& OfferValues(CLI::Option& option, const std::vector<std::string>& values) {
  option.check(CLI::Validator([](std::string&) { return std::string(); },
                              fmt::format("{{{}}}", fmt::join(values, "|"))));
  return option;
}

std::vector<std::string> OfferedValues(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const size_t start = type.find(":{");
  if (start == std::string::npos) return {};
  std::istringstream joined(type.substr(start + 2, type.find('}', start) - start - 2));
  std::vector<std::string> values;
  for (std::string value; std::getline(joined, value, '|');) values.push_back(value);
  return values;
}

CLI::Option& KnownValues(CLI::Option& option, const std::vector<std::string>& values) {
  option.description(fmt::format("{}: {}", option.get_description(), fmt::join(values, ", ")));
  return OfferValues(option, values);
}

std::string FormatType(const CLI::Option& option) {
  if (option.get_items_expected_max() == 0) return "";
  const std::string type = option.get_type_name();
  const std::string name = type.substr(0, type.find(':'));
  return name == "INT" || name == "UINT" || name == "FLOAT" ? "N" : name;
}

}  // namespace armature
