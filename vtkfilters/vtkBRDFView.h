#ifndef vtkBRDFView_h
#define vtkBRDFView_h
#include "vtkBRDFFiltersModule.h" // For export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <functional> // For std::function
#include <string>     // For std::string

class vtkImageData;
class vtkRenderer;
class vtkRenderWindow;

/**
 * @class vtkBRDFView
 * @brief Base of the views: one picture of BRDFs with title, units and legend
 *
 * Fills a renderer of its own in a render window: one given by SetRenderWindow (an application's), else a headless one
 * of its own. Every Render() builds the picture anew from the present inputs and the window's size, so that all users
 * of a view, C++, Python and the command line, get the same picture.
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFView : public vtkObject
{
public:
  vtkTypeMacro(vtkBRDFView, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The window that is drawn into; by default a headless one of 900 x 700 pixels, made when first asked for. */
  void SetRenderWindow(vtkRenderWindow* window);
  vtkRenderWindow* GetRenderWindow();
  ///@}

  /** The renderer that the picture is built in. */
  vtkRenderer* GetRenderer();

  /** Size of the window in pixels, 64 to 8192 each. */
  void SetSize(int width, int height);

  ///@{
  /** First line of the picture. Empty (default): the view writes its own. */
  vtkSetMacro(Title, std::string);
  vtkGetMacro(Title, std::string);
  ///@}

  /** Draws the picture. False, with GetErrorText, when it cannot be made. */
  bool Render();

  /** Draws, and copies the picture into `image`: RGB, 8 bits, sRGB, first row at the bottom. */
  bool Capture(vtkImageData* image);

  /** Draws and writes a PNG file, which is replaced only when it is complete. */
  bool WritePNG(const std::string& fileName);

  /** Draws and writes text and lines as text and lines, not pixels, at the window's size in points: by the file's name
   * SVG or PDF. The file is replaced only when complete. Refused where the picture holds three-dimensional objects. */
  bool WriteVectors(const std::string& fileName);

  /** Why the last picture failed, in one line; empty when it succeeded. */
  std::string GetErrorText() const { return this->ErrorText; }

protected:
  vtkBRDFView();
  ~vtkBRDFView() override;

  /** Adds all props for a picture of this size to the empty renderer. Throws std::exception for every failure. */
  virtual void Build(int width, int height) = 0;

  /** Throws brdf::Error with an algorithm's reason when its last update failed. */
  static void UpdateOrThrow(class vtkBRDFAlgorithm* algorithm);

  /** Runs an action that may throw; true when it did not, else GetErrorText() says why. */
  bool Guarded(const std::function<void()>& action);

  /** Pixels of ordinary text in a picture of this size. */
  static int TextSize(int width, int height);
  /** The same for views that hold much: larger pictures get more in, not larger letters. */
  static int SmallTextSize(int width, int height);

private:
  vtkBRDFView(const vtkBRDFView&) = delete;
  void operator=(const vtkBRDFView&) = delete;

  void DrawOrThrow();
  void CaptureOrThrow(vtkImageData* image);
  void WriteVectorsOrThrow(const std::string& fileName);

  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderWindow> Window;
  std::string Title;
  std::string ErrorText;
};
#endif
