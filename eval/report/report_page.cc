// SPDX-License-Identifier: BSD-3-Clause
#include "eval/report/report_page.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "eval/report/html_text.h"
#include "eval/report/report_sections.h"

// Defined by report_assets.s, which eval/report/assets/CMakeLists.txt writes.
extern "C" {
extern const char armature_asset_style[], armature_asset_style_end[];
extern const char armature_asset_d3[], armature_asset_d3_end[];
extern const char armature_asset_three[], armature_asset_three_end[];
extern const char armature_asset_scripts[], armature_asset_scripts_end[];
extern const char armature_asset_licences[], armature_asset_licences_end[];
}

namespace armature {
namespace {

// The files of eval/report/assets and the libraries that the page's scripts use, as they were when the
// program was built.
std::string_view ReportStyle() { return {armature_asset_style, armature_asset_style_end}; }
// https://d3js.org
std::string_view ReportD3() { return {armature_asset_d3, armature_asset_d3_end}; }
// https://threejs.org with its OrbitControls
std::string_view ReportThree() { return {armature_asset_three, armature_asset_three_end}; }
std::string_view ReportScripts() { return {armature_asset_scripts, armature_asset_scripts_end}; }
// Of the two libraries.
std::string_view ReportLicences() { return {armature_asset_licences, armature_asset_licences_end}; }

std::string FormatPageHead(const std::string& title) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{}</title>\n"
      "<link rel=\"icon\" href=\"data:,\">\n<style>\n{}</style>\n</head>\n",
      EscapedHtml(title), CheckedScript(ReportStyle()));
}

std::string Navigation(const std::vector<PageSection>& sections) {
  std::string html = "<nav aria-label=\"Contents\">\n<ul>\n";
  for (const PageSection& section : sections) {
    html += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", section.id, section.title);
  }
  return html + "</ul>\n</nav>\n";
}

std::string SectionHtml(const PageSection& section) {
  return fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n{}</section>\n", section.id, section.title,
                     section.html);
}

std::string Footer() {
  return fmt::format(
      "<footer>\n<p>Written by <code>armature report</code>. Plots by gnuplot, maps by d3.js (BSD-3-Clause), "
      "3D "
      "views by three.js (MIT), both inlined.</p>\n<details><summary>Their "
      "licences</summary><pre>{}</pre></details>\n</footer>\n",
      EscapedHtml(ReportLicences()));
}

// What invalid UTF-8 there is becomes U+FFFD, as a browser shows it in the rest of the page.
std::string InlinedJson(const ReportData& data) {
  return EscapedJson(ReportJson(data).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

std::string Scripts(const ReportData& data) {
  std::string html =
      fmt::format("<script type=\"application/json\" id=\"report-data\">{}</script>\n", InlinedJson(data));
  html += fmt::format("<script>\n{}</script>\n", CheckedScript(ReportD3()));
  if (!data.scenes.empty()) html += fmt::format("<script>\n{}</script>\n", CheckedScript(ReportThree()));
  return html + fmt::format("<script>\n{}</script>\n", CheckedScript(ReportScripts()));
}

}  // namespace

std::string ReportPage(const ReportData& data) {
  const std::vector<PageSection> sections = ReportSections(data);
  std::string html = FormatPageHead(data.title);
  html += fmt::format("<body>\n<header><h1>{}</h1></header>\n{}<main>\n", EscapedHtml(data.title),
                      Navigation(sections));
  for (const PageSection& section : sections) html += SectionHtml(section);
  return html + "</main>\n" + Footer() + Scripts(data) + "</body>\n</html>\n";
}

}  // namespace armature
