// Debian's VTK loads OpenGL functions by GLEW, and GLEW by GLX, i.e. from an X server. These three functions override
// theirs and load OSMesa's OpenGL, which draws into main memory.

#define _GNU_SOURCE
#include <GL/osmesa.h>
#include <dlfcn.h>
#include <string.h>

typedef void (*Function)(void);
typedef Function (*Lookup)(const unsigned char*);

// ISO C has no conversion from object to function pointers; POSIX guarantees equal representation.
static void next_function(const char* name, void* function) {
  void* found = dlsym(RTLD_NEXT, name);
  memcpy(function, &found, sizeof found);
}

static Function look_up(const unsigned char* name, const char* lookup) {
  if (strncmp((const char*)name, "glX", 3) != 0) return OSMesaGetProcAddress((const char*)name);
  Lookup next = 0;
  next_function(lookup, &next);
  return next ? next(name) : 0;
}

Function glXGetProcAddressARB(const unsigned char* name) {
  return look_up(name, "glXGetProcAddressARB");
}
Function glXGetProcAddress(const unsigned char* name) {
  return look_up(name, "glXGetProcAddress");
}

// GLEW has loaded OpenGL when it reports a missing GLX display (error 4), which is not needed.
unsigned int glewInit(void) {
  enum { no_error = 0, unknown_error = 1, no_glx_display = 4 };
  unsigned int (*next)(void) = 0;
  next_function("glewInit", &next);
  const unsigned int error = next ? next() : unknown_error;
  return error == no_glx_display ? no_error : error;
}
