// SPDX-License-Identifier: BSD-3-Clause
#include "eval/report/html_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "eval/report/html_text.h"

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

}  // namespace

std::string PlotsHtml(const std::vector<ReportPlot>& plots) {
  if (plots.empty()) return "";
  std::string html = "<div class=\"plots\">\n";
  for (const ReportPlot& plot : plots) {
    html += fmt::format("<figure>\n<figcaption><b>{}</b> {}</figcaption>\n{}</figure>\n",
                        EscapedHtml(plot.sequence), EscapedHtml(plot.caption), ImageHtml(plot.picture));
  }
  return html + "</div>\n";
}

std::string OverlaysHtml(const std::vector<OverlayFrame>& frames) {
  std::string html = "<div class=\"gallery\">\n";
  for (const OverlayFrame& frame : frames) html += FrameHtml(frame);
  return html + "</div>\n";
}

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

}  // namespace armature
