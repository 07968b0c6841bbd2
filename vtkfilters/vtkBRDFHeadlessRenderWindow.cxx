#include "vtkBRDFHeadlessRenderWindow.h"

#include "vtkBRDFCompatibility.h"
#include VTK_BRDF_GL_LOADER_HEADER

#include "vtkAutoInit.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLState.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

// Whoever links this library has OpenGL renderers and text, without a word in its own build.
VTK_MODULE_INIT(vtkRenderingOpenGL2);
VTK_MODULE_INIT(vtkRenderingFreeType);
VTK_MODULE_INIT(vtkRenderingContextOpenGL2);
VTK_MODULE_INIT(vtkRenderingVolumeOpenGL2);

namespace
{
// A display that gives OpenGL contexts. One for the process: terminating it would end every window's context.
struct Display
{
  EGLDisplay Handle = EGL_NO_DISPLAY;
  EGLConfig Config = nullptr;
  std::string Platform;
};

bool Has(const char* extensions, const char* name)
{
  return extensions && std::strstr(extensions, name);
}

EGLContext CreateContext(const Display& display)
{
  const std::array<EGLint, 7> attributes = {
    EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 2, EGL_CONTEXT_OPENGL_PROFILE_MASK,
    EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE
  };
  eglBindAPI(EGL_OPENGL_API);
  return eglCreateContext(display.Handle, display.Config, EGL_NO_CONTEXT, attributes.data());
}

// Whether a context can be made and be current without a surface.
bool Works(const Display& display)
{
  EGLContext context = CreateContext(display);
  if (context == EGL_NO_CONTEXT)
  {
    return false;
  }
  const bool current = eglMakeCurrent(display.Handle, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
  eglMakeCurrent(display.Handle, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display.Handle, context);
  return current;
}

bool Open(Display& display, EGLenum platform, void* device, const char* name)
{
  const auto getPlatformDisplay =
    reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  Display candidate;
  candidate.Platform = name;
  candidate.Handle = getPlatformDisplay ? getPlatformDisplay(platform, device, nullptr) : EGL_NO_DISPLAY;
  if (candidate.Handle == EGL_NO_DISPLAY || !eglInitialize(candidate.Handle, nullptr, nullptr))
  {
    return false;
  }
  const std::array<EGLint, 5> attributes = {
    EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE
  };
  EGLint count = 0;
  if (!eglChooseConfig(candidate.Handle, attributes.data(), &candidate.Config, 1, &count) || count == 0)
  {
    candidate.Config = EGL_NO_CONFIG_KHR;
  }
  if (!Works(candidate))
  {
    return false;
  }
  display = candidate;
  return true;
}

// The devices of the machine, hardware or software only.
bool OpenDevice(Display& display, bool software)
{
  const auto queryDevices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
  const auto queryDeviceString =
    reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(eglGetProcAddress("eglQueryDeviceStringEXT"));
  std::array<EGLDeviceEXT, 32> devices{};
  EGLint count = 0;
  if (!queryDevices || !queryDeviceString || !queryDevices(static_cast<EGLint>(devices.size()), devices.data(), &count))
  {
    return false;
  }
  for (EGLint i = 0; i < count; ++i)
  {
    const char* extensions = queryDeviceString(devices[i], EGL_EXTENSIONS);
    if (Has(extensions, "EGL_MESA_device_software") == software &&
        Open(display, EGL_PLATFORM_DEVICE_EXT, devices[i], software ? "EGL software device" : "EGL device"))
    {
      return true;
    }
  }
  return false;
}

Display FindDisplay()
{
  Display display;
  const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  const bool devices = Has(extensions, "EGL_EXT_device_enumeration") || Has(extensions, "EGL_EXT_device_base");
  const bool surfaceless = Has(extensions, "EGL_MESA_platform_surfaceless");
  (devices && OpenDevice(display, false)) ||
    (surfaceless && Open(display, EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, "EGL surfaceless")) ||
    (devices && OpenDevice(display, true));
  return display;
}

const Display& SharedDisplay()
{
  static const Display display = FindDisplay();
  return display;
}
}

class vtkBRDFHeadlessRenderWindow::Context
{
public:
  Context()
    : Handle(SharedDisplay().Handle == EGL_NO_DISPLAY ? EGL_NO_CONTEXT : CreateContext(SharedDisplay()))
  {
  }
  ~Context()
  {
    if (this->Handle != EGL_NO_CONTEXT)
    {
      if (this->IsCurrent())
      {
        eglMakeCurrent(SharedDisplay().Handle, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
      }
      eglDestroyContext(SharedDisplay().Handle, this->Handle);
    }
  }
  bool IsValid() const { return this->Handle != EGL_NO_CONTEXT; }
  bool IsCurrent() const { return this->IsValid() && eglGetCurrentContext() == this->Handle; }
  bool MakeCurrent()
  {
    return this->IsValid() && eglMakeCurrent(SharedDisplay().Handle, EGL_NO_SURFACE, EGL_NO_SURFACE, this->Handle);
  }
  // Remembers what is current, whoever made it.
  void Push()
  {
    this->Pushed.push_back({ eglGetCurrentDisplay(),
                             eglGetCurrentSurface(EGL_DRAW),
                             eglGetCurrentSurface(EGL_READ),
                             eglGetCurrentContext() });
  }
  // Makes that current again.
  bool Pop()
  {
    if (this->Pushed.empty())
    {
      return true;
    }
    const Binding last = this->Pushed.back();
    this->Pushed.pop_back();
    return last.Handle == eglGetCurrentContext() ||
           eglMakeCurrent(
             last.Handle == EGL_NO_CONTEXT ? SharedDisplay().Handle : last.Display, last.Draw, last.Read, last.Handle);
  }

private:
  struct Binding
  {
    EGLDisplay Display;
    EGLSurface Draw, Read;
    EGLContext Handle;
  };

  EGLContext Handle;
  std::vector<Binding> Pushed;
};

vtkStandardNewMacro(vtkBRDFHeadlessRenderWindow);

vtkBRDFHeadlessRenderWindow::vtkBRDFHeadlessRenderWindow()
  : Egl(std::make_unique<Context>())
{
  if (!this->Egl->MakeCurrent())
  {
    this->Egl.reset();
    this->ErrorText =
      "no EGL: no headless OpenGL 3.2 context on a device or Mesa's surfaceless platform (Debian package "
      "libgl1-mesa-dri has a software one)";
    this->ReadyForRendering = false;
    return;
  }
  this->SetOffScreenRendering(1);
  this->SetShowWindow(false);
  this->SetUseOffScreenBuffers(true);
  this->SetFrameBlitModeToNoBlit();
  this->SetMultiSamples(0);
  this->SetReadyForRendering(true);
}

vtkBRDFHeadlessRenderWindow::~vtkBRDFHeadlessRenderWindow()
{
  if (this->Egl)
  {
    this->MakeCurrent();
    this->Finalize();
    if (this->Initialized)
    {
      this->ReleaseGraphicsResources(this);
    }
    this->Initialized = false;
  }
}

bool vtkBRDFHeadlessRenderWindow::IsAvailable() const
{
  return this->Egl != nullptr;
}

void vtkBRDFHeadlessRenderWindow::Initialize()
{
  if (this->Egl && !this->Initialized)
  {
    this->MakeCurrent();
    this->OpenGLInit();
  }
}

void vtkBRDFHeadlessRenderWindow::OpenGLInitContext()
{
  this->ContextCreationTime.Modified();
  if (this->Initialized || !this->Egl)
  {
    return;
  }
#ifdef VTK_BRDF_USES_GLEW
  // A GLEW built for GLX loads every function and then complains that there is no GLX display: 4.
  const GLenum result = glewInit();
  this->GlewInitValid = result == GLEW_OK || result == 4;
#else
  this->GlewInitValid = gladLoaderLoadGL() != 0;
#endif
  this->Initialized = this->GlewInitValid;
}

void vtkBRDFHeadlessRenderWindow::Render()
{
  if (!this->Egl)
  {
    vtkErrorMacro(<< this->ErrorText);
    return;
  }
  this->Initialize();
  this->Superclass::Render();
}

void vtkBRDFHeadlessRenderWindow::MakeCurrent()
{
  if (this->Egl && !this->Egl->IsCurrent() && !this->Egl->MakeCurrent())
  {
    vtkErrorMacro("cannot make the EGL context current (EGL error " << eglGetError() << ")");
  }
}

bool vtkBRDFHeadlessRenderWindow::IsCurrent()
{
  return this->Egl && this->Egl->IsCurrent();
}

void vtkBRDFHeadlessRenderWindow::PushContext()
{
  if (this->Egl)
  {
    this->Egl->Push();
    this->MakeCurrent();
  }
}

void vtkBRDFHeadlessRenderWindow::PopContext()
{
  if (this->Egl && !this->Egl->Pop())
  {
    vtkErrorMacro("cannot make the last EGL context current again (EGL error " << eglGetError() << ")");
  }
}

std::string vtkBRDFHeadlessRenderWindow::GetDeviceDescription()
{
  if (!this->Egl)
  {
    return this->ErrorText;
  }
  this->Initialize();
  this->MakeCurrent();
  const auto text = [](GLenum name)
  {
    const auto* value = reinterpret_cast<const char*>(glGetString(name));
    return std::string(value ? value : "?");
  };
  return SharedDisplay().Platform + ", " + text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
}

const char* vtkBRDFHeadlessRenderWindow::ReportCapabilities()
{
  return this->Egl ? this->Superclass::ReportCapabilities() : this->ErrorText.c_str();
}

int vtkBRDFHeadlessRenderWindow::GetColorBufferSizes(int* rgba)
{
  std::fill_n(rgba, 4, 8);
  return 4 * 8;
}

void vtkBRDFHeadlessRenderWindow::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Available: " << this->IsAvailable() << "\n" << indent << "ErrorText: " << this->ErrorText << "\n";
}
