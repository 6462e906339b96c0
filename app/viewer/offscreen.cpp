#include "offscreen.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include "render/context.h"

namespace se::view {

namespace {

EGLDisplay surfacelessDisplay() {
    const auto getDisplay = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
        eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (getDisplay == nullptr) return EGL_NO_DISPLAY;
    EGLDisplay display = getDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) == EGL_TRUE) {
        return display;
    }
    // Drivers without the extension above: the first device.
    const auto queryDevices =
        reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    EGLDeviceEXT device = nullptr;
    EGLint count = 0;
    if (queryDevices == nullptr || queryDevices(1, &device, &count) != EGL_TRUE || count == 0) {
        return EGL_NO_DISPLAY;
    }
    display = getDisplay(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
    const bool good =
        display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) == EGL_TRUE;
    return good ? display : EGL_NO_DISPLAY;
}

}  // namespace

Result<std::unique_ptr<Offscreen>> Offscreen::create(glm::ivec2 size) {
    std::unique_ptr<Offscreen> made(new Offscreen);
    made->size_ = size;
    if (const Status status = made->makeContext(); !status) return status.error();
    made->target_ = std::make_unique<Target>(0);
    return made;
}

Status Offscreen::makeContext() {
    const Error none{
        "A picture without a display needs EGL with OpenGL 3.3; on Debian install "
        "libegl1 and libgl1-mesa-dri."};
    display_ = surfacelessDisplay();
    if (display_ == EGL_NO_DISPLAY || eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) return none;
    const EGLint wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglChooseConfig(display_, wanted, &config, 1, &count) != EGL_TRUE || count == 0)
        return none;
    const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION,
                              3,
                              EGL_CONTEXT_MINOR_VERSION,
                              3,
                              EGL_CONTEXT_OPENGL_PROFILE_MASK,
                              EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                              EGL_NONE};
    context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, version);
    if (context_ == EGL_NO_CONTEXT ||
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) != EGL_TRUE) {
        return none;
    }
    return loadGl(eglGetProcAddress);
}

Offscreen::~Offscreen() {
    target_.reset();
    if (display_ == EGL_NO_DISPLAY) return;
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display_, context_);
    eglTerminate(display_);
}

Picture Offscreen::read() const { return readPicture(size_); }

}  // namespace se::view
