/* The init function of one module of compiled functions; MODULE is its name. */

#include <Python.h>

#define PASTED(name) PyInit_##name
#define INIT(name) PASTED(name)
#define QUOTED(name) #name
#define TEXT(name) QUOTED(name)

PyObject *create_kernels(PyModuleDef *definition); /* runtime.c */

static PyModuleDef definition = {PyModuleDef_HEAD_INIT, TEXT(MODULE), NULL, -1};

PyMODINIT_FUNC INIT(MODULE)(void) {
    return create_kernels(&definition);
}
