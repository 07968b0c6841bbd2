// Objects to render: shapes and files, with what files lack made, and bad files refused.
#include "../TestFolder.h"

#include <brdf/base/File.h>
#include <brdf/geometry/Directions.h>
#include <gtest/gtest.h>
#include <vtkBRDF.h>
#include <vtkBRDFObjectSource.h>
#include <vtkBRDFRender.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkOutputWindow.h>
#include <vtkPLYWriter.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSTLWriter.h>
#include <vtkSphereSource.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <sstream>

namespace {

using brdf::Direction;

class ObjectSource : public testing::Test {
 protected:
  void SetUp() override { vtkObject::GlobalWarningDisplayOff(); }
  void TearDown() override { vtkObject::GlobalWarningDisplayOn(); }

  std::string written(const std::string& name, const std::string& text) {
    const auto path = folder_ / name;
    brdf::writeFile(path, text);
    return path.string();
  }
  vtkPolyData* make(const std::string& object) {
    source_->SetObject(object);
    source_->Update();
    return source_->GetOutput();
  }
  /// Why a file is refused, without its folder.
  std::string refusal(const std::string& name, const std::string& text) {
    make(written(name, text));
    EXPECT_EQ(source_->GetOutput()->GetNumberOfCells(), 0);
    std::string reason = source_->GetErrorText();
    EXPECT_EQ(reason.find('\n'), std::string::npos) << reason;
    const std::string folder = folder_.string() + "/";
    for (std::size_t at; (at = reason.find(folder)) != std::string::npos;) reason.erase(at, folder.size());
    return reason.empty() ? "accepted" : reason;
  }
  static Direction tuple(vtkDataArray* array, vtkIdType k) {
    Direction d{};
    array->GetTuple(k, d.data());
    return d;
  }

  std::filesystem::path folder_ = testFolder("objects");
  vtkNew<vtkBRDFObjectSource> source_;
};

/// A triangle (0,0,0), (1,0,0), (0,1,0) in a buffer beside its indices, under two nodes: moved by (1,2,3), then its
/// parent doubles it.
std::string gltf(const std::string& accessorCount = "3", const std::string& children = "[1]",
                 const std::string& mesh = "0") {
  // 9 floats and 3 shorts, base64.
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
    "nodes":[{"scale":[2,2,2],"children":)" +
         children + R"(},{"translation":[1,2,3],"mesh":)" + mesh + R"(}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
    "accessors":[{"bufferView":0,"componentType":5126,"count":)" +
         accessorCount + R"(,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
                 {"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}],
    "bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":6}],
    "buffers":[{"byteLength":42,"uri":"triangle.bin"}]})";
}

std::string triangleBuffer() {
  const float points[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  const std::uint16_t corners[3] = {0, 1, 2};
  std::string bytes(42, '\0');
  std::memcpy(bytes.data(), points, 36);
  std::memcpy(bytes.data() + 36, corners, 6);
  return bytes;
}

}  // namespace

TEST_F(ObjectSource, ShapesHaveUnitNormalsAndTangentsAcrossThemWhereTheTrianglesFace) {
  std::istringstream names(vtkBRDFObjectSource::GetShapeNames());
  int count = 0;
  for (std::string name; names >> name; ++count) {
    vtkPolyData* shape = make(name);
    ASSERT_EQ(source_->GetErrorText(), "");
    vtkDataArray *normals = shape->GetPointData()->GetNormals(), *tangents = shape->GetPointData()->GetTangents();
    ASSERT_TRUE(normals && tangents) << name;
    double farthest = 0;
    for (vtkIdType k = 0; k < shape->GetNumberOfPoints(); ++k) {
      const Direction n = tuple(normals, k), t = tuple(tangents, k);
      ASSERT_NEAR(brdf::dot(n, n), 1, 1e-5) << name << ' ' << k;
      ASSERT_NEAR(brdf::dot(t, t), 1, 1e-5) << name << ' ' << k;
      ASSERT_NEAR(brdf::dot(n, t), 0, 1e-5) << name << ' ' << k;
      double p[3];
      shape->GetPoint(k, p);
      farthest = std::max(farthest, std::hypot(p[0], p[1], p[2]));
    }
    EXPECT_GT(farthest, 0.7) << name;
    EXPECT_LT(farthest, 1.8) << name;
    // Corners face as their normals do.
    std::size_t against = 0;
    vtkIdType corners = 0;
    const vtkIdType* c = nullptr;
    for (shape->GetPolys()->InitTraversal(); shape->GetPolys()->GetNextCell(corners, c);) {
      ASSERT_EQ(corners, name == "sphere" ? corners : 3);
      double a[3], b[3], d[3];
      shape->GetPoint(c[0], a);
      shape->GetPoint(c[1], b);
      shape->GetPoint(c[2], d);
      const Direction flat =
          brdf::cross({b[0] - a[0], b[1] - a[1], b[2] - a[2]}, {d[0] - a[0], d[1] - a[1], d[2] - a[2]});
      against += brdf::dot(flat, tuple(normals, c[0])) + brdf::dot(flat, tuple(normals, c[1])) +
                     brdf::dot(flat, tuple(normals, c[2])) <
                 0;
    }
    EXPECT_EQ(against, 0u) << name;
  }
  EXPECT_GE(count, 18);
}

TEST_F(ObjectSource, TheTorusHasTheNormalsOfItsClosedForm) {
  vtkPolyData* torus = make("torus");
  // Ring radius 1 and tube 0.45 about +y, scaled to lie within 1.
  const double ring = 1 / 1.45;
  double worst = 1;
  for (vtkIdType k = 0; k < torus->GetNumberOfPoints(); ++k) {
    double p[3];
    torus->GetPoint(k, p);
    const double around = std::hypot(p[0], p[2]);
    const Direction n = brdf::normalized({p[0] * (1 - ring / around), p[1], p[2] * (1 - ring / around)});
    const Direction t = brdf::normalized({p[2], 0, -p[0]});
    worst = std::min({worst, brdf::dot(n, tuple(torus->GetPointData()->GetNormals(), k)),
                      std::abs(brdf::dot(t, tuple(torus->GetPointData()->GetTangents(), k)))});
  }
  EXPECT_GT(worst, 1 - 1e-6);
}

TEST_F(ObjectSource, EveryKindOfFileGivesTheSameSurface) {
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(2);
  sphere->SetCenter(1, 2, 3);
  sphere->SetThetaResolution(40);
  sphere->SetPhiResolution(40);
  sphere->GenerateNormalsOff();
  sphere->Update();
  const auto write = [&](auto&& writer, const char* name) {
    const std::string path = (folder_ / name).string();
    writer->SetFileName(path.c_str());
    writer->SetInputData(sphere->GetOutput());
    writer->Write();
    return path;
  };
  std::string obj;
  vtkPolyData* points = sphere->GetOutput();
  for (vtkIdType k = 0; k < points->GetNumberOfPoints(); ++k) {
    const double* p = points->GetPoint(k);
    obj += "v " + std::to_string(p[0]) + ' ' + std::to_string(p[1]) + ' ' + std::to_string(p[2]) + '\n';
  }
  for (vtkIdType k = 0; k < points->GetNumberOfCells(); ++k) {
    vtkNew<vtkIdList> c;
    points->GetCellPoints(k, c);
    obj += "f " + std::to_string(c->GetId(0) + 1) + ' ' + std::to_string(c->GetId(1) + 1) + ' ' +
           std::to_string(c->GetId(2) + 1) + '\n';
  }
  for (const std::string& path :
       {write(vtkSmartPointer<vtkPLYWriter>::New(), "a.ply"), write(vtkSmartPointer<vtkSTLWriter>::New(), "a.stl"),
        write(vtkSmartPointer<vtkXMLPolyDataWriter>::New(), "a.vtp"), written("a.obj", obj)}) {
    vtkPolyData* read = make(path);
    ASSERT_EQ(source_->GetErrorText(), "");
    EXPECT_EQ(read->GetNumberOfPoints(), points->GetNumberOfPoints()) << path;
    for (vtkIdType k = 0; k < read->GetNumberOfPoints(); ++k) {
      double p[3];
      read->GetPoint(k, p);
      const Direction outwards = brdf::normalized({p[0] - 1, p[1] - 2, p[2] - 3});
      const Direction n = tuple(read->GetPointData()->GetNormals(), k),
                      t = tuple(read->GetPointData()->GetTangents(), k);
      ASSERT_GT(brdf::dot(n, outwards), 0.99) << path;
      ASSERT_NEAR(t[1], 0, 1e-5) << path << ": around the vertical";
    }
  }
}

TEST_F(ObjectSource, NodesOfGltfPutTheirMeshesInPlace) {
  written("triangle.bin", triangleBuffer());
  const std::string json = gltf();
  std::string glb = json;
  const std::string uri = ",\"uri\":\"triangle.bin\"";
  glb.erase(glb.find(uri), uri.size());
  while (glb.size() % 4) glb += ' ';
  const auto word = [](std::uint32_t value) { return std::string(reinterpret_cast<const char*>(&value), 4); };
  const std::string binary = triangleBuffer() + std::string(2, '\0');
  const std::string whole = "glTF" + word(2) + word(static_cast<std::uint32_t>(28 + glb.size() + binary.size())) +
                            word(static_cast<std::uint32_t>(glb.size())) + "JSON" + glb +
                            word(static_cast<std::uint32_t>(binary.size())) + std::string("BIN\0", 4) + binary;
  for (const std::string& path : {written("a.gltf", json), written("a.glb", whole)}) {
    vtkPolyData* read = make(path);
    ASSERT_EQ(source_->GetErrorText(), "");
    ASSERT_EQ(read->GetNumberOfPoints(), 3) << path;
    double bounds[6];
    read->GetBounds(bounds);
    const double expected[6] = {2, 4, 4, 6, 6, 6};
    for (int k = 0; k < 6; ++k) EXPECT_NEAR(bounds[k], expected[k], 1e-5) << path << ' ' << k;
    EXPECT_NEAR(tuple(read->GetPointData()->GetNormals(), 0)[2], 1, 1e-5);
  }
}

TEST_F(ObjectSource, TextureCoordinatesGiveTheTangents) {
  vtkPolyData* read = make(written("a.obj",
                                   "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 0 1\nvt -1 1\nvt -1 0\n"
                                   "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n"));
  ASSERT_EQ(source_->GetErrorText(), "");
  for (vtkIdType k = 0; k < read->GetNumberOfPoints(); ++k)
    EXPECT_NEAR(tuple(read->GetPointData()->GetTangents(), k)[1], -1, 1e-5);  // u falls with y
}

TEST_F(ObjectSource, BadFilesAreRefusedInOneLine) {
  EXPECT_NE(refusal("a.txt", "x").find("unknown kind of object"), std::string::npos);
  EXPECT_EQ(refusal("a.obj", ""),
            "a.obj: no surface in the file; found 0 polygons; allowed: a mesh: .ply, .obj, .stl, "
            ".vtp, .gltf, .glb");
  EXPECT_EQ(refusal("b.obj", "v 0 0 0\nv 1 0 0\nf 1 2 3\n"),
            "b.obj, line 3: a corner is none of the points before or after it; found 3; allowed: 1 to 2");
  EXPECT_NE(refusal("c.obj", "v 0 0 0\nv 1 0 0\nv 0 nan 0\nf 1 2 3\n"), "accepted");
  EXPECT_NE(refusal("d.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n").find("with an area"), std::string::npos);
}

TEST_F(ObjectSource, HostileFilesDoNotEndTheProgram) {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
  const std::string face = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  EXPECT_EQ(make(written("good.ply", ply + face + points + "3 0 1 2\n"))->GetNumberOfCells(), 1);
  EXPECT_NE(refusal("a.ply", ply + face + points + "3 0 1 7\n").find("no point"), std::string::npos);
  EXPECT_NE(refusal("b.ply", ply + face + points + "200 0 1 2\n").find("file can hold"), std::string::npos);
  EXPECT_NE(refusal("c.ply", "ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nend_header\n")
                .find("line 3: not a count"),
            std::string::npos);
  EXPECT_NE(refusal("d.ply", ply + face + points).find("ends early"), std::string::npos);
  const std::string binary =
      "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uint int vertex_indices\nend_header\n" +
      std::string(12, '\0') + std::string(4, '\xff') + "0000";
  EXPECT_NE(refusal("e.ply", binary).find("ends early"), std::string::npos);
  EXPECT_NE(refusal("a.stl", std::string(80, 'x') + std::string(4, '\x7f')).find("more triangles"), std::string::npos);
  EXPECT_NE(refusal("a.vtp",
                    "<VTKFile type=\"PolyData\"><PolyData><Piece NumberOfPoints=\"99999999999\"/></PolyData>"
                    "</VTKFile>")
                .find("not a count"),
            std::string::npos);
}

TEST_F(ObjectSource, HostileGltfIsRefusedBeforeItIsRead) {
  written("triangle.bin", triangleBuffer());
  EXPECT_NE(refusal("a.gltf", gltf("300")).find("accessors[0]: an accessor past the end"), std::string::npos);
  EXPECT_NE(refusal("b.gltf", gltf("3", "[0]")).find("circle"), std::string::npos);
  EXPECT_NE(refusal("c.gltf", gltf("3", "[9]")).find("nodes[0].children[0]: an index of nothing"), std::string::npos);
  EXPECT_NE(refusal("d.gltf", gltf("3", "[1]", "4")).find("nodes[1].mesh: an index of nothing"), std::string::npos);
  EXPECT_NE(refusal("e.gltf", "{").find("JSON"), std::string::npos);
  EXPECT_NE(refusal("f.glb", "glTF").find("ends early"), std::string::npos);
  written("triangle.bin", "short");
  EXPECT_NE(refusal("g.gltf", gltf()).find("a buffer shorter than it says; found 5 bytes"), std::string::npos);
}

// What vtkBRDFRender says of bad objects needs no graphics device.
TEST_F(ObjectSource, TheRendererRefusesBadObjectsWithoutADevice) {
  vtkNew<vtkBRDFRender> render;
  render->Update();
  EXPECT_NE(render->GetErrorText().find("nothing to render"), std::string::npos) << render->GetErrorText();
  vtkNew<vtkBRDF> empty;
  render->SetInputData(empty);
  render->Update();
  EXPECT_NE(render->GetErrorText().find("no BRDF"), std::string::npos) << render->GetErrorText();
}
