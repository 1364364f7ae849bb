# SPDX-License-Identifier: MIT
"""The C library as ctypes sees it: where it is, its records, its functions, its errors. Private to this package.

Each record here is the one of the same name in core/include/boomerang; tests/front holds them against the headers.
"""
import ctypes
import itertools
import os
import pathlib
import weakref
from ctypes import CFUNCTYPE, POINTER, byref, c_bool, c_char_p, c_double, c_float, c_int, c_int8, c_size_t, c_uint, c_uint8, c_uint16, c_uint32, c_uint64, c_void_p, pointer

PAIR_STRUCTURES = ("lazy-compass", "lazy-dudley", "free-direction", "two-lines")


class BoomerangError(ValueError):
    """What the library refused. `code` is its bmr_error; the text is the library's own sentence."""

    def __init__(self, code, text):
        super().__init__(text)
        self.code = code


def record(name, *fields):
    """The ctypes.Structure `bmr_<name>` with these (name, type) pairs."""
    return type(name, (ctypes.Structure,), {"_fields_": list(fields)})


vec2 = record("vec2", ("x", c_double), ("y", c_double))
pose = record("pose", ("position", vec2), ("c", c_double), ("s", c_double))
polygon = record("polygon", ("vertices", POINTER(vec2)), ("count", c_uint32), ("lowest", c_uint16), ("highest", c_uint16),
                 ("center", vec2), ("radius", c_double), ("extent", c_double), ("stamp", c_uint32))
allocator = record("allocator", ("allocate", CFUNCTYPE(c_void_p, c_void_p, c_size_t)),
                   ("release", CFUNCTYPE(None, c_void_p, c_void_p, c_size_t)), ("context", c_void_p))
closest_points = record("closest_points", ("distance", c_double), ("point_a", vec2), ("point_b", vec2), ("normal", vec2))
overlap = record("overlap", ("depth", c_double), ("normal", vec2), ("point_a", vec2), ("point_b", vec2))
shape = type("shape", (ctypes.Structure,), {})  # its fields are as many as there are kinds of hierarchies: see below
certificate = record("certificate", ("normal", c_float * 2), ("offset", c_float), ("window", c_float * 2 * 2), ("low", c_float * 2),
                     ("high", c_float * 2))
pair = record("pair", ("certificate", certificate), ("bits", c_uint8), ("owner", c_uint8), ("state", c_uint8), ("level", c_int8),
              ("edge", c_uint32), ("other", c_uint32), ("other_after", c_uint32), ("stamp", c_uint32))
pair_def = record("pair_def", ("structure", c_int), ("margin", c_double), ("hysteresis", c_double))
event = record("event", ("kind", c_int), ("level_before", c_int), ("level_after", c_int), ("pair", POINTER(pair)),
               ("pose", POINTER(pose)), ("gap", c_double))
counters = record("counters", ("checks", c_uint64), ("events", c_uint64 * 8), ("steps", c_uint64))
ON_EVENT = CFUNCTYPE(None, c_void_p, POINTER(event))
observer = record("observer", ("counters", POINTER(counters)), ("on_event", ON_EVENT), ("context", c_void_p))
condition = record("condition", ("normal", vec2), ("offset", c_double), ("point", vec2), ("kind", c_uint8), ("owner", c_uint8),
                   ("label", c_uint8), ("reserved", c_uint8 * 5))
line = record("line", ("normal", vec2), ("offset", c_double))
kds_info = record("kds_info", ("name", c_char_p), ("title", c_char_p), ("section", c_char_p), ("domain", c_int), ("role", c_int),
                  ("hierarchy", c_int), ("implementation", c_void_p))
kds_def = record("kds_def", ("margin", c_double), ("hysteresis", c_double), ("alpha", c_double), ("offset_ratio", c_double),
                 ("root_level", c_uint))
kds_report = record("kds_report", ("kind", c_int), ("apart", c_bool), ("line_changed", c_bool), ("level_before", c_int),
                    ("level_after", c_int), ("touched", c_uint))
kds_proof = record("kds_proof", ("owner", c_int), ("line", line), ("nearest", vec2), ("level", c_int))
failure_options = record("failure_options", ("tolerance", c_double))
simulation_def = record("simulation_def", ("structure", POINTER(kds_info)), ("kds", kds_def), ("failure", failure_options),
                        ("contact_step", c_double))
simulation_event = record("simulation_event", ("time", c_double), ("report", kds_report), ("failed", condition), ("before", kds_proof),
                          ("after", kds_proof), ("pose", pose), ("kds", c_void_p))
ON_SIMULATION_EVENT = CFUNCTYPE(None, c_void_p, POINTER(simulation_event))
simulation_counts = record("simulation_counts", ("events", c_uint64 * 12), ("lines", c_uint64), ("touched", c_uint64),
                           ("failure_times", c_uint64), ("replanned", c_uint64), ("external", c_uint64),
                           ("conditions", c_size_t), ("bytes", c_size_t))
screw_motion = record("screw_motion", ("start", pose), ("velocity", vec2), ("spin", c_double))
algebraic_piece = record("algebraic_piece", ("degree", c_size_t), ("x", c_double * 9), ("y", c_double * 9),
                         ("rotation_degree", c_size_t), ("a", c_double * 9), ("b", c_double * 9), ("start_c", c_double),
                         ("start_s", c_double))
piece_of_kind = type("piece_of_kind", (ctypes.Union,), {"_fields_": [("algebraic", algebraic_piece), ("screw", screw_motion)]})
motion_piece = record("motion_piece", ("kind", c_int), ("origin", c_double), ("as", piece_of_kind))
family_def = record("family_def", ("family", c_int), ("ratio", c_double), ("seed", c_uint64), ("steps", c_uint), ("turns", c_uint))
family_motion = record("family_motion", ("motions", c_void_p * 2), ("diameter", c_double), ("sigma", c_double),
                       ("separation", c_double), ("nearest", c_double))
course = record("course", ("polygons", POINTER(polygon) * 2), ("motions", c_void_p * 2), ("from", c_double), ("to", c_double))
optimum = record("optimum", ("least", c_uint64), ("found", c_uint64), ("samples", c_uint64), ("contacts", c_uint64))
growth = record("growth", ("exponent", c_double), ("exponent_error", c_double), ("constant", c_double), ("slope", c_double),
                ("slope_error", c_double), ("offset", c_double), ("power_residual", c_double), ("log_residual", c_double),
                ("logarithmic", c_bool), ("count", c_size_t))

# What each function answers and takes. A c_int that is checked for an error is written `error`.
error = object()
CORE = {
    "bmr_error_describe": (c_char_p, c_int),
    "bmr_polygon_create": (error, POINTER(vec2), c_size_t, c_void_p, POINTER(POINTER(polygon))),
    "bmr_polygon_destroy": (None, POINTER(polygon), c_void_p),
    "bmr_polygon_contains": (c_bool, POINTER(polygon), vec2, c_double),
    "bmr_distance": (error, POINTER(polygon), POINTER(pose), POINTER(polygon), POINTER(pose), POINTER(closest_points)),
    "bmr_penetration": (error, POINTER(polygon), POINTER(pose), POINTER(polygon), POINTER(pose), POINTER(overlap)),
    "bmr_compass_create": (error, c_size_t, c_void_p, POINTER(c_void_p)),
    "bmr_compass_destroy": (None, c_void_p, c_void_p),
    "bmr_hierarchy_build": (error, c_int, POINTER(polygon), c_void_p, c_void_p, POINTER(c_void_p)),
    "bmr_hierarchy_name": (c_char_p, c_int),
    "bmr_hierarchy_uses_compass": (c_bool, c_int),
    "bmr_hierarchy_destroy": (None, c_void_p, c_void_p),
    "bmr_hierarchy_depth": (c_uint32, c_void_p),
    "bmr_hierarchy_edge_count": (c_uint32, c_void_p),
    "bmr_pair_advance": (c_int, POINTER(pair), POINTER(pair_def), POINTER(shape), POINTER(shape), POINTER(pose), POINTER(observer),
                         POINTER(c_double)),
    "bmr_pair_audit": (error, POINTER(pair), POINTER(pair_def), POINTER(shape), POINTER(shape), POINTER(pose)),
    "bmr_event_name": (c_char_p, c_int),
    "bmr_kds_count": (c_size_t,),
    "bmr_kds_at": (POINTER(kds_info), c_size_t),
    "bmr_kds_find": (error, c_char_p, POINTER(POINTER(kds_info))),
    "bmr_kds_describe_unknown": (c_size_t, c_char_p, c_char_p, c_size_t),
    "bmr_kds_event_name": (c_char_p, c_int),
}
KINETIC = {
    "bmr_motion_create": (error, POINTER(motion_piece), c_void_p, POINTER(c_void_p)),
    "bmr_motion_create_sampled": (error, POINTER(c_double), POINTER(pose), c_size_t, c_void_p, POINTER(c_void_p)),
    "bmr_motion_destroy": (None, c_void_p),
    "bmr_motion_pose": (pose, c_void_p, c_double, POINTER(vec2), POINTER(c_double)),
    "bmr_default_simulation_def": (simulation_def,),
    "bmr_simulation_create": (error, POINTER(simulation_def), POINTER(shape), POINTER(c_void_p), c_double, ON_SIMULATION_EVENT, c_void_p,
                              c_void_p, POINTER(c_void_p)),
    "bmr_simulation_destroy": (None, c_void_p),
    "bmr_simulation_run": (error, c_void_p, c_double),
    "bmr_simulation_time": (c_double, c_void_p),
    "bmr_simulation_get_counts": (simulation_counts, c_void_p),
    "bmr_simulation_audit": (error, c_void_p),
    "bmr_time_of_contact": (error, POINTER(shape), c_void_p, POINTER(shape), c_void_p, c_double, c_double, c_double, c_void_p,
                            POINTER(c_double)),
    "bmr_ngon_name": (c_char_p, c_int),
    "bmr_ngon_points": (error, c_int, c_size_t, c_uint64, POINTER(vec2)),
    "bmr_family_name": (c_char_p, c_int),
    "bmr_family_create": (error, POINTER(family_def), POINTER(polygon), POINTER(polygon), c_void_p, POINTER(family_motion)),
    "bmr_offline_optimum": (error, POINTER(course), c_double, c_double, c_void_p, c_size_t, POINTER(optimum)),
    "bmr_fit_growth": (error, POINTER(c_double), POINTER(c_double), c_size_t, POINTER(growth)),
}


def load(name):
    """The shared library `name`, from the first place that has it."""
    folder = os.environ.get("BOOMERANG_LIBRARY_DIR")
    # PREFIX/lib/pythonN/dist-packages/boomerang/_c.py, and the library in PREFIX/lib or one folder below it.
    for above in pathlib.Path(__file__).resolve().parents:
        if above.name == "lib" and not folder:
            for found in (above / name, *sorted(above.glob(f"*/{name}"))):
                if found.exists():
                    return ctypes.CDLL(str(found))
    try:
        return ctypes.CDLL(str(pathlib.Path(folder) / name) if folder else name)
    except OSError as problem:
        needs = ", built where GSL is (libgsl-dev)" if "kinetic" in name else ""
        raise ImportError(f"{name} is not found ({problem}). It is a part of Boomerang{needs}; where it "
                          "lies elsewhere, set BOOMERANG_LIBRARY_DIR to its folder") from None


def check(code, *_):
    if code != 0:
        raise BoomerangError(code, core.bmr_error_describe(code).decode())
    return code


class Library:
    """The functions of a table above, as attributes; those that answer with an error raise it."""

    def __init__(self, name, table):
        library = load(name)
        for function, (result, *arguments) in table.items():
            made = getattr(library, function)
            made.argtypes = arguments
            made.restype = c_int if result is error else result
            if result is error:
                made.errcheck = check
            setattr(self, function, made)


core = Library("libboomerang_core.so.1", CORE)
HIERARCHY_KINDS = tuple(name.decode() for name in itertools.takewhile(bool, map(core.bmr_hierarchy_name, itertools.count())))
shape._fields_ = [("polygon", POINTER(polygon)), ("hierarchies", c_void_p * len(HIERARCHY_KINDS)),
                  ("chains", c_void_p * len(HIERARCHY_KINDS))]
# Where objects take their memory from: None, which is malloc, or an `allocator`. (Tests count with one.)
memory = None


def memory_now():
    return None if memory is None else ctypes.addressof(memory)


def create(function, *arguments, kind=c_void_p):
    """Calls function(*arguments, allocator, &made) and returns (made, allocator)."""
    made = kind()
    where = memory_now()
    function(*arguments, where, byref(made))
    return made, where


def vectors(points):
    """A C array of pairs of numbers."""
    points = [vec2(float(x), float(y)) for x, y in points]
    return (vec2 * max(1, len(points)))(*points), len(points)


def to_vec2(v):
    x, y = v
    return vec2(float(x), float(y))


def point(v):
    return (v.x, v.y)


def release_with(owner, keeps, function, *arguments):
    """function(*arguments) once `owner` is gone; until then what is in `keeps` stays. Not at the interpreter's end, when the process
    gives all back."""
    weakref.finalize(owner, lambda _: function(*arguments), keeps).atexit = False
