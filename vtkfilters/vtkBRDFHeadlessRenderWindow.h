#ifndef vtkBRDFHeadlessRenderWindow_h
#define vtkBRDFHeadlessRenderWindow_h
#include "vtkBRDFFiltersModule.h" // For export macro
#include "vtkGenericOpenGLRenderWindow.h"

#include <memory> // For std::unique_ptr
#include <string> // For std::string

/**
 * @class vtkBRDFHeadlessRenderWindow
 * @brief A render window without a window system
 *
 * Draws into an off-screen framebuffer of its own EGL context (OpenGL 3.2 core or later) without a surface: no X
 * server, no DISPLAY. A hardware device is taken first, then Mesa's surfaceless platform, then its software device; set
 * LIBGL_ALWAYS_SOFTWARE=1 for software everywhere. Any number of these windows may live in a process; they may be
 * resized and destroyed in any order, and share props. One thread at a time.
 *
 * New() never fails: where there is no EGL, IsAvailable() is false, GetErrorText() says why, Render() is an error and
 * draws nothing.
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFHeadlessRenderWindow : public vtkGenericOpenGLRenderWindow
{
public:
  static vtkBRDFHeadlessRenderWindow* New();
  vtkTypeMacro(vtkBRDFHeadlessRenderWindow, vtkGenericOpenGLRenderWindow);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Whether there is a context to draw with. */
  bool IsAvailable() const;

  /** Why there is none, in one line; empty when there is one. */
  std::string GetErrorText() const { return this->ErrorText; }

  /** Which platform gave the context, and OpenGL's own name and version, in one line. */
  std::string GetDeviceDescription();

  void Initialize() override;
  void Render() override;
  void MakeCurrent() override;
  bool IsCurrent() override;
  ///@{
  /** Makes this window's context current, and what was current before again: VTK frees what a prop has in one window
   * while another draws it. */
  void PushContext() override;
  void PopContext() override;
  ///@}
  int SupportsOpenGL() override { return this->IsAvailable(); }
  vtkTypeBool IsDirect() override { return this->IsAvailable(); }
  const char* ReportCapabilities() override;
  /** Red, green, blue and alpha bits of what VTK draws into, 8 each: without a surface there is no framebuffer to ask.
   */
  int GetColorBufferSizes(int* rgba) override;

protected:
  vtkBRDFHeadlessRenderWindow();
  ~vtkBRDFHeadlessRenderWindow() override;
  void OpenGLInitContext() override;

private:
  vtkBRDFHeadlessRenderWindow(const vtkBRDFHeadlessRenderWindow&) = delete;
  void operator=(const vtkBRDFHeadlessRenderWindow&) = delete;

  class Context;
  std::unique_ptr<Context> Egl;
  std::string ErrorText;
};
#endif
