/* Kernel: a callable that picks the compiled function for the types of its arguments.
 *
 * Compiled functions take what they are given for what they were compiled for, so each argument is
 * looked at first: its kind, size, dimensions and order (the words of kinds.py). This is done in C
 * because a second of tracking makes some ten thousand such calls.
 */
#define PY_SSIZE_T_CLEAN
#define NPY_NO_DEPRECATED_API NPY_1_7_API_VERSION
#include <Python.h>
#include <numpy/arrayobject.h>
#include <numpy/arrayscalars.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

enum form { NUMBER, ARRAY, TUPLE, NONE };

typedef struct kind {
    enum form form;
    char letter;         /* numpy's kind of a number: b i u f c */
    int size;            /* bytes of a number */
    int dimensions;      /* of an array */
    char order;          /* C, F or A */
    int read_only;       /* whether an array that may not be written to will do */
    Py_ssize_t count;    /* members of a tuple */
    struct kind *members;
    char name[64];       /* a named tuple's class, without its module; empty for a plain one */
} Kind;

typedef struct {
    Kind arguments;      /* all of them, as a tuple */
    PyObject *compiled;
} Overload;

typedef struct {
    PyObject_HEAD
    vectorcallfunc vectorcall;
    PyObject *dict;
    PyObject *helper;    /* miss(kernel, args, kwargs) and numba_type(kernel) */
    Py_ssize_t count;
    Overload *overloads;
} Kernel;

/* --- reading the words */

static void free_kind(Kind *kind) {
    for (Py_ssize_t i = 0; i < kind->count; i++) free_kind(&kind->members[i]);
    free(kind->members);
    kind->members = NULL;
    kind->count = 0;
}

static const char *read_kind(const char *at, Kind *kind);

static const char *read_members(const char *at, char end, char between, Kind *kind) {
    kind->form = TUPLE;
    while (at && *at && *at != end) {
        Kind *more = realloc(kind->members, (kind->count + 1) * sizeof(Kind));
        if (!more) return NULL;
        kind->members = more;
        memset(&kind->members[kind->count], 0, sizeof(Kind));
        at = read_kind(at, &kind->members[kind->count++]);
        if (at && *at == between) at++;
    }
    return at && *at == end ? at : NULL;
}

static const char *read_array(const char *at, Kind *kind) {
    char *after;
    kind->form = ARRAY;
    kind->dimensions = (int)strtol(at, &after, 10);
    if (after == at || !strchr("CFA", *after) || !*after) return NULL;
    kind->order = *after++;
    kind->read_only = *after == 'r';
    if (kind->read_only) after++;
    return *after == ']' ? after + 1 : NULL;
}

/* A tuple's word begins with the name of its class, or with its bracket. */
static int is_tuple_word(const char *at) {
    return at[strspn(at, "._0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ")] == '(';
}

static const char *read_tuple(const char *at, Kind *kind) {
    const char *open = strchr(at, '('), *name = open;
    while (name > at && name[-1] != '.') name--;
    if ((size_t)(open - name) >= sizeof(kind->name)) return NULL;
    memcpy(kind->name, name, open - name); /* what follows are zeros */
    const char *end = read_members(open + 1, ')', ',', kind);
    return end ? end + 1 : NULL;
}

/* One word from `at` on; where it ends, or NULL. */
static const char *read_kind(const char *at, Kind *kind) {
    if (is_tuple_word(at)) return read_tuple(at, kind);
    if (strncmp(at, "none", 4) == 0) {
        kind->form = NONE;
        return at + 4;
    }
    char *after;
    if (!*at || !strchr("biufc", *at)) return NULL;
    kind->letter = at[0];
    kind->size = (int)strtol(at + 1, &after, 10);
    if (kind->size < 1 || kind->size > 16 || kind->size & (kind->size - 1)) return NULL;
    return *after == '[' ? read_array(after + 1, kind) : after;
}

/* --- looking at values */

static int is_numpy_number(const Kind *kind, PyObject *value) {
    if (!PyArray_CheckScalar(value) || PyArray_Check(value)) return 0;
    PyArray_Descr *type = PyArray_DescrFromScalar(value);
    if (!type) {
        PyErr_Clear();
        return 0;
    }
    int fits = type->kind == kind->letter && PyDataType_ELSIZE(type) == kind->size;
    Py_DECREF(type);
    return fits;
}

static int is_number(const Kind *kind, PyObject *value) {
    if (PyFloat_Check(value)) return kind->letter == 'f' && kind->size == 8;
    if (PyBool_Check(value)) return kind->letter == 'b';
    if (PyComplex_Check(value)) return kind->letter == 'c' && kind->size == 16;
    if (PyLong_Check(value)) {
        int overflow = 0;
        if (kind->letter != 'i' || kind->size != 8) return 0;
        PyLong_AsLongLongAndOverflow(value, &overflow);
        return !overflow;
    }
    return is_numpy_number(kind, value);
}

static int is_array(const Kind *kind, PyObject *value) {
    if (!PyArray_CheckExact(value)) return 0;
    PyArrayObject *array = (PyArrayObject *)value;
    if (PyArray_NDIM(array) != kind->dimensions) return 0;
    PyArray_Descr *type = PyArray_DESCR(array);
    if (type->kind != kind->letter || PyDataType_ELSIZE(type) != kind->size) return 0;
    if (!PyArray_ISBEHAVED_RO(array)) return 0;
    if (!kind->read_only && !PyArray_ISWRITEABLE(array)) return 0;
    if (kind->order == 'C') return PyArray_IS_C_CONTIGUOUS(array);
    if (kind->order == 'F') return PyArray_IS_F_CONTIGUOUS(array);
    return 1;
}

static int fits(const Kind *kind, PyObject *value) {
    switch (kind->form) {
    case NUMBER: return is_number(kind, value);
    case ARRAY: return is_array(kind, value);
    case NONE: return value == Py_None;
    default: break;
    }
    if (kind->name[0] ? !PyTuple_Check(value) || strcmp(Py_TYPE(value)->tp_name, kind->name) != 0
                      : !PyTuple_CheckExact(value))
        return 0;
    if (PyTuple_GET_SIZE(value) != kind->count) return 0;
    for (Py_ssize_t i = 0; i < kind->count; i++)
        if (!fits(&kind->members[i], PyTuple_GET_ITEM(value, i))) return 0;
    return 1;
}

static PyObject *find(Kernel *self, PyObject *const *args, Py_ssize_t n) {
    for (Py_ssize_t k = 0; k < self->count; k++) {
        const Kind *wanted = &self->overloads[k].arguments;
        if (wanted->count != n) continue;
        Py_ssize_t i = 0;
        while (i < n && fits(&wanted->members[i], args[i])) i++;
        if (i == n) return self->overloads[k].compiled;
    }
    return NULL;
}

/* --- the type */

static PyObject *packed(PyObject *const *args, Py_ssize_t n) {
    PyObject *tuple = PyTuple_New(n);
    for (Py_ssize_t i = 0; tuple && i < n; i++) {
        Py_INCREF(args[i]);
        PyTuple_SET_ITEM(tuple, i, args[i]);
    }
    return tuple;
}

static PyObject *miss(Kernel *self, PyObject *args, PyObject *const *named, PyObject *names) {
    PyObject *by_name = PyDict_New(), *result = NULL;
    if (!by_name) return NULL;
    for (Py_ssize_t i = 0; names && i < PyTuple_GET_SIZE(names); i++)
        if (PyDict_SetItem(by_name, PyTuple_GET_ITEM(names, i), named[i])) goto done;
    result = PyObject_CallMethod(self->helper, "miss", "OOO", self, args, by_name);
done:
    Py_DECREF(by_name);
    return result;
}

static PyObject *call(PyObject *me, PyObject *const *args, size_t nargsf, PyObject *names) {
    Kernel *self = (Kernel *)me;
    Py_ssize_t n = PyVectorcall_NARGS(nargsf);
    int named = names && PyTuple_GET_SIZE(names) > 0;
    PyObject *compiled = named ? NULL : find(self, args, n), *result;
    PyObject *tuple = packed(args, n);
    if (!tuple) return NULL;
    if (compiled) {
        /* The kernel lets go of Python's lock, and overloads may come meanwhile. */
        Py_INCREF(compiled);
        result = PyObject_Call(compiled, tuple, NULL);
        Py_DECREF(compiled);
    } else {
        result = miss(self, tuple, args + n, names);
    }
    Py_DECREF(tuple);
    return result;
}

static PyObject *kernel_new(PyTypeObject *type, PyObject *args, PyObject *kwargs) {
    PyObject *helper;
    if (!PyArg_ParseTuple(args, "O", &helper)) return NULL;
    Kernel *self = (Kernel *)type->tp_alloc(type, 0);
    if (!self) return NULL;
    Py_INCREF(helper);
    self->helper = helper;
    self->vectorcall = call;
    return (PyObject *)self;
}

static void kernel_dealloc(Kernel *self) {
    for (Py_ssize_t k = 0; k < self->count; k++) {
        free_kind(&self->overloads[k].arguments);
        Py_DECREF(self->overloads[k].compiled);
    }
    free(self->overloads);
    Py_XDECREF(self->helper);
    Py_XDECREF(self->dict);
    Py_TYPE(self)->tp_free((PyObject *)self);
}

static PyObject *kernel_add(Kernel *self, PyObject *args) {
    const char *words;
    PyObject *compiled;
    Kind arguments = {0};
    if (!PyArg_ParseTuple(args, "sO", &words, &compiled)) return NULL;
    if (!read_members(words, '\0', ' ', &arguments)) {
        free_kind(&arguments);
        return PyErr_Format(PyExc_ValueError, "no kinds of arguments: '%s'", words);
    }
    Overload *more = realloc(self->overloads, (self->count + 1) * sizeof(Overload));
    if (!more) {
        free_kind(&arguments);
        return PyErr_NoMemory();
    }
    self->overloads = more;
    Py_INCREF(compiled);
    self->overloads[self->count++] = (Overload){arguments, compiled};
    Py_RETURN_NONE;
}

static PyObject *kernel_finds(Kernel *self, PyObject *args) {
    PyObject *const *values = &PyTuple_GET_ITEM(args, 0);
    return PyBool_FromLong(find(self, values, PyTuple_GET_SIZE(args)) != NULL);
}

static PyObject *kernel_numba_type(Kernel *self, void *unused) {
    return PyObject_CallMethod(self->helper, "numba_type", "O", self);
}

static PyMethodDef methods[] = {
    {"add", (PyCFunction)kernel_add, METH_VARARGS, "add(kinds, compiled): one more function."},
    {"finds", (PyCFunction)kernel_finds, METH_VARARGS, "Whether there is one for the arguments."},
    {NULL},
};

static PyGetSetDef attributes[] = {
    {"_numba_type_", (getter)kernel_numba_type, NULL, "What numba takes a kernel for.", NULL},
    {"__dict__", PyObject_GenericGetDict, PyObject_GenericSetDict, NULL, NULL},
    {NULL},
};

static PyTypeObject KernelType = {
    PyVarObject_HEAD_INIT(NULL, 0)
    .tp_name = "tracker.kernels._dispatch.Kernel",
    .tp_doc = "Kernel(helper): calls what was compiled for the arguments, else helper.miss.",
    .tp_basicsize = sizeof(Kernel),
    .tp_flags = Py_TPFLAGS_DEFAULT | Py_TPFLAGS_HAVE_VECTORCALL,
    .tp_vectorcall_offset = offsetof(Kernel, vectorcall),
    .tp_dictoffset = offsetof(Kernel, dict),
    .tp_call = PyVectorcall_Call,
    .tp_new = kernel_new,
    .tp_dealloc = (destructor)kernel_dealloc,
    .tp_methods = methods,
    .tp_getset = attributes,
};

static PyModuleDef definition = {
    PyModuleDef_HEAD_INIT, .m_name = "_dispatch", .m_size = -1,
};

PyMODINIT_FUNC PyInit__dispatch(void) {
    import_array();
    if (PyType_Ready(&KernelType) < 0) return NULL;
    PyObject *module = PyModule_Create(&definition);
    if (!module) return NULL;
    Py_INCREF(&KernelType);
    if (PyModule_AddObject(module, "Kernel", (PyObject *)&KernelType) < 0) {
        Py_DECREF(&KernelType);
        Py_DECREF(module);
        return NULL;
    }
    return module;
}
