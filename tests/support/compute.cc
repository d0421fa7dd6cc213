// SPDX-License-Identifier: MIT
#include "tests/support/compute.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES3/gl31.h>

#include <cstdlib>
#include <cstring>

namespace gaunt::test {
namespace {

// The message of a shader or a program, by the two functions that get it.
template <class GetNumber, class GetLog>
std::string Log(GLuint object, GetNumber get_number, GetLog get_log) {
  GLint length = 0;
  get_number(object, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<size_t>(length) + 1, '\0');
  get_log(object, static_cast<GLsizei>(log.size()), nullptr, log.data());
  return log.c_str();  // up to the first null
}

std::string Build(GLuint program, const std::string& source) {
  const GLuint shader = glCreateShader(GL_COMPUTE_SHADER);
  const char* text = source.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint ok = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  std::string error;
  if (ok != GL_TRUE) {
    error = "compile: " + Log(shader, glGetShaderiv, glGetShaderInfoLog);
  } else {
    glAttachShader(program, shader);
    glLinkProgram(program);
    glGetProgramiv(program, GL_LINK_STATUS, &ok);
    if (ok != GL_TRUE) error = "link: " + Log(program, glGetProgramiv, glGetProgramInfoLog);
  }
  glDeleteShader(shader);
  return error;
}

}  // namespace

std::unique_ptr<Compute> Compute::Open(std::string* reason) {
  // Mesa's own renderer, whatever hardware there is: the same results everywhere.
  setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
  std::unique_ptr<Compute> compute(new Compute);
  const auto get_display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
      eglGetProcAddress("eglGetPlatformDisplayEXT"));
  if (get_display == nullptr) {
    *reason = "EGL has no platforms";
    return nullptr;
  }
  const EGLDisplay display =
      get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) {
    *reason = "EGL has no display without a window";
    return nullptr;
  }
  compute->display_ = display;
  constexpr EGLint kVersion[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 1,
                                 EGL_NONE};
  eglBindAPI(EGL_OPENGL_ES_API);
  compute->context_ = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, kVersion);
  if (compute->context_ == EGL_NO_CONTEXT ||
      !eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, compute->context_)) {
    *reason = "EGL has no context of OpenGL ES 3.1 without a surface";
    return nullptr;
  }
  compute->renderer_ = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  return compute;
}

Compute::~Compute() {
  if (display_ == nullptr) return;
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  if (context_ != nullptr) eglDestroyContext(display_, context_);
  // The display is the process's, not ours; and Mesa leaks when it unloads its driver with it.
}

std::string Compute::Run(const std::string& source, size_t groups, const void* in, size_t in_bytes,
                         void* out, size_t out_bytes) const {
  const GLuint program = glCreateProgram();
  std::string error = Build(program, source);
  if (error.empty()) {
    GLuint buffers[2];
    glGenBuffers(2, buffers);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, buffers[0]);
    glBufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(in_bytes), in, GL_STATIC_DRAW);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, buffers[1]);
    // What the shader does not write stays as it was.
    glBufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(out_bytes), out,
                 GL_DYNAMIC_READ);
    glUseProgram(program);
    glDispatchCompute(static_cast<GLuint>(groups), 1, 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    const void* result = glMapBufferRange(GL_SHADER_STORAGE_BUFFER, 0,
                                          static_cast<GLsizeiptr>(out_bytes), GL_MAP_READ_BIT);
    if (result != nullptr) {
      std::memcpy(out, result, out_bytes);
      glUnmapBuffer(GL_SHADER_STORAGE_BUFFER);
    }
    if (glGetError() != GL_NO_ERROR || result == nullptr) error = "OpenGL ES: the run failed";
    glDeleteBuffers(2, buffers);
  }
  glDeleteProgram(program);
  return error;
}

}  // namespace gaunt::test
