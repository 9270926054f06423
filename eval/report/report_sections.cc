// SPDX-License-Identifier: BSD-3-Clause
#include "eval/report/report_sections.h"

#include <fmt/format.h>

#include "eval/report/html_pictures.h"
#include "eval/report/html_table.h"
#include "eval/report/html_text.h"

namespace armature {
namespace {

constexpr size_t kTablesWithoutContents = 3;

std::string RemarksHtml(const std::vector<std::string>& remarks) {
  if (remarks.empty()) return "";
  std::string html = "<ul class=\"remarks\">\n";
  for (const std::string& remark : remarks) html += fmt::format("<li>{}</li>\n", EscapedHtml(remark));
  return html + "</ul>\n";
}

std::string FigureHtml(const HeadlineFigure& figure) {
  return fmt::format(
      "<div class=\"card\"><h3>{}</h3><p class=\"ours\">{}</p><p class=\"paper\">the paper: <b>{}</b></p>"
      "<p class=\"remark\">{}</p></div>\n",
      EscapedHtml(figure.label), figure.ours.empty() ? "–" : EscapedHtml(figure.ours),
      figure.paper.empty() ? "–" : EscapedHtml(figure.paper), EscapedHtml(figure.remark));
}

std::string HeadlineHtml(const std::vector<HeadlineFigure>& headline) {
  if (headline.empty()) return "";
  std::string html = "<div class=\"headline\">\n";
  for (const HeadlineFigure& figure : headline) html += FigureHtml(figure);
  return html + "</div>\n";
}

// The tables of a section, with links to them when they are many.
std::string TablesHtml(const ReportData& data, ReportSection section) {
  std::string html, contents;
  size_t count = 0;
  for (size_t i = 0; i < data.tables.size(); ++i) {
    if (data.tables[i].section != section) continue;
    const std::string id = fmt::format("table-{}", i);
    html += TableHtml(data.tables[i].table, id);
    contents += fmt::format("<li><a href=\"#{}\">{}</a></li>", id, EscapedHtml(data.tables[i].table.title));
    ++count;
  }
  if (count <= kTablesWithoutContents) return html;
  return fmt::format("<ul class=\"contents\">{}</ul>\n{}", contents, html);
}

// A figure for a script to fill.
std::string ScriptedHtml(const std::string& kind, size_t index, const std::string& title,
                         const std::string& caption) {
  return fmt::format(
      "<figure class=\"plot\" data-plot=\"{}\" data-index=\"{}\">\n<figcaption><b>{}</b> {}</figcaption>\n"
      "<noscript><p>This figure is drawn by a script, and scripts are switched "
      "off.</p></noscript></figure>\n",
      kind, index, EscapedHtml(title), EscapedHtml(caption));
}

std::string MapsHtml(const ReportData& data) {
  std::string html;
  for (size_t i = 0; i < data.maps.size(); ++i) {
    html += ScriptedHtml("maps", i, data.maps[i].sequence, data.maps[i].note);
  }
  return html;
}

std::string ScenesHtml(const ReportData& data) {
  if (data.scenes.empty()) return "";
  return ScriptedHtml("scenes", 0, "",
                      "Drag to turn, wheel to come nearer, right button to move; a square is 1 m.");
}

std::string TimingHtml(const ReportData& data) {
  return PlotsHtml(data.stages) + PlotsHtml(data.curves) + TablesHtml(data, ReportSection::kTiming);
}

std::string AblationHtml(const ReportData& data) {
  return PlotsHtml(data.ablations) + TablesHtml(data, ReportSection::kAblation);
}

std::string RetrievalHtml(const ReportData& data) {
  return (data.strips.empty() ? "" : StripsHtml(data.strips)) + TablesHtml(data, ReportSection::kRetrieval);
}

std::string EnvironmentHtml(const ReportData& data) {
  if (data.environment.empty()) return "";
  std::string html = "<dl>\n";
  for (const auto& [name, value] : data.environment) {
    html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", EscapedHtml(name), EscapedHtml(value));
  }
  return html + "</dl>\n";
}

}  // namespace

std::vector<PageSection> ReportSections(const ReportData& data) {
  const std::string overview =
      RemarksHtml(data.remarks) + HeadlineHtml(data.headline) + TablesHtml(data, ReportSection::kOverview);
  std::vector<PageSection> sections = {
      {"summary", "Summary", overview},
      {"maps", "Maps from above", MapsHtml(data)},
      {"scenes", "The map in 3D", ScenesHtml(data)},
      {"overlays", "Associated edges", data.overlays.empty() ? "" : OverlaysHtml(data.overlays)},
      {"accuracy", "Accuracy", TablesHtml(data, ReportSection::kAccuracy)},
      {"timing", "Timing", TimingHtml(data)},
      {"retrieval", "Retrieved CAD models", RetrievalHtml(data)},
      {"ablation", "Normal term", AblationHtml(data)},
      {"other", "Further tables", TablesHtml(data, ReportSection::kFurther)},
      {"environment", "Environment", EnvironmentHtml(data)}};
  std::erase_if(sections, [](const PageSection& section) { return section.html.empty(); });
  return sections;
}

}  // namespace armature
