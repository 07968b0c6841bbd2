// The words of vtkBRDFLobeView: headings, legends, and what its colour bar says.
#include "vtkBRDFDrawing.h"
#include "vtkBRDFLobePlan.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <brdf/view/LobeTransform.h>

#include <algorithm>

using namespace vtkBRDFDrawing;

namespace
{
std::size_t Letters(double pixels, int text)
{
  return static_cast<std::size_t>(std::max(8.0, 1.85 * pixels / text));
}
}

void vtkBRDFLobeView::AddCaptions(const Plan& plan)
{
  const Frame& frame = plan.Room;
  const int text = frame.Text;
  const std::string quantity = brdf::lobeScaleLabel({ brdf::parseLobeTransform(this->Transform), this->Floor });
  std::string title = this->Shape == "value" ? "Lobe length: " + quantity : "A less B: " + quantity;
  std::string note = this->Channel + "; theta_i = " + NumberText(this->ThetaI, 6) +
                     "\u00b0, phi_i = " + NumberText(this->PhiI, 6) + "\u00b0; rim" +
                     (this->Shape == "value" ? " and half circle" : "") + ": " + NumberText(plan.Length);
  if (this->Shape == "displaced")
  {
    note += "; hemisphere of no difference: " + NumberText((*this->Inputs)[0].Lobe->GetReferenceRadius());
  }
  if (plan.Shown.Samples)
  {
    note += "; " + std::to_string(plan.Shown.Samples->GetNumberFound()) + " samples within " +
            NumberText(this->SampleAngle) + "\u00b0 of the light";
    if (plan.Shown.Samples->GetNumberFound() == 0)
    {
      note += ", the nearest at " + NumberText(plan.Shown.Samples->GetNearest(), 2) + "\u00b0";
    }
  }
  AddHeading(
    this->GetRenderer(),
    Shortened(this->GetTitle().empty() ? title : this->GetTitle(), Letters(frame.Width - 2 * text, text * 5 / 4)),
    Shortened(note, Letters(frame.Width - 2 * text, text)),
    frame.Height - text,
    text);
}

void vtkBRDFLobeView::AddKey(const Plan& plan, std::size_t input, Point low)
{
  const double size = 0.9 * plan.Room.Text;
  const Point high = { low[0] + 1.1 * size, low[1] + size };
  if (plan.Shown.Replace(input))
  {
    AddDots(this->GetRenderer(), { { (low[0] + high[0]) / 2, (low[1] + high[1]) / 2 } }, size / 3.5, Ink);
    return;
  }
  if (this->IsDifference())
  {
    AddRectangles(this->GetRenderer(), { { low, high, Diverging(input == 0 ? 0.9 : 0.1) } });
    return;
  }
  if (!this->IsColored(input))
  {
    AddRectangles(this->GetRenderer(), { { low, high, PaletteColor(input) } });
    return;
  }
  // Its own colours: some of them.
  std::vector<Rectangle> keys;
  for (int k = 0; k < 3; ++k)
  {
    const Color trueColors[3] = { { 0.85, 0.2, 0.2 }, { 0.2, 0.65, 0.2 }, { 0.2, 0.3, 0.85 } };
    const double width = (high[0] - low[0]) / 3;
    keys.push_back({ { low[0] + k * width, low[1] },
                     { low[0] + (k + 1) * width, high[1] },
                     this->ColourOfLobes() == "true" ? trueColors[k] : Sequential(0.15 + 0.35 * k) });
  }
  AddRectangles(this->GetRenderer(), keys);
}

void vtkBRDFLobeView::AddName(const Plan& plan, std::size_t input, Point at, double width, bool below)
{
  const int text = plan.Room.Text;
  std::string name = this->NameOf(input);
  std::string remark = "largest " + NumberText((*this->Inputs)[input].Lobe->GetMaximumLength());
  if (this->IsDifference())
  {
    name = input == 0 ? "A: " + name + " (red: above B)" : "B: " + name + " (blue: above A)";
    remark.clear();
  }
  else if (plan.Shown.Replace(input))
  {
    remark = "samples; largest " + NumberText(plan.Shown.Samples->GetMaximumLength());
  }
  AddKey(plan, input, { at[0], at[1] - 0.05 * text });
  const Point beside = { at[0] + 1.6 * text, at[1] };
  const std::size_t letters = Letters(width - 2.2 * text, text);
  if (below)
  {
    AddText(this->GetRenderer(), Shortened(name, letters), beside, { .Size = text });
    AddText(this->GetRenderer(), remark, { beside[0], at[1] - 1.4 * text }, { .Size = text, .Foreground = Faint });
    return;
  }
  if (!remark.empty())
  {
    remark = "  (" + remark + ")";
  }
  AddText(this->GetRenderer(),
          Shortened(name, letters - std::min(letters, remark.size())) + remark,
          beside,
          { .Size = text });
}

void vtkBRDFLobeView::AddLegend(const Plan& plan)
{
  const Frame& frame = plan.Room;
  const int text = frame.Text;
  if (plan.IsSideBySide())
  {
    for (std::size_t stage = 0; stage < plan.Drawn.size(); ++stage)
    {
      const Point corner = frame.Corner(stage);
      const double left = corner[0] + 0.8 * text;
      this->AddName(plan, plan.Drawn[stage], { left, corner[1] + 1.8 * text }, frame.StageWidth() - text, true);
    }
    return;
  }
  const double width = (frame.Width - text) / static_cast<double>(frame.LegendColumns);
  for (std::size_t i = 0; i < this->Inputs->size(); ++i)
  {
    const std::size_t column = i / frame.LegendRows, row = frame.LegendRows - 1 - i % frame.LegendRows;
    this->AddName(plan, i, { text + column * width, 0.8 * text + 1.5 * text * row }, width, false);
  }
}

void vtkBRDFLobeView::ChooseScale(Plan& plan) const
{
  const brdf::LobeScale lengths = { brdf::parseLobeTransform(this->Transform), this->Floor };
  const std::string quantity = brdf::lobeScaleLabel(lengths), colour = this->ColourOfLobes();
  const auto positive = [](double number) { return number > 0 ? number : 1; };
  plan.HasBar = true;
  if (plan.Shown.HasResiduals())
  {
    plan.Scale = SignedScale(positive(plan.Shown.Samples->GetMaximumResidual()));
    plan.BarTitle = "model less sample: " + quantity;
  }
  else if (this->IsDifference())
  {
    plan.Scale = SignedScale(positive((*this->Inputs)[0].Lobe->GetMaximumLength()));
    plan.BarTitle = "A less B: " + quantity;
  }
  else if (colour == "value")
  {
    plan.Scale.High = plan.Length;
    plan.BarTitle = quantity;
  }
  else if (colour != "material" && colour != "true")
  {
    plan.Scale.Low = lengths.transform == brdf::LobeTransform::LogFloor ? this->Floor : 0;
    plan.Scale.High = 0;
    for (std::size_t input : plan.Drawn)
    {
      if (vtkDataArray* values = (*this->Inputs)[input].Lobe->GetOutput()->GetPointData()->GetArray("colour"))
      {
        plan.Scale.High = std::max(plan.Scale.High, values->GetRange(0)[1]);
      }
    }
    if (!(plan.Scale.High > plan.Scale.Low))
    {
      plan.Scale.High = plan.Scale.Low + 1;
    }
    plan.Scale.Transform = [lengths](double value) { return brdf::transformed(lengths, value); };
    plan.BarTitle = "f_r, " + colour + " (1/sr)";
  }
  else
  {
    plan.HasBar = false;
  }
}
