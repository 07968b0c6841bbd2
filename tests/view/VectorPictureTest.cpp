#include <brdf/base/Text.h>
#include <brdf/view/VectorPicture.h>

#include <gtest/gtest.h>

#include <pugixml.hpp>

namespace brdf {
namespace {

VectorPicture picture() {
  using Picture = VectorPicture;
  Picture result{200, 100, "A < B & \"C\" (D)", {}};
  result.elements.emplace_back(Picture::Line{{{10, 20}, {30.5, 40}, {50, 20}}, {1, 0, 0, 0.5}, 2, {3, 1}});
  result.elements.emplace_back(Picture::Area{{{0, 0}, {10, 0}, {0, 1e-7}}, {0, 1, 0}}, Picture::Rectangle{1, 2, 3, 4});
  result.elements.emplace_back(
      Picture::Text{"90\u00b0 (x)", {100, 50}, 10, Picture::Align::High, Picture::Align::Middle, 90, true});
  result.elements.emplace_back(Picture::Image{2, 1, {255, 0, 0, 0, 0, 255}, "not looked at", {20, 30, 40, 50}});
  return result;
}

TEST(VectorPicture, SvgHoldsTextAndPathsWithTheOriginBelow) {
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(svgText(picture()).c_str()));
  const pugi::xml_node svg = document.child("svg"), group = svg.child("g");
  EXPECT_STREQ(svg.child_value("title"), "A < B & \"C\" (D)");
  EXPECT_STREQ(svg.attribute("width").value(), "200");
  EXPECT_STREQ(group.child("path").attribute("d").value(), "M10 80 30.5 60 50 80");
  EXPECT_STREQ(group.child("path").attribute("stroke-opacity").value(), "0.5");
  const pugi::xml_node text = group.child("text");
  EXPECT_STREQ(text.child_value(), "90\u00b0 (x)");
  EXPECT_STREQ(text.attribute("transform").value(), "translate(100 50) rotate(-90)");
  EXPECT_STREQ(text.attribute("text-anchor").value(), "end");
  EXPECT_STREQ(group.child("clipPath").child("rect").attribute("y").value(), "94");
  EXPECT_STREQ(group.child("image").attribute("y").value(), "20");
  EXPECT_STREQ(group.child("image").attribute("height").value(), "50");
}

TEST(VectorPicture, EveryEntryOfThePdfsTablePointsToItsObject) {
  const std::string pdf = pdfText(picture());
  ASSERT_TRUE(pdf.starts_with("%PDF-1.4\n"));
  const std::size_t start = pdf.rfind("startxref\n");
  const auto table =
      static_cast<std::size_t>(*parseNumber(trimmed(pdf.substr(start + 10, pdf.rfind("%%EOF") - start - 10))));
  ASSERT_EQ(pdf.substr(table, 10), "xref\n0 9\n0");  // catalogue, pages, page, content, two fonts, title, image
  for (std::size_t k = 1; k < 9; ++k) {
    const std::string entry = pdf.substr(table + 9 + 20 * k, 20);
    EXPECT_EQ(entry.substr(10), " 00000 n \n");
    const auto offset = static_cast<std::size_t>(*parseNumber(entry.substr(0, 10)));
    EXPECT_EQ(pdf.substr(offset, 7), std::to_string(k) + " 0 obj");
  }
}

TEST(VectorPicture, PdfHoldsTextInLatinLettersAndStreamsOfTheStatedLength) {
  const std::string pdf = pdfText(picture());
  EXPECT_NE(pdf.find("(90\xB0 \\(x\\)) Tj"), std::string::npos);
  EXPECT_NE(pdf.find("/Title (A < B & \"C\" \\(D\\))"), std::string::npos);
  EXPECT_NE(pdf.find("10 20 m 30.500 40 l 50 20 l S"), std::string::npos);
  EXPECT_EQ(pdf.find("e-"), std::string::npos);  // PDF has no exponents
  std::size_t streams = 0;
  for (std::size_t at = pdf.find("/Length "); at != std::string::npos; at = pdf.find("/Length ", at + 1), ++streams) {
    const std::size_t end = pdf.find(' ', at + 8);
    const auto length = static_cast<std::size_t>(*parseNumber(pdf.substr(at + 8, end - at - 8)));
    const std::size_t data = pdf.find("stream\n", end) + 7;
    EXPECT_EQ(pdf.substr(data + length, 10), "\nendstream");
  }
  EXPECT_EQ(streams, 2u);
}

TEST(VectorPicture, WidthsAreThoseOfHelvetica) {
  // Adobe's metrics: digits 556, A 667, space 278, degree 400; bold A 722.
  EXPECT_NEAR(helveticaWidth("12 A\u00b0", false), 2 * 0.556 + 0.278 + 0.667 + 0.4, 1e-12);
  EXPECT_NEAR(helveticaWidth("A", true), 0.722, 1e-12);
  EXPECT_NEAR(helveticaWidth("~@", false), 0.584 + 1.015, 1e-12);
  EXPECT_EQ(helveticaWidth("", false), 0);
}

}  // namespace
}  // namespace brdf
