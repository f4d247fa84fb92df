/*
 * What the compiled functions of a module need when they run: numba's helper functions, and the
 * creation of the module from the tables of `aot.py`.
 */

#include "_numba_common.h"
#include "_pymodule.h"

/* Functions of the files below are not visible to other modules. */
#define NUMBA_EXPORT_FUNC(kind) VISIBILITY_HIDDEN kind
#define NUMBA_EXPORT_DATA(kind) VISIBILITY_HIDDEN kind
#define PYCC_COMPILING /* pickled objects are read by pickle, not by numba */

#include "_helperlib.c"
#include "_dynfunc.c"
#include "core/runtime/_nrt_python.c"
#include "core/runtime/nrt.h"

/* Pickled constants, as written by numba's PythonAPI.serialize_uncached. */
typedef struct {
    const char *data;
    int length;
    const char *hash;
    const char *unused;
    int also_unused;
} Pickled;

/* Written by `aot.py`: the functions, then the pickled constants of each and of functions that
 * these call, and where the constants are to be stored. Each ends with zeros. */
extern PyMethodDef kernel_methods[];
extern Pickled kernel_constants[];
extern void **kernel_places[];

static EnvironmentObject *unpickled(PyObject *module, const Pickled *pickled) {
    PyObject *constants = numba_unpickle(pickled->data, pickled->length, pickled->hash);
    if (!constants) return NULL;
    EnvironmentObject *made = PyList_Check(constants) ? env_new_empty(&EnvironmentType) : NULL;
    if (!made) {
        if (!PyErr_Occurred()) PyErr_SetString(PyExc_TypeError, "constants of a kernel are no list");
        Py_DECREF(constants);
        return NULL;
    }
    made->consts = constants;
    made->globals = PyModule_GetDict(module);
    Py_INCREF(made->globals);
    return made;
}

static int add_function(PyObject *module, PyMethodDef *method, EnvironmentObject *environment) {
    PyObject *name = PyUnicode_FromString(method->ml_name), *doc = PyUnicode_FromString("");
    PyObject *made = NULL;
    if (name && doc)
        made = pycfunction_new(module, name, doc, method->ml_meth, environment, NULL);
    int failed = !made || PyObject_SetAttr(module, name, made);
    Py_XDECREF(made);
    Py_XDECREF(name);
    Py_XDECREF(doc);
    return failed ? -1 : 0;
}

static int add_functions(PyObject *module) {
    PyMethodDef *method = kernel_methods;
    for (int i = 0; kernel_places[i]; i++) {
        EnvironmentObject *environment = unpickled(module, &kernel_constants[i]);
        if (!environment) return -1;
        *kernel_places[i] = environment; /* kept for as long as the process runs */
        if (!method->ml_name) continue;
        if (add_function(module, method++, environment)) return -1;
    }
    return 0;
}

static int init_numpy(void) {
    import_array1(-1);
    return 0;
}

VISIBILITY_HIDDEN PyObject *create_kernels(PyModuleDef *definition) {
    PyObject *module = PyModule_Create(definition);
    if (!module) return NULL;
    NRT_MemSys_init();
    numba_rnd_ensure_global_init();
    if (init_numpy() || init_dynfunc_module(module) || init_nrt_python_module(module) ||
        add_functions(module)) {
        Py_DECREF(module);
        return NULL;
    }
    return module;
}
