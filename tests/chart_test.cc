// SPDX-License-Identifier: MIT
// What charts are made of: names of benchmarks, their medians, fronts and axes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "bad_input.h"
#include "chart/charts.h"
#include "chart/figure.h"
#include "chart/marks.h"
#include "chart/results.h"
#include "chart/targets.h"
#include "simd/count.h"

namespace gaunt::tool {
namespace {

// Files of one test, removed after it.
class ChartResults : public testing::Test {
 protected:
  std::string Write(const std::string& text) {
    paths_.push_back(testing::TempDir() + "gaunt_chart_" +
                     testing::UnitTest::GetInstance()->current_test_info()->name() +
                     std::to_string(paths_.size()) + ".json");
    std::ofstream(paths_.back()) << text;
    return paths_.back();
  }
  std::string WriteRows(const std::string& rows) {
    return Write("{\"context\": {\"compiler\": \"cc 1\"}, \"benchmarks\": [\n" + rows + "]}\n");
  }
  void TearDown() override {
    for (const std::string& path : paths_) std::remove(path.c_str());
  }
  void ExpectRejected(const std::string& path, const std::string& word) {
    try {
      ReadResults({path});
      ADD_FAILURE() << "taken for results";
    } catch (const BadInput& error) {
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
  }

 private:
  std::vector<std::string> paths_;
};

TEST(ChartNames, OfTimings) {
  const auto name = ParseMarkName("rotate/matrix_mono/n16/tiled/1024/AVX3_ZEN4");
  ASSERT_TRUE(name.has_value());
  EXPECT_EQ(name->family, "rotate");
  EXPECT_EQ(name->op, "matrix_mono");
  EXPECT_EQ(name->order, 16);
  EXPECT_EQ(name->layout, "tiled");
  EXPECT_EQ(name->items, 1024u);
  EXPECT_EQ(name->target, "AVX3_ZEN4");
}

TEST(ChartNames, OfSeries) {
  const auto name = ParseSeriesName("rotate/drift/quaternion/1000");
  ASSERT_TRUE(name.has_value());
  EXPECT_EQ(name->family, "rotate");
  EXPECT_EQ(name->series, "drift");
  EXPECT_EQ(name->line, "quaternion");
}

TEST(ChartNames, OfOtherBenchmarksAreNone) {
  for (const char* name :
       {"", "rotate", "frame/2000_objects_2048/AVX3", "project/cubemap/n3/rgba32f/64/AVX3",
        "rotate/matrix/3/tiled/1024/AVX3", "rotate/matrix/n3/tiled/many/AVX3",
        "rotate/matrix/n3/tiled/1024/AVX3/more", "rotate/matrix/n3/tiled/1024/",
        "rotate/matrix/n3/tiled/99999999999999999999/AVX3", "//////", "rotate/drift//1",
        "rotate/dr ift/line/1", "rotate/matrix/n3/tiled//AVX3"}) {
    EXPECT_FALSE(ParseMarkName(name).has_value()) << name;
    EXPECT_FALSE(ParseSeriesName(name).has_value()) << name;
  }
}

TEST(ChartNames, MayBeOfAnyLength) {
  const std::string text(1000000, 'a');
  EXPECT_FALSE(ParseMarkName(text).has_value());
  EXPECT_FALSE(ParseSeriesName(text).has_value());
  EXPECT_TRUE(ParseSeriesName("f/" + text + "/line/1").has_value());
}

TEST(ChartTargets, AreInCapitalsBestFirst) {
  EXPECT_TRUE(IsTarget("AVX3_ZEN4"));
  EXPECT_TRUE(IsTarget("Z99"));
  for (const char* loop : {"", "engine", "A2_clang_native"}) EXPECT_FALSE(IsTarget(loop)) << loop;
  EXPECT_TRUE(TargetBefore("AVX3_ZEN4", "AVX3"));
  EXPECT_TRUE(TargetBefore("AVX3", "AVX2"));
  EXPECT_TRUE(TargetBefore("SCALAR", "A_NEW_ONE"));
  EXPECT_TRUE(TargetBefore("A_NEW_ONE", "B_NEW_ONE"));
  EXPECT_FALSE(TargetBefore("A_NEW_ONE", "SCALAR"));
  EXPECT_NE(TargetColour("AVX3"), TargetColour("AVX2"));
}

TEST(ChartMedian, IsTheMiddleOrTheMeanOfTwo) {
  EXPECT_EQ(Median({3.0}), 3.0);
  EXPECT_EQ(Median({9.0, 1.0, 2.0}), 2.0);
  EXPECT_EQ(Median({4.0, 100.0, 1.0, 2.0}), 3.0);
}

TEST(ChartFront, HasWhatNothingBeatsInBoth) {
  const std::vector<Point> front =
      ParetoFront({{3, 3}, {1, 9}, {2, 9}, {5, 1}, {4, 4}, {3, 5}, {9, 1}, {1, 10}});
  ASSERT_EQ(front.size(), 3u);
  const Point expected[] = {{1, 9}, {3, 3}, {5, 1}};
  for (size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(front[k].x, expected[k].x);
    EXPECT_EQ(front[k].y, expected[k].y);
  }
  EXPECT_TRUE(ParetoFront({}).empty());
}

TEST_F(ChartResults, AreMediansOfRepetitions) {
  const std::string a = WriteRows(R"({"name": "f/late", "family_index": 7, "ns_item": 1},
    {"name": "f/early", "family_index": 2, "label": "words", "ns_item": 5},
    {"name": "f/early", "family_index": 2, "label": "words", "ns_item": 3})");
  const std::string b = WriteRows(R"({"name": "f/early", "family_index": 2, "ns_item": 40})");
  const Results results = ReadResults({a, b});
  EXPECT_EQ(results.compiler, "cc 1");
  ASSERT_EQ(results.rows.size(), 2u);
  EXPECT_EQ(results.rows[0].name, "f/early");
  EXPECT_EQ(results.rows[0].counters.at("ns_item"), 5.0);
  EXPECT_EQ(results.rows[1].name, "f/late");
  // Whatever order they ran in.
  EXPECT_EQ(results.rows[1].counters.at("ns_item"), 1.0);
}

TEST_F(ChartResults, PreferTheMediansOfTheFile) {
  const Results results = ReadResults({WriteRows(
      R"({"name": "f/a", "run_name": "f/a", "run_type": "iteration", "ns_item": 100},
    {"name": "f/a_mean", "run_name": "f/a", "run_type": "aggregate", "aggregate_name": "mean",
     "ns_item": 50},
    {"name": "f/a_median", "run_name": "f/a", "run_type": "aggregate", "aggregate_name": "median",
     "ns_item": 7})")});
  ASSERT_EQ(results.rows.size(), 1u);
  EXPECT_EQ(results.rows[0].name, "f/a");
  EXPECT_EQ(results.rows[0].counters.at("ns_item"), 7.0);
}

TEST_F(ChartResults, TakeNumbersThatJsonHasNot) {
  const Results results = ReadResults(
      {WriteRows("{\"name\": \"f/a\",\n\"add\": NaN,\n\"mul\": -Infinity,\n\"fma\": 2}")});
  ASSERT_EQ(results.rows.size(), 1u);
  EXPECT_EQ(results.rows[0].counters.count("add"), 0u);
  EXPECT_EQ(results.rows[0].counters.count("mul"), 0u);
  EXPECT_EQ(results.rows[0].counters.at("fma"), 2.0);
}

TEST_F(ChartResults, OfAnythingElseAreRejected) {
  ExpectRejected("/nowhere/results.json", "cannot read");
  ExpectRejected(testing::TempDir(), "cannot read");
  ExpectRejected(Write(""), "cut short");
  ExpectRejected(Write("{\"benchmarks\": [{\"name\": \"f/a\""), "cut short");
  for (const char* foreign :
       {"[]", "3", "{}", "{\"benchmarks\": 3}", "{\"benchmarks\": [3]}", "{\"benchmarks\": [{}]}",
        "{\"benchmarks\": [{\"name\": 3}]}", "{\"context\": 3, \"benchmarks\": []}"}) {
    ExpectRejected(Write(foreign), "not what gaunt_bench writes");
  }
  ExpectRejected(
      WriteRows(R"({"name": "f/a", "error_occurred": true, "error_message": "the call failed"})"),
      "f/a failed: the call failed");
}

Results Rows() {
  const std::map<std::string, double> kernel = {
      {"ns_item", 2.0}, {"mul", 3.0}, {"fma", 4.0}, {"error", 1e-7}, {"limit_ns", 1.0}};
  const std::map<std::string, double> loop = {{"ns_item", 9.0}, {"error", 2e-7}};
  return {"cc 1",
          {{"f/op/n3/tiled/1024/SCALAR", "method", kernel},
           {"f/op/n3/tiled/1024/EMU128", "job: method", kernel},
           {"f/op/n3/planar/1024/EMU128", "method", kernel},
           {"f/op/n3/tiled/1000/EMU128", "method", kernel},
           {"f/op/n9/tiled/1024/EMU128", "method", kernel},
           {"f/other_job/n3/tiled/1024/EMU128", "", kernel},
           {"g/op/n3/tiled/1024/EMU128", "method", kernel},
           {"f/op/n3/interleaved/1024/engine", "job: scalar loop", loop},
           {"f/drift/b/10", "line b", {{"x", 10.0}, {"error", 3e-7}}},
           {"f/drift/b/1", "line b", {{"x", 1.0}, {"error", 1e-7}}},
           {"f/drift/a/1", "line a", {{"x", 1.0}, {"error", 2e-7}}},
           {"f/drift/a/3", "line a", {{"x", 3.0}, {"error", 0.0}}},
           {"f/drift/a/4", "line a", {{"x", 4.0}, {"error", std::nan("")}}},
           {"f/drift/a/5", "line a", {{"x", 5.0}, {"error", 1e300}}},
           {"f/drift/none/1", "line c", {{"x", 1.0}, {"error", 0.0}}},
           {"g/drift/a/1", "line a", {{"x", 1.0}, {"error", 2e-7}}}},
          {{"f/drift", "drift of something: how"}, {"g/drift", "another"}}};
}

TEST(ChartMarks, AreThoseOfTheSelectionBestTargetFirst) {
  const std::vector<Mark> marks = SelectMarks(Rows(), {"f", "tiled", 1024, 2, 8});
  ASSERT_EQ(marks.size(), 3u);
  EXPECT_EQ(marks[0].target, "EMU128");
  EXPECT_EQ(marks[0].multiplies, 7.0);
  EXPECT_EQ(marks[1].target, "SCALAR");
  EXPECT_TRUE(marks[2].is_baseline());
  EXPECT_EQ(marks[2].method, "scalar loop");
  EXPECT_FALSE(marks[2].multiplies.has_value());
  // A label without a job is its own.
  EXPECT_EQ(marks[0].job, "job");
  EXPECT_EQ(marks[0].method, "method");
  EXPECT_EQ(marks[1].job, "method");
  EXPECT_EQ(marks[2].job, "job");
}

TEST(ChartMarks, DependOnNoOrderOfRows) {
  Results turned = Rows();
  std::reverse(turned.rows.begin(), turned.rows.end());
  const Selection selection = {"f", "tiled", 1024, 2, 8};
  const std::vector<Mark> marks = SelectMarks(Rows(), selection);
  EXPECT_EQ(ErrorChart("f", "", SelectMarks(turned, selection)).Script(),
            ErrorChart("f", "", marks).Script());
  EXPECT_EQ(SeriesChart("f", "", SelectSeries(turned, "f")[0]).Script(),
            SeriesChart("f", "", SelectSeries(Rows(), "f")[0]).Script());
}

TEST(ChartMarks, WithoutKernelsSayWhatThereIs) {
  try {
    SelectMarks(Rows(), {"f", "interleaved", 1024, 2, 8});
    ADD_FAILURE() << "found kernels";
  } catch (const BadInput& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("planar with 1024 items; tiled with 1000, 1024 items, of orders 3 to 9"),
              std::string::npos)
        << message;
  }
}

// A front for each job that has kernels, and none through the marks of another.
TEST(ChartError, HasAFrontForEachJob) {
  const auto mark = [](const char* job, const char* target, double ns, double error) {
    Mark made = {};
    made.label = made.job = made.method = job;
    made.target = target;
    made.order = 3;
    made.ns = ns;
    made.error = error;
    return made;
  };
  const auto count = [](const std::string& text, const std::string& word) {
    size_t found = 0;
    for (size_t at = 0; (at = text.find(word, at)) != std::string::npos; at += word.size()) ++found;
    return found;
  };
  const std::string script =
      ErrorChart("f", "", {mark("a", "AVX2", 1, 1e-7), mark("b", "AVX2", 2, 2e-7)}).Script();
  EXPECT_EQ(count(script, "Pareto front"), 2u);
  // Into its mark, across, and in the legend.
  EXPECT_EQ(count(script, "linecolor rgb '#444444' dashtype solid"), 2u);
  EXPECT_EQ(count(script, "linecolor rgb '#444444' dashtype (10,7)"), 2u);
  EXPECT_EQ(count(ErrorChart("f", "", {mark("a", "", 1, 1e-7)}).Script(), "Pareto front"), 0u);
}

TEST(ChartMarks, OfSeriesRunByTheirSteps) {
  const std::vector<SeriesData> all = SelectSeries(Rows(), "f");
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].name, "drift");
  ASSERT_EQ(all[0].lines.size(), 2u);
  EXPECT_EQ(all[0].title, "drift of something");
  EXPECT_EQ(all[0].conditions, "how");
  EXPECT_EQ(all[0].lines[0].label, "line a");
  EXPECT_EQ(all[0].lines[0].points.size(), 1u) << "a point that no axis has";
  EXPECT_EQ(all[0].lines[1].label, "line b");
  ASSERT_EQ(all[0].lines[1].points.size(), 2u);
  EXPECT_EQ(all[0].lines[1].points[0].x, 1.0);
  EXPECT_EQ(all[0].lines[1].points[1].y, 3e-7);
}

OperationRow RowOf(const char* op, const char* order, const char* variant, uint64_t mul,
                   uint64_t fma) {
  OperationRow row = {op, order, variant, {}};
  row.operations.mul = mul;
  row.operations.fma = fma;
  return row;
}

TEST(ChartGrowth, FitsAKnownPowerFromAnOrderOn) {
  std::vector<Point> points = {{2, 1e6}, {3, 1e-6}};  // are not fitted
  for (const double n : {4.0, 5.0, 7.0, 10.0}) points.push_back({n, 0.3 * std::pow(n, 4.1)});
  ASSERT_TRUE(GrowthExponent(points, 4).has_value());
  EXPECT_NEAR(*GrowthExponent(points, 4), 4.1, 1e-12);
  EXPECT_GT(std::abs(*GrowthExponent(points, 2) - 4.1), 1.0);
  EXPECT_TRUE(GrowthExponent(points, 7).has_value());
  EXPECT_FALSE(GrowthExponent(points, 10).has_value());
  EXPECT_FALSE(GrowthExponent({{5, 1}, {5, 2}}, 4).has_value());
  // Between two that are off by the same factor, which a least square weighs alike.
  EXPECT_NEAR(*GrowthExponent({{4, 16}, {8, 64 * 2}, {8, 64 / 2}, {16, 256}}, 4), 2.0, 1e-12);
}

TEST(ChartGrowth, HasEveryVariantAndTheOthersByPlainOrder) {
  OperationRows rows = {
      RowOf("product", "3", "quick", 5, 6),       RowOf("product", "2", "quick", 3, 4),
      RowOf("product", "3", "slow", 50, 60),      RowOf("product", "10", "slow", 70, 80),
      RowOf("product", "1", "quick", 1, 0),       RowOf("product", "11", "quick", 1, 0),
      RowOf("product", "6x6->3", "quick", 9, 9),  RowOf("product", "4", "alone", 9, 9),
      RowOf("product_square", "2", "slow", 9, 9), RowOf("product_square", "3", "slow", 9, 9),
      RowOf("product_square", "2", "fast", 1, 2), RowOf("product_square", "3", "fast", 3, 4),
      RowOf("product_others", "2", "fast", 9, 9), RowOf("product_others", "3", "fast", 9, 9),
      RowOf("another", "2", "a", 1, 1),           RowOf("another", "3", "a", 1, 1),
      RowOf("another", "2", "b", 1, 1),           RowOf("another", "3", "b", 1, 1)};
  const std::vector<SeriesLine> lines = SelectGrowth(rows, "product");
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0].label, "product, quick");
  ASSERT_EQ(lines[0].points.size(), 2u);
  EXPECT_EQ(lines[0].points[0].x, 2.0);
  EXPECT_EQ(lines[0].points[0].y, 7.0);
  EXPECT_EQ(lines[0].points[1].x, 3.0);
  EXPECT_EQ(lines[0].points[1].y, 11.0);
  EXPECT_EQ(lines[1].label, "product, slow");
  EXPECT_EQ(lines[1].points.back().x, 10.0);
  EXPECT_EQ(lines[2].label, "product_square, fast");
  EXPECT_TRUE(SelectGrowth(rows, "another").empty());
  EXPECT_TRUE(SelectGrowth(rows, "").empty());
  rows.erase(rows.begin() + 2, rows.begin() + 4);
  EXPECT_TRUE(SelectGrowth(rows, "product").empty()) << "one variant has nothing to compare";
}

// Whatever kernels there are: what the rows say is what is drawn.
TEST(ChartGrowth, OfProductsHasAllTheirLinesAndThePublishedOne) {
  const OperationRows rows = AllOperations();
  const std::vector<SeriesLine> lines = SelectGrowth(rows, "product");
  std::set<std::string> labels, variants;
  std::map<std::string, int> orders;
  for (const SeriesLine& line : lines) labels.insert(line.label);
  EXPECT_EQ(labels.size(), lines.size());
  for (const OperationRow& row : rows) {
    const bool plain = row.order.find('x') == std::string::npos && row.order != "1";
    const std::string label = row.op + ", " + row.variant;
    if (row.op == "product" && plain && ++orders[label] == 2) variants.insert(label);
  }
  for (const char* other : {"product_square, fast", "product_prepared, fast", "product_zonal, mono",
                            "product, fast", "product, fewest"}) {
    variants.insert(other);
  }
  EXPECT_EQ(labels, variants);
  const auto published = PublishedOf("product");
  ASSERT_TRUE(published.has_value());
  EXPECT_FALSE(PublishedOf("rotate").has_value());
  ASSERT_EQ(published->points.size(), 6u);
  EXPECT_EQ(published->points[4].y, 2527.0);
  const std::string script = GrowthChart("product", lines, published).Script();
  for (const std::string& label : labels) {
    EXPECT_NE(script.find('"' + label), std::string::npos) << label;
  }
  EXPECT_NE(script.find("\n7 5351\n"), std::string::npos);
  EXPECT_NE(script.find("the line to beat"), std::string::npos);
  EXPECT_EQ(GrowthChart("product", lines, {}).Script().find("the line to beat"), std::string::npos);
}

TEST(ChartGrowth, PrintsTheExponents) {
  SeriesLine line = {"cubes", {}};
  for (const double n : {2.0, 3.0, 4.0, 5.0, 6.0}) line.points.push_back({n, n * n * n});
  const std::string script = GrowthChart("f", {line}, {}).Script();
  EXPECT_NE(script.find("cubes: n^3.0"), std::string::npos);
}

TEST(ChartAxis, HoldsItsValuesAndHasRoundTicks) {
  for (const std::vector<double>& values : {std::vector<double>{1.0},
                                            {0.07, 900.0},
                                            {2e-7, 3e-7},
                                            {1.0, 10.0},
                                            {1e-12, 1e5},
                                            {1e-30, 1e30}}) {
    const Axis axis(values);
    for (const double value : values) {
      EXPECT_GT(axis.Share(value), 0.0);
      EXPECT_LT(axis.Share(value), 1.0);
    }
    EXPECT_GE(axis.ticks().size(), 3u);
    EXPECT_LE(axis.ticks().size(), 9u);
    for (const Tick& tick : axis.ticks()) {
      EXPECT_GE(tick.at, axis.from());
      EXPECT_LE(tick.at, axis.to());
    }
  }
  const Axis powers({2e-7, 3e-7}, Axis::Format::kPowers);
  std::vector<std::string> labels;
  for (const Tick& tick : powers.ticks()) labels.push_back(tick.label);
  EXPECT_EQ(labels, (std::vector<std::string>{"10⁻⁷", "2×10⁻⁷", "5×10⁻⁷"}));
}

TEST(ChartAxis, EndsWhateverItIsGiven) {
  constexpr double kHuge = std::numeric_limits<double>::infinity();
  for (const std::vector<double>& values :
       {std::vector<double>{}, {0.0}, {-1.0}, {kHuge}, {std::nan("")}, {1e-320, 1e308}}) {
    const Axis axis(values);
    EXPECT_GT(axis.from(), 0.0);
    EXPECT_LT(axis.to(), kHuge);
  }
}

TEST(ChartAxis, OfStepsHasThoseThatAreTaken) {
  const Axis axis({1, 1000}, Axis::Format::kSteps);
  std::vector<std::string> labels;
  for (const Tick& tick : axis.ticks()) labels.push_back(tick.label);
  EXPECT_EQ(labels, (std::vector<std::string>{"1", "3", "10", "30", "100", "300", "1000"}));
}

TEST(ChartAxis, OfDigitsHasEveryOne) {
  const Axis axis({2, 10}, Axis::Format::kDigits);
  std::vector<std::string> labels;
  for (const Tick& tick : axis.ticks()) labels.push_back(tick.label);
  EXPECT_EQ(labels, (std::vector<std::string>{"2", "3", "4", "5", "6", "7", "8", "9", "10"}));
}

TEST(ChartColours, GetLighterAndDiffer) {
  const auto luminance = [](const std::string& colour) {
    const long rgb = std::strtol(colour.c_str() + 1, nullptr, 16);
    return 0.2126 * static_cast<double>(rgb >> 16) + 0.7152 * static_cast<double>(rgb >> 8 & 255) +
           0.0722 * static_cast<double>(rgb & 255);
  };
  for (size_t count = 1; count <= 6; ++count) {
    const std::vector<std::string> colours = Colours(count);
    ASSERT_EQ(colours.size(), count);
    for (size_t k = 1; k < count; ++k) {
      EXPECT_GT(luminance(colours[k]), luminance(colours[k - 1]) + 20.0) << count << " " << k;
    }
  }
}

// What comes from files is data to gnuplot, never commands.
TEST(ChartScript, QuotesTexts) {
  EXPECT_EQ(Quoted("plain, 2×10⁻⁷: 1"), "\"plain, 2×10⁻⁷: 1\"");
  EXPECT_EQ(Quoted("\"`@\\\n7"), R"("\042\140\100\134 7")");
  EXPECT_EQ(Quoted("'17x"), R"("\047\061\067x")");
  EXPECT_EQ(Quoted("${NAME}"), R"("\044\173NAME\175")");
  const Figure figure =
      SeriesChart("f", "cc\n!rm", {"drift", {{"`a`", {{1.0, 1e-7}}}}, "title", ""});
  const std::string script = figure.Script();
  EXPECT_NE(script.find(R"("\140a\140")"), std::string::npos);
  EXPECT_NE(script.find(R"("cc !rm")"), std::string::npos);
}

TEST(ChartScript, ShortensWhatDoesNotFit) {
  EXPECT_EQ(Shortened("it fits", 200, 12), "it fits");
  const std::string kept = Shortened(std::string(1000, 'x'), 200, 12);
  EXPECT_LT(kept.size(), 40u);
  EXPECT_EQ(kept.substr(kept.size() - 3), "…");
  // Between characters.
  EXPECT_EQ(Shortened("⁻⁻⁻⁻", 15, 10), "⁻…");
}

TEST(ChartScript, GrowsWithItsLines) {
  SeriesData series = {"drift", {}, "title", ""};
  for (int k = 0; k < 40; ++k) series.lines.push_back({std::to_string(k), {{1.0, 1e-7}}});
  EXPECT_GT(SeriesChart("f", "", series).height, 40 * 16);
}

}  // namespace
}  // namespace gaunt::tool
