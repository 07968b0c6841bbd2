#include "vtkBRDFConvergence.h"

#include <brdf/sampling/Sequence.h>

#include <algorithm>
#include <cstdint>
#include <limits>

vtkBRDFConvergence::vtkBRDFConvergence(int width, int height, int maximum, double tolerance, bool spread)
  : Picture(static_cast<std::size_t>(width), static_cast<std::size_t>(height))
  , Maximum(std::max((maximum + Replicates - 1) / Replicates, 1))
  , Tolerance(tolerance)
  , Spread(spread)
  , LongestFrame(16) // few, where every frame is another place in the pixels
  , RoundEnd(std::min(RoundStart, this->Maximum))
  , Error(std::numeric_limits<double>::infinity())
{
  if (!spread)
  {
    // Up to about a second of a software device's time.
    constexpr int mostPoints = 1 << 22;
    this->LongestFrame = std::clamp(mostPoints / (width * height), 16, 256);
  }
  this->Current.Count = this->RoundEnd;
  this->Place();
}

void vtkBRDFConvergence::Place()
{
  if (!this->Spread)
  {
    return;
  }
  // Random shifts, one a replicate: any numbers that have nothing to do with each other.
  const auto shift = [this](std::uint64_t axis)
  {
    std::uint64_t bits = (2 * static_cast<std::uint64_t>(this->Current.Replicate) + axis + 1) * 0x9e3779b97f4a7c15u;
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u; // splitmix64 (G. Steele et al. 2014)
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
    return static_cast<double>((bits ^ (bits >> 31)) >> 11) * 0x1p-53;
  };
  const auto place = brdf::r2(static_cast<std::size_t>(this->FrameInReplicate), shift(0), shift(1));
  this->Current.Offset[0] = place[0] - 0.5;
  this->Current.Offset[1] = place[1] - 0.5;
}

bool vtkBRDFConvergence::Add(const std::vector<float>& rgba)
{
  Frame& frame = this->Current;
  this->Picture.add(static_cast<std::size_t>(frame.Replicate), rgba, static_cast<std::size_t>(frame.Count));
  if (++frame.Replicate == Replicates)
  {
    frame.Replicate = 0;
    frame.First += frame.Count;
    ++this->FrameInReplicate;
    if (frame.First == this->RoundEnd)
    {
      ++this->Rounds;
      this->Error = this->Picture.relativeError();
      if (this->Converged() || frame.First == this->Maximum)
      {
        return false;
      }
      this->RoundEnd = std::min(2 * this->RoundEnd, this->Maximum);
    }
  }
  frame.Count = std::min(this->LongestFrame, this->RoundEnd - frame.First);
  this->Place();
  return true;
}
