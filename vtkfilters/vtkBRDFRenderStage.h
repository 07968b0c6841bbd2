#ifndef vtkBRDFRenderStage_h
#define vtkBRDFRenderStage_h
// What vtkBRDFRender draws, and with what. For its .cxx files only.

#include "vtkBRDF.h"
#include "vtkBRDFHeadlessRenderWindow.h"
#include "vtkBRDFPolyDataMapper.h"
#include "vtkBRDFRadiancePass.h"
#include "vtkBRDFRender.h"
#include "vtkBRDFShadows.h"
#include "vtkBRDFSurface.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <memory>
#include <vector>

class vtkBRDFRender::Scene
{
public:
  Scene()
  {
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->AutomaticLightCreationOff();
    this->Renderer->SetPass(this->Pass);
    this->Add(this->Input);
    this->Pass->BeforeFrame = [this](int frame, const std::vector<float>* wanted)
    {
      this->CastShadows(frame, wanted);
      for (Object* object : this->Objects())
      {
        object->Mapper->SetSeed(64 * this->Seed + frame); // at most 64 frames: EdgeSamples
      }
    };
  }

  // One thing of one material.
  struct Object
  {
    vtkNew<vtkActor> Actor;
    vtkNew<vtkBRDFPolyDataMapper> Mapper;
    vtkNew<vtkBRDF> Material;
    vtkSmartPointer<vtkPolyData> Surface; // null for the sphere
  };

  void Add(Object& object)
  {
    object.Mapper->SetBRDFData(object.Material);
    object.Actor->SetMapper(object.Mapper);
    this->Renderer->AddActor(object.Actor);
  }

  void CastShadows(int frame, const std::vector<float>* wanted)
  {
    if (this->CastsShadows)
    {
      this->Shadows.Cast(this->Renderer, this->Pass->Size, frame, wanted);
    }
  }

  // The input's, where it has a material, and the others.
  std::vector<Object*> Objects()
  {
    std::vector<Object*> objects;
    if (this->Input.Actor->GetVisibility())
    {
      objects.push_back(&this->Input);
    }
    for (const auto& object : this->Others)
    {
      objects.push_back(object.get());
    }
    return objects;
  }

  vtkNew<vtkBRDFHeadlessRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkBRDFRadiancePass> Pass;
  vtkNew<vtkCamera> Camera;
  int Seed = 0;
  bool CastsShadows = false;
  vtkBRDFShadows Shadows;
  Object Input;
  vtkWeakPointer<vtkPolyData> InputSource; // what the input's surface was made from, and its time then
  vtkMTimeType InputTime = 0;
  std::vector<std::unique_ptr<Object>> Others;
  vtkSmartPointer<vtkPolyData> Sphere = vtkBRDFSurface::UnitSphere();
};

#endif
