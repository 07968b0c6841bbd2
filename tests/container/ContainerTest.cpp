#include <brdf/base/File.h>
#include <brdf/io/Container.h>
#include <brdf/io/Sha256.h>
#include <brdf/material/LobeSum.h>
#include <gtest/gtest.h>

#include <sys/resource.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "Samples.h"

namespace fs = std::filesystem;
using brdf::Container;
using brdf::ContainerWriter;
using samples::errorOf;
using samples::freshFolder;

namespace {

brdf::Provenance someProvenance() {
  brdf::Provenance provenance;
  provenance.read.format = "cornell";
  provenance.read.source = "somewhere/garnet.brdf";
  provenance.read.samples = 1439;
  provenance.read.invalid = 3;
  provenance.read.negative = 2;
  provenance.read.notFinite = 1;
  provenance.read.belowHorizon = 4;
  provenance.read.assumptions = {"values are 1/sr without the cosine", "", "\xc3\xa9t\xc3\xa9"};
  provenance.read.warnings = {"three samples are not usable"};
  provenance.read.metadata = {{"sample", "paint"}, {"empty", ""}};
  provenance.sha256 = std::string(64, 'a');
  provenance.options = "--max-theta 80";
  provenance.program = "some program";
  provenance.date = "2026-11-22T00:00:00Z";
  return provenance;
}

std::size_t filesIn(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
}

}  // namespace

TEST(Container, ScatteredSamplesComeBackBitForBit) {
  const fs::path path = freshFolder("scattered") / "a.vtkhdf";
  const auto written = samples::scattered();
  brdf::writeContainer(path, "paint", *written, someProvenance());
  const Container container(path);
  ASSERT_EQ(container.entries().size(), 1U);
  EXPECT_EQ(container.entries()[0].name, "paint");
  EXPECT_EQ(container.entries()[0].kind, "scattered");
  EXPECT_EQ(container.entries()[0].description, "scattered test samples");
  EXPECT_TRUE(samples::sameSamples(*container.load(0), *written));
}

TEST(Container, UncertaintiesOfScatteredSamplesComeBackBitForBit) {
  const fs::path path = freshFolder("uncertain") / "a.vtkhdf";
  brdf::ScatteredSamples data = samples::scattered()->data();
  for (std::size_t i = 0; i < data.values.size(); ++i) data.uncertainty.push_back(static_cast<double>(i + 1) / 700);
  data.uncertainty[3] = std::numeric_limits<double>::quiet_NaN();
  const brdf::ScatteredBrdf written(data, "uncertain samples");
  brdf::writeContainer(path, "a", written, {});
  const auto read = Container(path).load(0);
  const std::vector<double>& back = dynamic_cast<const brdf::ScatteredBrdf&>(*read).data().uncertainty;
  ASSERT_EQ(back.size(), data.uncertainty.size());
  for (std::size_t i = 0; i < back.size(); ++i)
    if (i == 3)
      EXPECT_TRUE(std::isnan(back[i]));
    else
      EXPECT_EQ(back[i], data.uncertainty[i]) << i;
}

TEST(Container, SamplesOfAnySizeComeBackBitForBit) {  // in the header, in one chunk, in many chunks
  const fs::path folder = freshFolder("sizes");
  for (const std::size_t count : {1, 100, 3000, 200000}) {
    const auto written = samples::scattered(count);
    brdf::writeContainer(folder / "a.vtkhdf", "a", *written, {});
    EXPECT_TRUE(samples::sameSamples(*Container(folder / "a.vtkhdf").load(0), *written)) << count;
  }
}

TEST(Container, AnalyticMaterialsComeBackExactly) {
  const fs::path path = freshFolder("analytic") / "a.vtkhdf";
  ContainerWriter writer(path);
  const std::vector<std::string> expressions = {
      "0.1*Lambertian", "(0.3,0.1,0.05)*Lambertian + 0.04*GGX(alpha=0.2, ior=1.5)",
      "Ward(ax=0.1, ay=0.3333333333333333) + 2*GGX(alpha=(0.1, 0.2, 0.30000000000000004))",
      "0.5*Microfacet(D=Beckmann(alpha=0.1), F=Conductor(eta=0.2, k=3), G=Smith)"};
  for (std::size_t i = 0; i < expressions.size(); ++i)
    writer.add("m" + std::to_string(i), *brdf::parseMaterialExpression(expressions[i]), {});
  const auto spectral = std::make_shared<const brdf::LobeSum>(
      std::vector<brdf::Lobe>{{brdf::findModel("Lambertian"), {}, {0.1, 0.2, 1.0 / 3, 0.4}}},
      brdf::Channels::spectral({400, 500, 600, 700}));
  writer.add("spectral", *spectral, {});
  writer.commit();

  const Container container(path);
  for (std::size_t i = 0; i < expressions.size(); ++i) {
    EXPECT_EQ(container.entries()[i].kind, "analytic");
    const auto written = brdf::parseMaterialExpression(expressions[i]);
    const auto read = std::dynamic_pointer_cast<const brdf::LobeSum>(container.load(i));
    ASSERT_TRUE(read);
    EXPECT_EQ(read->description(), written->description());
    ASSERT_EQ(read->lobes().size(), written->lobes().size());
    for (std::size_t l = 0; l < read->lobes().size(); ++l) {
      EXPECT_EQ(read->lobes()[l].parameters, written->lobes()[l].parameters);
      EXPECT_EQ(read->lobes()[l].scale, written->lobes()[l].scale);
    }
  }
  EXPECT_EQ(container.load(expressions.size())->channels(), spectral->channels());
}

TEST(Container, ProvenanceComesBack) {
  const fs::path path = freshFolder("provenance") / "a.vtkhdf";
  const brdf::Provenance written = someProvenance();
  brdf::writeContainer(path, "a", *samples::scattered(), written);
  const brdf::Provenance read = Container(path).provenance(0);
  EXPECT_EQ(read.read.format, written.read.format);
  EXPECT_EQ(read.read.source, written.read.source);
  EXPECT_EQ(read.read.samples, written.read.samples);
  EXPECT_EQ(read.read.invalid, written.read.invalid);
  EXPECT_EQ(read.read.negative, written.read.negative);
  EXPECT_EQ(read.read.notFinite, written.read.notFinite);
  EXPECT_EQ(read.read.belowHorizon, written.read.belowHorizon);
  EXPECT_EQ(read.read.assumptions, written.read.assumptions);
  EXPECT_EQ(read.read.warnings, written.read.warnings);
  EXPECT_EQ(read.read.metadata, written.read.metadata);
  EXPECT_EQ(read.sha256, written.sha256);
  EXPECT_EQ(read.options, written.options);
  EXPECT_EQ(read.program, written.program);
  EXPECT_EQ(read.date, written.date);
}

TEST(Container, ProvenanceOfAFileHoldsItsHash) {
  const fs::path folder = freshFolder("hash");
  brdf::writeFile(folder / "source.txt", "abc");
  brdf::ReadReport report;
  report.source = (folder / "source.txt").string();
  EXPECT_EQ(brdf::makeProvenance(report).sha256, brdf::sha256("abc"));
  report.source = (folder / "missing.txt").string();
  EXPECT_EQ(brdf::makeProvenance(report).sha256, "");
}

TEST(Container, AppendingKeepsWhatIsThere) {
  const fs::path path = freshFolder("append") / "a.vtkhdf";
  for (int i = 0; i < 12; ++i) {  // more than ten, so that text order and number order differ
    ContainerWriter writer(path, ContainerWriter::Mode::Append);
    writer.add("entry" + std::to_string(i), *samples::scattered(10 + static_cast<std::size_t>(i)), {});
    writer.commit();
  }
  const Container container(path);
  ASSERT_EQ(container.entries().size(), 12U);
  for (std::size_t i = 0; i < 12; ++i) {
    EXPECT_EQ(container.entries()[i].name, "entry" + std::to_string(i));
    EXPECT_TRUE(samples::sameSamples(*container.load(i), *samples::scattered(10 + i)));
    EXPECT_EQ(container.find(std::to_string(i)), i);
    EXPECT_EQ(container.find("entry" + std::to_string(i)), i);
  }
}

TEST(Container, AnEmptyOneOpens) {
  const fs::path path = freshFolder("empty") / "a.vtkhdf";
  ContainerWriter(path).commit();
  const Container container(path);
  EXPECT_TRUE(container.entries().empty());
  EXPECT_NE(errorOf([&] { container.find("0"); }).find("the container is empty"), std::string::npos);
}

TEST(Container, AnUnknownEntryIsAnErrorThatListsTheKnown) {
  const fs::path path = freshFolder("unknown") / "a.vtkhdf";
  brdf::writeContainer(path, "paint", *samples::scattered(), {});
  const std::string error = errorOf([&] { Container(path).find("pain"); });
  EXPECT_NE(error.find("a.vtkhdf"), std::string::npos) << error;
  EXPECT_NE(error.find("0 (paint)"), std::string::npos) << error;
}

TEST(Container, BadNamesAreRefusedAndLeaveNoTrace) {
  const fs::path path = freshFolder("names") / "a.vtkhdf";
  ContainerWriter writer(path);
  writer.add("paint", *samples::scattered(), {});
  for (const std::string& name : std::vector<std::string>{"", "3", "a#b", "paint", std::string(300, 'x')})
    EXPECT_NE(errorOf([&] { writer.add(name, *samples::scattered(), {}); }).find("bad name"), std::string::npos)
        << name;
  writer.commit();
  EXPECT_EQ(Container(path).entries().size(), 1U);
}

TEST(Container, ABrdfThatCannotBeKeptLeavesNoTrace) {
  class Unknown : public brdf::Brdf {
   public:
    const brdf::Channels& channels() const override { return channels_; }
    brdf::Symmetry symmetry() const override { return brdf::Symmetry::Isotropic; }
    bool reciprocal() const override { return true; }
    std::string description() const override { return "unknown"; }
    void evaluate(const brdf::DirectionPairs<double>&, double*, std::uint8_t*) const override {}
    using brdf::Brdf::evaluate;

   private:
    brdf::Channels channels_;
  };
  const fs::path path = freshFolder("unkept") / "a.vtkhdf";
  ContainerWriter writer(path);
  EXPECT_NE(errorOf([&] { writer.add("a", Unknown(), {}); }).find("cannot keep"), std::string::npos);
  writer.add("a", *samples::scattered(), {});
  writer.commit();
  EXPECT_EQ(Container(path).entries().size(), 1U);
}

TEST(Container, WhatIsNeverCommittedChangesNothing) {
  const fs::path folder = freshFolder("uncommitted");
  brdf::writeContainer(folder / "a.vtkhdf", "a", *samples::scattered(), {});
  const std::string before = brdf::readFile(folder / "a.vtkhdf");
  {
    ContainerWriter writer(folder / "a.vtkhdf", ContainerWriter::Mode::Append);
    writer.add("b", *samples::scattered(5000), {});
  }
  EXPECT_EQ(brdf::readFile(folder / "a.vtkhdf"), before);
  EXPECT_EQ(filesIn(folder), 1U);
}

TEST(Container, AFullDiskLeavesTheOldFileAlone) {  // simulated: this process may write no file beyond 4 KiB
  const fs::path folder = freshFolder("full");
  brdf::writeContainer(folder / "a.vtkhdf", "a", *samples::scattered(), {});
  const std::string before = brdf::readFile(folder / "a.vtkhdf");
  ContainerWriter writer(folder / "a.vtkhdf", ContainerWriter::Mode::Append);
  writer.add("b", *samples::scattered(5000), {});
  rlimit old{};
  getrlimit(RLIMIT_FSIZE, &old);
  const rlimit small{4096, old.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string error = errorOf([&] { writer.commit(); });
  setrlimit(RLIMIT_FSIZE, &old);
  std::signal(SIGXFSZ, handler);
  EXPECT_NE(error.find("cannot be written"), std::string::npos) << error;
  EXPECT_EQ(brdf::readFile(folder / "a.vtkhdf"), before);
  EXPECT_EQ(filesIn(folder), 1U);
}

TEST(Container, AMissingFolderIsAnError) {
  const fs::path path = freshFolder("nofolder") / "missing" / "a.vtkhdf";
  EXPECT_NE(errorOf([&] { brdf::writeContainer(path, "a", *samples::scattered(), {}); }).find("cannot be written"),
            std::string::npos);
}

TEST(Container, AppendingToSomethingElseIsAnErrorAndKeepsIt) {
  const fs::path path = freshFolder("other") / "a.vtkhdf";
  brdf::writeFile(path, "not a container");
  EXPECT_NE(errorOf([&] { ContainerWriter(path, ContainerWriter::Mode::Append); }).find("not an intact HDF5 file"),
            std::string::npos);
  EXPECT_EQ(brdf::readFile(path), "not a container");
}

TEST(Container, OneMaterialWrittenTwiceGivesTheSameBytes) {
  const fs::path folder = freshFolder("deterministic");
  brdf::writeContainer(folder / "a.vtkhdf", "a", *samples::scattered(), {});
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // HDF5's clocks tick seconds
  brdf::writeContainer(folder / "b.vtkhdf", "a", *samples::scattered(), {});
  EXPECT_TRUE(brdf::readFile(folder / "a.vtkhdf") == brdf::readFile(folder / "b.vtkhdf"));
}
