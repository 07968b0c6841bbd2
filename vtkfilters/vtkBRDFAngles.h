#ifndef vtkBRDFAngles_h
#define vtkBRDFAngles_h
// The angles that filters over directions hold fast. For .cxx files only.

#include <brdf/geometry/Directions.h>
#include <brdf/view/Curve.h>

#include <string>

namespace vtkBRDFAngles
{
// Of vtkBRDFCurve and vtkBRDFSlice, whose angles are in degrees. Throws brdf::Error for an angle that has no such name.
template<class Filter>
brdf::CurveOptions CurveOptions(Filter* filter, const std::string& angle)
{
  brdf::CurveOptions options;
  options.angle = brdf::parseCurveAngle(angle);
  options.thetaI = brdf::radians(filter->GetThetaI());
  options.phiI = brdf::radians(filter->GetPhiI());
  options.thetaO = brdf::radians(filter->GetThetaO());
  options.phi = brdf::radians(filter->GetPhi());
  options.thetaH = brdf::radians(filter->GetThetaH());
  options.phiH = brdf::radians(filter->GetPhiH());
  options.thetaD = brdf::radians(filter->GetThetaD());
  options.phiD = brdf::radians(filter->GetPhiD());
  return options;
}
}

#endif
