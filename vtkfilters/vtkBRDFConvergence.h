#ifndef vtkBRDFConvergence_h
#define vtkBRDFConvergence_h
#include <brdf/render/ReplicateFilm.h>

#include <vector>

// Which frames make a converging picture, and when they are enough. Knows no OpenGL.
//
// A round brings every replicate to the same number of points, twice as many as the round before, in frames of a few
// points each. Every frame sees its pixels at another place: points of the R2 sequence over the pixel, shifted by a
// random amount that differs by replicate, so that the replicates stay independent in what their edges show, too.
class vtkBRDFConvergence
{
public:
  static constexpr int Replicates = static_cast<int>(brdf::ReplicateFilm::kReplicates);

  struct Frame
  {
    int Replicate = 0;
    int First = 0; // point of the replicate
    int Count = 0;
    double Offset[2] = { 0, 0 }; // of the place in the pixel from its centre, pixels
  };

  // `maximum`: points a pixel at most, rounded up to a multiple of Replicates. `tolerance`: see
  // brdf::ReplicateFilm::relativeError; 0 draws all. Without `spread` all frames see the pixels' centres.
  vtkBRDFConvergence(int width, int height, int maximum, double tolerance, bool spread);

  // What is to be drawn next.
  const Frame& Next() const { return this->Current; }
  // Takes the frame; false when all is done: the tolerance is reached or the maximum drawn.
  bool Add(const std::vector<float>& rgba);

  // Whether there is something to keep: every replicate has points.
  bool HasPicture() const { return this->Rounds > 0; }

  const brdf::ReplicateFilm& Film() const { return this->Picture; }
  double RelativeError() const { return this->Error; } // at the end of the last round
  bool Converged() const { return this->Tolerance > 0 && this->Error <= this->Tolerance; }

private:
  void Place();

  static constexpr int RoundStart = 2; // points of a replicate in the first round

  brdf::ReplicateFilm Picture;
  int Maximum; // points of a replicate
  double Tolerance;
  bool Spread;
  int LongestFrame; // points
  int RoundEnd;
  int Rounds = 0; // done
  int FrameInReplicate = 0;
  Frame Current;
  double Error;
};
#endif
