// SPDX-License-Identifier: BSD-3-Clause
#include "eval/report/report_page.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "eval/report/html_table.h"
#include "eval/report/html_text.h"
#include "support/sample_report.h"

namespace armature {
namespace {

using testing::SampleReport;

constexpr char kHostile[] =
    "</script><script>alert('a')</script><!-- \"&amp; <img src=x onerror=alert(1)> \xff";

size_t Count(const std::string& text, const std::string& part) {
  size_t count = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

// What a page's JSON element holds.
std::string InlinedData(const std::string& page) {
  const std::string start = "id=\"report-data\">";
  const size_t begin = page.find(start) + start.size();
  return page.substr(begin, page.find("</script>", begin) - begin);
}

// Every text of the report is hostile.
ReportData HostileReport() {
  const std::string text = kHostile;
  ReportData data = SampleReport();
  data.title = text;
  data.remarks = {text};
  data.headline = {{text, text, text, std::nullopt, std::nullopt, text}};
  data.tables = {
      {ReportSection::kOverview, {text, {text}, {{TextCell(text)}, {Cell{text, true}}}, {text}, text, text}}};
  for (TopDownMap& map : data.maps) {
    map.sequence = map.note = text;
    for (MapLayer& layer : map.estimates) {
      layer.name = text;
      for (auto& object : layer.objects) object.id = object.category = text;
    }
  }
  const ReportPicture picture{text, text, text};
  data.stages = data.curves = data.ablations = {{text, text, picture}};
  data.overlays = {{text, text, 0, text, picture}};
  data.strips = {
      {text, text, text, picture, text, {{text, text, true, picture}, {text, text, false, std::nullopt}}}};
  for (SceneView& scene : data.scenes) {
    scene.sequence = scene.run = text;
    for (SceneView::Object& object : scene.objects) object.id = object.category = object.model = text;
  }
  data.environment = {{text, text}};
  return data;
}

TEST(HtmlText, EscapesWhatHasAMeaning) {
  EXPECT_EQ(EscapedHtml("a<b> & \"c\" 'd'"), "a&lt;b&gt; &amp; &quot;c&quot; &#39;d&#39;");
  EXPECT_EQ(EscapedJson(R"(["</script>"])"), R"(["\u003c/script>"])");
}

TEST(HtmlText, EncodesBytesInBase64) {  // the examples of RFC 4648
  EXPECT_EQ(Base64(""), "");
  EXPECT_EQ(Base64("f"), "Zg==");
  EXPECT_EQ(Base64("fo"), "Zm8=");
  EXPECT_EQ(Base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(DataUrl("image/png", "\xff\xfe"), "data:image/png;base64,//4=");
}

TEST(HtmlText, RefusesAScriptThatWouldEndItsElement) {
  EXPECT_EQ(CheckedScript("a < b"), "a < b");
  EXPECT_THROW(CheckedScript("'</script>'"), std::logic_error);
  EXPECT_THROW(CheckedScript("'<!--'"), std::logic_error);
}

TEST(HtmlTable, HoldsTheCellsWithDashesForNothing) {
  const Table table{
      "T", {"run", "error [m]"}, {{TextCell("a<b"), NumberCell(0.5, 2)}, {TextCell("c"), NoCell()}}, {}};
  EXPECT_EQ(
      TableHtml(table, "t"),
      "<figure class=\"table\" id=\"t\">\n<figcaption>T</figcaption>\n<div class=\"scroll\" role=\"region\" "
      "aria-label=\"T\" tabindex=\"0\">"
      "<table>\n<thead><tr><th scope=\"col\">run</th><th scope=\"col\" class=\"number\">error [m]</th></tr>"
      "</thead>\n<tbody>\n<tr><td>a&lt;b</td><td class=\"number\">0.50</td></tr>\n"
      "<tr><td>c</td><td class=\"number\">–</td></tr>\n</tbody></table></div>\n</figure>\n");
}

TEST(HtmlTable, FoldsLongNotesOnly) {
  Table table{"T", {"run"}, {}, {"short"}};
  EXPECT_EQ(TableHtml(table, "t").find("<details"), std::string::npos);
  table.notes.push_back(std::string(500, 'x'));
  EXPECT_NE(TableHtml(table, "t").find("<details"), std::string::npos);
}

TEST(ReportJson, TellsCellsAsShownAndNothingAsNull) {
  const auto json = ReportJson(SampleReport());
  const auto& table = json["tables"][0];
  EXPECT_EQ(table["section"], "accuracy");
  EXPECT_EQ(table["rows"][0].dump(), R"(["odometry only","chair","7","0.0431","0.1122"])");
  EXPECT_EQ(table["rows"][3].dump(), R"(["no normal term","table",null,null,null])");
}

TEST(ReportJson, TellsEveryPart) {
  const auto json = ReportJson(SampleReport());
  EXPECT_EQ(json["headline"][2]["paper_value"], nullptr);
  EXPECT_EQ(json["maps"][1]["truth"], nullptr);
  EXPECT_EQ(
      json["maps"][0]["estimates"][1]["objects"][0].dump(),
      R"({"id":"chair0","category":"chair","footprint":[[-0.24,-0.25],[0.36,-0.25],[0.36,0.25],[-0.24,0.25]],)"
      R"("front":[1.0,0.0],"error_m":0.06})");
  EXPECT_EQ(json["scenes"][0]["cameras"][0].size(), 5u);
  EXPECT_EQ(json["scenes"][0]["objects"][0]["wireframe"].size(), 12u);
  EXPECT_EQ(json["scenes"][0]["objects"][0]["cad"]["triangles"].dump(), "[0,1,2,0,2,3]");
  EXPECT_EQ(json["scenes"][0]["objects"][0]["cad"]["vertices"][1], 0.3);
  EXPECT_EQ(json["strips"][0]["models"][1]["is_true"], true);
  EXPECT_EQ(json["environment"][1].dump(), R"(["machine","2 cores"])");
}

TEST(ReportPage, InlinesTheJson) {
  const std::string page = ReportPage(SampleReport());
  EXPECT_EQ(nlohmann::ordered_json::parse(InlinedData(page)), ReportJson(SampleReport()));
}

TEST(ReportPage, LetsNoTextBecomeMarkup) {
  const std::string hostile = ReportPage(HostileReport()), harmless = ReportPage(SampleReport());
  EXPECT_EQ(Count(hostile, "</script"), Count(harmless, "</script"));
  EXPECT_EQ(Count(hostile, "<script"), Count(harmless, "<script"));
  EXPECT_EQ(Count(hostile, "<img src=x"), 0u);
  EXPECT_EQ(Count(hostile, "<!--"), 0u);
  EXPECT_EQ(Count(InlinedData(hostile), "<"), 0u);
  EXPECT_EQ(nlohmann::json::parse(InlinedData(hostile))["title"].get<std::string>().substr(0, 9),
            "</script>");
}

TEST(ReportPage, NamesNothingThatWouldBeFetched) {
  const std::string page = ReportPage(SampleReport());
  const std::string visible = page.substr(0, page.find("<script"));
  EXPECT_FALSE(std::regex_search(visible, std::regex("(src|href)=\"(?!data:|#)")));
  EXPECT_EQ(Count(visible, "url("), 0u);
  EXPECT_EQ(Count(visible, "@import"), 0u);
}

TEST(ReportPage, LeavesOutEmptySections) {
  ReportData data;
  data.title = "Nothing";
  const std::string page = ReportPage(data);
  EXPECT_EQ(Count(page, "<section"), 0u);
  EXPECT_EQ(Count(page, "<h1>Nothing</h1>"), 1u);
  data.environment = {{"machine", "2 cores"}};
  EXPECT_EQ(Count(ReportPage(data), "<section"), 1u);
}

TEST(ReportPage, HoldsPicturesTablesAndHeadlineWithoutScripts) {
  const std::string page = ReportPage(SampleReport());
  const std::string visible = page.substr(0, page.find("<script"));
  EXPECT_EQ(Count(visible, "<img src=\"data:image/svg+xml;base64,"), 2u + 2 * 5 + 3);
  EXPECT_EQ(Count(visible, "<figure class=\"model true\">"), 2u);
  EXPECT_EQ(Count(visible, "no surface to show"), 2u);
  EXPECT_EQ(Count(visible, "alt=\"front end [ms] against objects in the frame: lines, keypoints\""), 1u);
  EXPECT_EQ(Count(visible, "3 objects: lines:default, lines:fast, keypoints\""), 1u);
  EXPECT_EQ(Count(visible, "alt=\"Azimuth error.: default, no normal term\""), 1u);
  EXPECT_EQ(Count(visible, "<table>"), 3u);
  EXPECT_EQ(Count(visible, "<p class=\"ours\">0.049 m</p>"), 1u);
}

}  // namespace
}  // namespace armature
