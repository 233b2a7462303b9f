#include "visibility_map/write_text.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdio>
#include <random>

namespace sightline::text {
namespace {

std::string number(double value, int digits = 17) {
  std::string out;
  append(out, value, digits);
  return out;
}

TEST(Text, DoublesAsPrintfInTheCLocale) {
  std::mt19937_64 random(3);
  for (int round = 0; round < 100000; ++round) {
    const double value = std::bit_cast<double>(random());
    if (!(value - value == 0)) continue;
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, "%.17g", value);
    ASSERT_EQ(number(value), buffer);
  }
  EXPECT_EQ(number(-0.0), "0");
  EXPECT_EQ(number(0.1), "0.10000000000000001");
  EXPECT_EQ(number(100), "100");
}

TEST(Text, FixedNumbersAreShort) {
  const auto fixed = [](double value, int decimals) {
    std::string out;
    append_fixed(out, value, decimals);
    return out;
  };
  EXPECT_EQ(fixed(1.5, 3), "1.5");
  EXPECT_EQ(fixed(100, 3), "100");
  EXPECT_EQ(fixed(0.0004, 3), "0");
  EXPECT_EQ(fixed(-0.0004, 3), "0");
  EXPECT_EQ(fixed(-0.25, 3), "-0.25");
  EXPECT_EQ(fixed(1200, 0), "1200");
}

TEST(Text, StringsAreAlwaysUtf8) {
  const auto json = [](const std::string& text) {
    std::string out;
    append_json_string(out, text);
    return out;
  };
  EXPECT_EQ(json("a/\"b\\\t\x01"), R"("a/\"b\\\u0009\u0001")");
  EXPECT_EQ(json("gr\xC3\xBC\xC3\x9F \xF0\x9F\x8F\xA0"), "\"gr\xC3\xBC\xC3\x9F \xF0\x9F\x8F\xA0\"");
  for (const char* bad : {"\xFF", "\xC0\x80", "\xE0\x80\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xF0\x80\x80\x80"}) {
    EXPECT_EQ(json(bad).substr(1, 3), "\xEF\xBF\xBD");
  }
  EXPECT_EQ(json("\xE2\x82"), "\"\xEF\xBF\xBD\xEF\xBF\xBD\"");
  EXPECT_EQ(utf8("a\xFF"), "a\xEF\xBF\xBD");
  std::string xml;
  append_xml(xml, "<a & \"b\">\x02\xEF\xBF\xBF");
  EXPECT_EQ(xml, "&lt;a &amp; &quot;b&quot;&gt;\xEF\xBF\xBD\xEF\xBF\xBD");
}

}  // namespace
}  // namespace sightline::text
