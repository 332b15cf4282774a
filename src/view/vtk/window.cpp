#include "view/vtk/parts.hpp"

#include "base/error.hpp"

#include <vtkSmartPointer.h>

#ifdef SIGNORINI_VTK_HAS_OSMESA
#include <vtkOSOpenGLRenderWindow.h>
#else
#include <GL/osmesa.h>
#include <vtkGenericOpenGLRenderWindow.h>
#endif

namespace signorini::view {
namespace {

#ifdef SIGNORINI_VTK_HAS_OSMESA

vtkSmartPointer<vtkRenderWindow> make_window() {
  return vtkSmartPointer<vtkOSOpenGLRenderWindow>::New();
}

#else

/// One OSMesa context serves all windows; it and its buffer exist until the program ends. The buffer can be small,
/// because VTK draws into its own framebuffers.
void make_current() {
  static const int wanted[] = {OSMESA_FORMAT,
                               OSMESA_RGBA,
                               OSMESA_DEPTH_BITS,
                               24,
                               OSMESA_STENCIL_BITS,
                               8,
                               OSMESA_PROFILE,
                               OSMESA_CORE_PROFILE,
                               OSMESA_CONTEXT_MAJOR_VERSION,
                               3,
                               OSMESA_CONTEXT_MINOR_VERSION,
                               3,
                               0};
  static const OSMesaContext context = OSMesaCreateContextAttribs(wanted, nullptr);
  static unsigned char buffer[4 * 16 * 16];
  require(context != nullptr && OSMesaMakeCurrent(context, buffer, GL_UNSIGNED_BYTE, 16, 16) == GL_TRUE,
          "view.opengl.context");
}

vtkSmartPointer<vtkRenderWindow> make_window() {
  make_current();
  auto window = vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New();
  window->SetIsCurrent(true);
  window->SetReadyForRendering(true);
  window->SetOwnContext(0);
  window->SetMapped(0);
  window->InitializeFromCurrentContext();
  return window;
}

#endif

} // namespace

vtkRenderWindow& offscreen_window() {
  // Never destroyed: the order of destruction of Mesa and VTK at program end is undefined.
  static vtkRenderWindow* const window = [] {
    auto made = make_window();
    made->SetOffScreenRendering(1);
    made->SetAlphaBitPlanes(1);
    made->SetMultiSamples(0);
    made->SetSize(tile_size, tile_size);
    made->Register(nullptr);
    return made.Get();
  }();
  return *window;
}

} // namespace signorini::view
