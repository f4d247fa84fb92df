/* Kernel: a callable that runs its compiled function if the arguments have that one's types.
 *
 * Compiled functions take what they are given for what they were compiled for, so each argument is
 * looked at first: its kind, size, dimensions and order (the words of signature.py). This is done in
 * C because a second of tracking makes some ten thousand such calls.
 */
#define PY_SSIZE_T_CLEAN
#define NPY_NO_DEPRECATED_API NPY_1_7_API_VERSION
#include <Python.h>
#include <numpy/arrayobject.h>
#include <numpy/arrayscalars.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

enum form { NUMBER, ARRAY, TUPLE };

typedef struct kind {
    enum form form;
    char letter;         /* numpy's kind of a number: b i u f c */
    int size;            /* bytes of a number */
    int dimensions;      /* of an array */
    char order;          /* C, F or A */
    int written;         /* whether the kernel writes to the array */
    Py_ssize_t count;    /* members of a tuple */
    struct kind *members;
    char name[64];       /* a named tuple's class, without its module; empty for a plain one */
} Kind;

typedef struct {
    PyObject_HEAD
    vectorcallfunc vectorcall;
    PyObject *dict;
    PyObject *helper;    /* miss(kernel, args, kwargs) and numba_type(kernel) */
    Kind arguments;      /* all of them, as a tuple */
    PyObject *compiled;  /* NULL before it is added, and if the library has none */
} Kernel;

/* --- reading the words */

static void free_kind(Kind *kind) {
    for (Py_ssize_t i = 0; i < kind->count; i++) free_kind(&kind->members[i]);
    free(kind->members);
    kind->members = NULL;
    kind->count = 0;
}

static const char *read_kind(const char *at, Kind *kind);

#define LETTERS "_0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"

/* Fields have their places; their names are for the fingerprint. */
static const char *after_field_name(const char *at) {
    const char *colon = at + strspn(at, LETTERS);
    return *colon == ':' ? colon + 1 : at;
}

static const char *read_members(const char *at, char end, char between, Kind *kind) {
    kind->form = TUPLE;
    while (at && *at && *at != end) {
        Kind *more = realloc(kind->members, (kind->count + 1) * sizeof(Kind));
        if (!more) return NULL;
        kind->members = more;
        memset(&kind->members[kind->count], 0, sizeof(Kind));
        at = after_field_name(at);
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
    kind->written = *after == 'w';
    if (kind->written) after++;
    return *after == ']' ? after + 1 : NULL;
}

/* A tuple's word begins with the name of its class, or with its bracket. */
static int is_tuple_word(const char *at) {
    return at[strspn(at, "." LETTERS)] == '(';
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
    char *after;
    if (!*at || !strchr("biufc", *at)) return NULL;
    kind->letter = at[0];
    kind->size = (int)strtol(at + 1, &after, 10);
    if (kind->size < 1 || kind->size > 16 || kind->size & (kind->size - 1)) return NULL;
    return *after == '[' ? read_array(after + 1, kind) : after;
}

/* --- looking at values */

/* Whether numbers of this kind and size are among the wanted ones, as Python has it: a bool is an
 * int, an int a float. */
static int holds(const Kind *wanted, char letter, int size) {
    if (letter == wanted->letter) return letter == 'c' ? size == wanted->size : size <= wanted->size;
    if (wanted->size != 8) return 0;
    if (wanted->letter == 'f') return letter == 'i' || letter == 'u' || letter == 'b';
    return wanted->letter == 'i' && (letter == 'b' || (letter == 'u' && size < 8));
}

static int is_numpy_number(const Kind *kind, PyObject *value) {
    if (!PyArray_CheckScalar(value) || PyArray_Check(value)) return 0;
    PyArray_Descr *type = PyArray_DescrFromScalar(value);
    if (!type) {
        PyErr_Clear();
        return 0;
    }
    int fits = holds(kind, type->kind, (int)PyDataType_ELSIZE(type));
    Py_DECREF(type);
    return fits;
}

static int is_number(const Kind *kind, PyObject *value) {
    if (PyFloat_Check(value)) return holds(kind, 'f', 8);
    if (PyBool_Check(value)) return holds(kind, 'b', 1);
    if (PyComplex_Check(value)) return holds(kind, 'c', 16);
    if (PyLong_Check(value)) {
        int overflow = 0;
        if (!holds(kind, 'i', 8)) return 0;
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
    if (kind->written && !PyArray_ISWRITEABLE(array)) return 0;
    if (kind->order == 'C') return PyArray_IS_C_CONTIGUOUS(array);
    if (kind->order == 'F') return PyArray_IS_F_CONTIGUOUS(array);
    return 1;
}

static int fits(const Kind *kind, PyObject *value) {
    switch (kind->form) {
    case NUMBER: return is_number(kind, value);
    case ARRAY: return is_array(kind, value);
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

static int all_fit(Kernel *self, PyObject *const *args, Py_ssize_t n) {
    if (!self->compiled || self->arguments.count != n) return 0;
    for (Py_ssize_t i = 0; i < n; i++)
        if (!fits(&self->arguments.members[i], args[i])) return 0;
    return 1;
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
    PyObject *tuple = packed(args, n), *result;
    if (!tuple) return NULL;
    if (!named && all_fit(self, args, n))
        result = PyObject_Call(self->compiled, tuple, NULL);
    else
        result = miss(self, tuple, args + n, names);
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
    free_kind(&self->arguments);
    Py_XDECREF(self->compiled);
    Py_XDECREF(self->helper);
    Py_XDECREF(self->dict);
    Py_TYPE(self)->tp_free((PyObject *)self);
}

static PyObject *kernel_add(Kernel *self, PyObject *args) {
    const char *words;
    PyObject *compiled;
    Kind arguments = {0};
    if (!PyArg_ParseTuple(args, "sO", &words, &compiled)) return NULL;
    if (self->compiled) return PyErr_Format(PyExc_ValueError, "the kernel has its function");
    if (!read_members(words, '\0', ' ', &arguments)) {
        free_kind(&arguments);
        return PyErr_Format(PyExc_ValueError, "no types of arguments: '%s'", words);
    }
    Py_INCREF(compiled);
    self->arguments = arguments;
    self->compiled = compiled; /* last: other threads may be calling, and see it then only */
    Py_RETURN_NONE;
}

static PyObject *kernel_finds(Kernel *self, PyObject *args) {
    return PyBool_FromLong(all_fit(self, &PyTuple_GET_ITEM(args, 0), PyTuple_GET_SIZE(args)));
}

static PyObject *kernel_numba_type(Kernel *self, void *unused) {
    return PyObject_CallMethod(self->helper, "numba_type", "O", self);
}

static PyMethodDef methods[] = {
    {"add", (PyCFunction)kernel_add, METH_VARARGS, "add(types, compiled): the function to run."},
    {"finds", (PyCFunction)kernel_finds, METH_VARARGS, "Whether the function takes the arguments."},
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

/* Whether processor and system have what wide parts are compiled for (parts.py). */
static PyObject *runs_wide(PyObject *module, PyObject *unused) {
#if defined(__GNUC__) && defined(__x86_64__)
    return PyBool_FromLong(__builtin_cpu_supports("avx2"));
#else
    Py_RETURN_FALSE;
#endif
}

static PyMethodDef functions[] = {
    {"runs_wide", runs_wide, METH_NOARGS, "Whether wide parts run on this processor."},
    {NULL},
};

static PyModuleDef definition = {
    PyModuleDef_HEAD_INIT, .m_name = "_dispatch", .m_size = -1, .m_methods = functions,
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
