// SPDX-License-Identifier: BSD-3-Clause
// The page in a browser, opened from disk.
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <regex>

#include "eval/report/report_page.h"
#include "support/sample_report.h"
#include "support/temp_folder.h"

namespace armature {
namespace {

using nlohmann::json;
using testing::ReadFile;
using testing::SampleReport;
using testing::TempFolder;

// The probe says so, which shows that a message would be seen.
const std::vector<std::string> kOnlyTheProbe = {"the probe has seen the page"};

struct BrowserVisit {
  json seen;                          // by tests/support/report_probe.js
  std::vector<std::string> messages;  // on the console
};

bool BrowserIsThere() { return std::system("command -v chromium >/dev/null 2>&1") == 0; }

// Messages of every level, as the log does not tell errors from others: "[...:CONSOLE:1] "text", source:
// ...".
std::vector<std::string> ConsoleMessages(const std::string& log) {
  std::vector<std::string> messages;
  const std::regex pattern("CONSOLE[^\\]\n]*\\] \"(.*)\", source:");
  for (std::sregex_iterator it(log.begin(), log.end(), pattern), end; it != end; ++it) {
    messages.push_back(it->str(1));
  }
  return messages;
}

// Opens the page with the probe behind it.
BrowserVisit Visit(const std::string& page, const std::string& options) {
  const TempFolder folder;
  const std::string probe = ReadFile(ARMATURE_SOURCE_DIR "/tests/support/report_probe.js");
  folder.Write("page.html", page + "<script>" + probe + "</script>");
  const std::string command = fmt::format(
      "cd '{}' && HOME=$PWD timeout 60 chromium --headless=new --no-sandbox --disable-dev-shm-usage "
      "--no-first-run --disable-extensions --disable-background-networking --user-data-dir=profile "
      "--enable-logging=stderr --virtual-time-budget=4000 {} --dump-dom page.html >dom 2>log",
      folder.path().string(), options);
  EXPECT_EQ(std::system(command.c_str()), 0) << ReadFile(folder / "log");
  const std::string dom = ReadFile(folder / "dom"), start = "<pre id=\"probe\">";
  const size_t begin = dom.rfind(start);  // the probe's own text names it, too
  if (begin == std::string::npos)
    throw std::runtime_error("the probe saw nothing: " + ReadFile(folder / "log"));
  const std::string seen = dom.substr(begin + start.size(), dom.find("</pre>", begin) - begin - start.size());
  return {json::parse(seen), ConsoleMessages(ReadFile(folder / "log"))};
}

// The rows of all tables as the page has to show them.
json ShownCells(const ReportData& data) {
  json tables = json::array();
  const auto report = ReportJson(data);
  for (const auto& table : report["tables"]) {
    json rows = json::array();
    for (const auto& row : table["rows"]) {
      rows.push_back(json::array());
      for (const auto& cell : row) rows.back().push_back(cell.is_null() ? "–" : cell.get<std::string>());
    }
    tables.push_back(rows);
  }
  return tables;
}

// On a busy machine Chromium now and then gives up its software GL before the page has begun: that is not the
// page's fault, and another visit has it.
BrowserVisit VisitWithGl(const std::string& page) {
  constexpr int kVisits = 3;
  BrowserVisit visit;
  for (int i = 0; i < kVisits && (i == 0 || visit.seen["canvases"].empty()); ++i) {
    visit = Visit(page,
                  "--window-size=1400,1000 --use-gl=angle --use-angle=swiftshader "
                  "--enable-unsafe-swiftshader");
  }
  return visit;
}

TEST(ReportInABrowser, DrawsSortsAndEnlargesWithoutComplaint) {
  if (!BrowserIsThere()) GTEST_SKIP() << "chromium is not installed";
  const auto [seen, messages] = VisitWithGl(ReportPage(SampleReport()));
  EXPECT_EQ(messages, kOnlyTheProbe);
  EXPECT_EQ(seen["cells"], ShownCells(SampleReport()));
  ASSERT_EQ(seen["plots"].size(), 3u);  // bars, curves, and the normal term's bars
  for (const json& plot : seen["plots"]) EXPECT_EQ(plot["drawn"], true) << plot;
  EXPECT_NE(seen["plots"][1]["alt"].get<std::string>().find("lines, keypoints"), std::string::npos);
  EXPECT_EQ(seen["panels"], json({2, 1}));
  EXPECT_EQ(seen["objects"], json({6, 3}));
  EXPECT_EQ(seen["errors"], json({4, 0}));
  ASSERT_EQ(seen["canvases"].size(), 1u);
  EXPECT_GT(seen["canvases"][0], 20);
  ASSERT_EQ(seen["other"].size(), 1u);  // still one context
  EXPECT_GT(seen["other"][0], 20);
  EXPECT_EQ(seen["moved"], json({{true, true, true, true}, {false, false, false, false}}));
  const json column = {"0.1122", "0.0492", "0.1001", "–"};
  EXPECT_EQ(seen["sorted"][0], json({"ascending", {"0.0492", "0.1001", "0.1122", "–"}}));
  EXPECT_EQ(seen["sorted"][1], json({"descending", {"0.1122", "0.1001", "0.0492", "–"}}));
  EXPECT_EQ(seen["sorted"][2], json({"none", column}));
  EXPECT_EQ(seen["enlarged"], json({true, "later"}));
  EXPECT_EQ(seen["backgrounds"], json({"rgb(255, 255, 255)", "rgb(21, 24, 27)"}));  // light, then dark
  EXPECT_EQ(seen["plots"][0]["background"], "rgb(255, 255, 255)");
}

TEST(ReportInABrowser, IsReadableOnANarrowScreenWithoutWebGl) {
  if (!BrowserIsThere()) GTEST_SKIP() << "chromium is not installed";
  const auto [seen, messages] =
      Visit(ReportPage(SampleReport()), "--window-size=500,1000 --disable-gpu --disable-3d-apis");
  EXPECT_EQ(messages, kOnlyTheProbe);
  EXPECT_EQ(seen["canvases"].size(), 0u);
  EXPECT_NE(seen["scene"].get<std::string>().find("has no WebGL"), std::string::npos);
  EXPECT_EQ(seen["overflow"], 0);
}

}  // namespace
}  // namespace armature
