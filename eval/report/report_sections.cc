// SPDX-License-Identifier: BSD-3-Clause
#include "eval/report/report_sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "eval/report/html_table.h"
#include "eval/report/html_text.h"
#include "eval/report/report_data.h"

namespace armature {
namespace {

std::string ImageHtml(const ReportPicture& picture) {
  return fmt::format("<img src=\"{}\" alt=\"{}\">", EscapedHtml(DataUrl(picture.mime, picture.bytes)),
                     EscapedHtml(picture.alt));
}

// The parts that are not empty, with a dot between them.
std::string Joined(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) {
    if (!part.empty()) text += (text.empty() ? "" : " · ") + part;
  }
  return EscapedHtml(text);
}

std::string FrameHtml(const OverlayFrame& frame) {
  return fmt::format("<figure>{}<figcaption><b>{}</b> {}</figcaption></figure>\n", ImageHtml(frame.picture),
                     Joined({frame.sequence, frame.run, fmt::format("{:.2f} s", frame.timestamp)}),
                     EscapedHtml(frame.caption));
}

std::string ModelHtml(const RetrievalStrip::Model& model, size_t rank) {
  const std::string picture =
      model.picture ? ImageHtml(*model.picture) : "<div class=\"missing\">no surface to show</div>";
  return fmt::format("<figure class=\"model{}\">{}<figcaption><b>{}. {}</b>{}<br>{}</figcaption></figure>\n",
                     model.is_true ? " true" : "", picture, rank, EscapedHtml(model.name),
                     model.is_true ? " <span class=\"badge\">✓ true model</span>" : "",
                     EscapedHtml(model.detail));
}

std::string StripHtml(const RetrievalStrip& strip) {
  std::string html = fmt::format(
      "<div class=\"strip\">\n<figure "
      "class=\"query\">{}<figcaption><b>{}</b><br>{}{}</figcaption></figure>\n",
      ImageHtml(strip.query), EscapedHtml(strip.object), Joined({strip.sequence, strip.run}),
      strip.true_model.empty() ? "" : "<br>true model: " + EscapedHtml(strip.true_model));
  for (size_t i = 0; i < strip.models.size(); ++i) html += ModelHtml(strip.models[i], i + 1);
  return html + "</div>\n";
}

// Those of one run.
std::string FoldedStripsHtml(std::span<const RetrievalStrip> strips, bool open) {
  std::string html = fmt::format("<details{}><summary><b>{}</b>: {} objects</summary>\n", open ? " open" : "",
                                 Joined({strips[0].sequence, strips[0].run}), strips.size());
  for (const RetrievalStrip& strip : strips) html += StripHtml(strip);
  return html + "</details>\n";
}

// Side by side where there is room; nothing of none.
std::string PlotsHtml(const std::vector<ReportPlot>& plots) {
  if (plots.empty()) return "";
  std::string html = "<div class=\"plots\">\n";
  for (const ReportPlot& plot : plots) {
    html += fmt::format("<figure>\n<figcaption><b>{}</b> {}</figcaption>\n{}</figure>\n",
                        EscapedHtml(plot.sequence), EscapedHtml(plot.caption), ImageHtml(plot.picture));
  }
  return html + "</div>\n";
}

// Frames side by side, as many as fit.
std::string OverlaysHtml(const std::vector<OverlayFrame>& frames) {
  std::string html = "<div class=\"gallery\">\n";
  for (const OverlayFrame& frame : frames) html += FrameHtml(frame);
  return html + "</div>\n";
}

// A row an object: as it was seen, then its models, the true one marked. The rows of a run, which stand
// together, can be folded; those of the first are not.
std::string StripsHtml(const std::vector<RetrievalStrip>& strips) {
  std::string html = "<div class=\"strips\">\n";
  for (auto first = strips.begin(); first != strips.end();) {
    const auto last = std::find_if_not(first, strips.end(), [first](const RetrievalStrip& strip) {
      return strip.sequence == first->sequence && strip.run == first->run;
    });
    html += FoldedStripsHtml({first, last}, first == strips.begin());
    first = last;
  }
  return html + "</div>\n";
}

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

std::string AccuracyHtml(const ReportData& data) { return TablesHtml(data, ReportSection::kAccuracy); }

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
  const std::string overview = RemarksHtml(data.remarks) + HeadlineHtml(data.headline) +
                               PlotsHtml(data.distributions) + TablesHtml(data, ReportSection::kOverview);
  std::vector<PageSection> sections = {
      {"summary", "Summary", overview},
      {"maps", "Maps from above", MapsHtml(data)},
      {"scenes", "The map in 3D", ScenesHtml(data)},
      {"overlays", "Associated edges", data.overlays.empty() ? "" : OverlaysHtml(data.overlays)},
      {"accuracy", "Accuracy", AccuracyHtml(data)},
      {"timing", "Timing", TimingHtml(data)},
      {"retrieval", "Retrieved CAD models", RetrievalHtml(data)},
      {"ablation", "Normal term", AblationHtml(data)},
      {"other", "Further tables", TablesHtml(data, ReportSection::kFurther)},
      {"environment", "Environment", EnvironmentHtml(data)}};
  std::erase_if(sections, [](const PageSection& section) { return section.html.empty(); });
  return sections;
}

}  // namespace armature
