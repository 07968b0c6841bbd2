#pragma once
// A probe for all tests of this program, or the reason why there is none.
#include <brdf/base/Error.h>
#include <gtest/gtest.h>
#include <vtkBRDFShaderProbe.h>

#include <memory>
#include <string>

namespace brdf::test {

struct Probe {
  std::unique_ptr<vtkBRDFShaderProbe> probe;
  std::string reason;
};

inline const Probe& sharedProbe() {
  static const Probe shared = [] {
    Probe made;
    try {
      made.probe = std::make_unique<vtkBRDFShaderProbe>();
      std::printf("GLSL runs on: %s\n", made.probe->GetDeviceDescription().c_str());
    } catch (const Error& error) {
      made.reason = error.what();
    }
    return made;
  }();
  return shared;
}

/// Fixture that skips where there is no OpenGL.
class GlslTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!sharedProbe().probe) GTEST_SKIP() << sharedProbe().reason;
  }
  vtkBRDFShaderProbe& probe() const { return *sharedProbe().probe; }
};

}  // namespace brdf::test
