// The compiled part of the package spiraling_edge.
#include "bindings.h"
#include "calls.h"

PYBIND11_MODULE(_core, module) {
    using namespace se::python;
    py::register_exception<InputError>(module, "InputError", PyExc_ValueError);
    py::register_exception<Cancelled>(module, "Cancelled", PyExc_RuntimeError);
    module.attr("__version__") = SPIRALING_EDGE_VERSION;
    bindEvents(module);
    bindMeshes(module);
    bindStepping(module);
}
