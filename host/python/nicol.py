"""nicol in Python: crystals rendered as they are, the film as numpy arrays.

    import nicol
    scene = nicol.load("interference_figure.pov", width=256, height=256, declares={"Angle": 30})
    picture = scene.render()
    picture.stokes                  # (4, wavelengths, height, width), the film itself
    picture.wavelengths_nm          # (wavelengths,)
    picture.write("figure.exr")

Frames: rows run from the top, columns from the left, as the receiver sees them. Stokes vectors are spectral radiance (per nm, in the
scene's own unit) in the receiver's frame, x to the right and y up, light running towards the eye: S1 > 0 horizontal, S2 > 0 at
+45 degrees counter-clockwise from x, S3 > 0 right circular (clockwise in time for the receiver). Wavelengths are vacuum wavelengths.

Arrays lie on memory of the picture or scene, without a copy. They are read-only and keep it alive. Where something fails, an Error says
why; a scene with errors raises SceneError with all its diagnostics. Callbacks run on the calling thread; an exception in one stops
the call and comes out of it. Ctrl-C stops a rendering between two tiles; a scene that is being read is read to its end first. Other
threads run on while nicol works. A process that is forked once nicol has rendered or looked for devices cannot render (DeviceError):
OpenCL does not survive a fork. With multiprocessing, take the method "spawn".

libnicol is looked for where NICOL_LIBRARY says, beside this module, in the prefix that it is installed in, then as the system finds
libraries. Only numpy is needed beyond Python 3.9.
"""

import ctypes
import os
import signal
import struct
import sysconfig
import threading
import zlib
from ctypes import CFUNCTYPE, POINTER, byref, c_char, c_char_p, c_double, c_int, c_int32, c_size_t, c_uint32, c_uint64, c_void_p
from pathlib import Path
from types import SimpleNamespace

import numpy as np

__all__ = ["ArgumentError", "CallbackError", "Cancelled", "Context", "DeviceError", "Error", "InputError", "InternalError",
           "OutputError", "Picture", "PluginError", "Record", "Scene", "SceneError", "UnavailableError", "devices", "load", "load_text",
           "merge", "version"]

# ---- The C interface, as host/api/nicol.h has it ----

ABI_VERSION = 1


def _struct(name, *fields):
    return type(name, (ctypes.Structure,), {"_fields_": [("struct_size", c_uint32), *fields]})


_LogCallback = CFUNCTYPE(None, c_void_p, c_int32, c_char_p)
_IncludeCallback = CFUNCTYPE(c_int, c_void_p, c_char_p, c_void_p)
_ProgressCallback = CFUNCTYPE(c_int, c_void_p, c_double, c_double, c_double)
_TileCallback = CFUNCTYPE(c_int, c_void_p, c_void_p)
_CancelCallback = CFUNCTYPE(c_int, c_void_p)

_DeviceInfo = _struct(
    "nicol_device_info", ("index", c_int32), ("name", c_char * 128), ("platform", c_char * 128), ("version", c_char * 128),
    ("driver", c_char * 128), ("is_cpu", c_int32), ("is_gpu", c_int32), ("has_fp64", c_int32), ("compute_units", c_int32),
    ("memory_bytes", c_uint64))
_ContextOptions = _struct(
    "nicol_context_options", ("library_path_count", c_uint32), ("device", c_char_p), ("library_paths", POINTER(c_char_p)),
    ("log", _LogCallback), ("user", c_void_p))
_SceneOptions = _struct(
    "nicol_scene_options", ("width", c_int32), ("height", c_int32), ("library_path_count", c_uint32),
    ("library_paths", POINTER(c_char_p)), ("declare_count", c_size_t), ("declare_names", POINTER(c_char_p)),
    ("declare_values", POINTER(c_double)), ("wavelength_count", c_size_t), ("wavelengths_nm", POINTER(c_double)), ("samples", c_int32),
    ("max_trace_level", c_int32), ("error", c_double), ("sample_error", c_double), ("adc_bailout", c_double), ("polarization", c_int32),
    ("frame_number", c_int32), ("initial_frame", c_int32), ("final_frame", c_int32), ("clock", c_double), ("clock_delta", c_double),
    ("initial_clock", c_double), ("final_clock", c_double), ("include", _IncludeCallback), ("user", c_void_p))
_Diagnostic = _struct(
    "nicol_diagnostic", ("severity", c_int32), ("file", c_char_p), ("line", c_uint32), ("column", c_uint32), ("message", c_char_p),
    ("text", c_char_p))
_Feature = _struct("nicol_feature", ("on", c_int32), ("name", c_char_p), ("meaning", c_char_p), ("reason", c_char_p))
_Tile = _struct(
    "nicol_tile", ("width", c_int32), ("height", c_int32), ("reserved", c_uint32), ("pixel_count", c_size_t), ("pixels", c_void_p),
    ("wavelength_count", c_size_t), ("wavelengths_nm", c_void_p), ("stokes", c_void_p), ("linear_srgb", c_void_p))
_RenderOptions = _struct(
    "nicol_render_options", ("precision", c_int32), ("lanes", c_int32), ("generic", c_int32), ("no_cache", c_int32), ("resume", c_int32),
    ("journal", c_char_p), ("want_error_bound", c_int32), ("want_error_budget", c_int32), ("part", c_int32), ("part_count", c_int32),
    ("first_row", c_int32), ("row_count", c_int32), ("first_column", c_int32), ("column_count", c_int32),
    ("first_wavelength_nm", c_double), ("last_wavelength_nm", c_double), ("progress", _ProgressCallback), ("tile", _TileCallback),
    ("cancel", _CancelCallback), ("user", c_void_p))
_MergeOptions = _struct("nicol_merge_options", ("incomplete", c_int32))
_Report = _struct(
    "nicol_report", ("lanes", c_int32), ("precision", c_int32), ("interrupted", c_int32), ("device", c_char_p), ("seconds", c_double),
    ("seconds_to_first_tile", c_double), ("build_seconds", c_double), ("kernel_cached", c_int32), ("passes", c_int32),
    ("segments", c_uint64), ("nan_count", c_uint64), ("energy_count", c_uint64), ("stack_count", c_uint64), ("stokes_count", c_uint64),
    ("precise_count", c_uint64), ("tiles", c_uint64), ("tiles_found", c_uint64), ("samples_mean", c_double), ("sample_error", c_double),
    ("sample_error_kept", c_int32), ("reserved", c_int32), ("mean_radiance", c_double), ("cut_off_mean", c_double),
    ("cut_off_worst", c_double))
_BudgetLine = _struct(
    "nicol_budget_line", ("reserved", c_uint32), ("source", c_char_p), ("rms", c_double), ("detail", c_char_p), ("price", c_char_p),
    ("seconds", c_double))
_Chosen = _struct(
    "nicol_chosen", ("kept", c_int32), ("error", c_double), ("text", c_char_p), ("reason", c_char_p), ("seconds", c_double))
STRUCTS = [_DeviceInfo, _ContextOptions, _SceneOptions, _Diagnostic, _Feature, _Tile, _RenderOptions, _MergeOptions, _Report, _BudgetLine,
           _Chosen]

_SEVERITIES = ("note", "warning", "error")
_PRECISIONS = ("float", "double")
_SWITCHES = (None, True, False)
_PLANES = ("coverage", "samples", "cut_off", "sample_error", "error_cut_off", "error_sampling", "error_rounding", "error_total")

# Those that do not answer a status; what each takes.
_ANSWERS = {
    "nicol_abi_version": c_uint32, "nicol_version": c_char_p, "nicol_last_error": c_char_p, "nicol_status_text": c_char_p,
    "nicol_context_release": None, "nicol_scene_release": None, "nicol_picture_release": None, "nicol_scene_diagnostic_count": c_size_t,
    "nicol_scene_file_count": c_size_t, "nicol_scene_feature_count": c_size_t, "nicol_picture_budget_count": c_size_t,
    "nicol_picture_note_count": c_size_t}
_TAKES = {
    "nicol_abi_version": [], "nicol_version": [], "nicol_last_error": [], "nicol_status_text": [c_int32],
    "nicol_device_count": [c_void_p], "nicol_device_get": [c_size_t, c_void_p],
    "nicol_context_create": [c_void_p] * 2, "nicol_context_release": [c_void_p], "nicol_context_device": [c_void_p] * 2,
    "nicol_load_plugin": [c_void_p, c_char_p], "nicol_include_set_text": [c_void_p, c_char_p, c_size_t],
    "nicol_scene_load_file": [c_void_p, c_char_p, c_void_p, c_void_p],
    "nicol_scene_load_text": [c_void_p, c_char_p, c_char_p, c_size_t, c_void_p, c_void_p],
    "nicol_scene_release": [c_void_p], "nicol_scene_explanation": [c_void_p] * 2, "nicol_scene_size": [c_void_p] * 3,
    "nicol_scene_wavelengths": [c_void_p] * 3,
    **{f"nicol_scene_{what}_count": [c_void_p] for what in ("diagnostic", "file", "feature")},
    **{f"nicol_scene_{what}": [c_void_p, c_size_t, c_void_p] for what in ("diagnostic", "file", "feature")},
    "nicol_render": [c_void_p] * 3, "nicol_merge": [c_void_p, c_void_p, c_size_t, c_void_p, c_void_p],
    "nicol_picture_release": [c_void_p], "nicol_picture_size": [c_void_p] * 3, "nicol_picture_wavelengths": [c_void_p] * 4,
    "nicol_picture_plane": [c_void_p, c_int32, c_void_p],
    **{f"nicol_picture_{what}": [c_void_p] * 2
       for what in ("stokes", "xyz", "linear_srgb", "report", "budget_rms", "chosen")},
    "nicol_picture_budget_count": [c_void_p], "nicol_picture_budget_line": [c_void_p, c_size_t, c_void_p],
    "nicol_picture_note_count": [c_void_p], "nicol_picture_note": [c_void_p, c_size_t, c_void_p, c_void_p],
    "nicol_picture_write": [c_void_p, c_char_p], "nicol_picture_write_error_map": [c_void_p, c_char_p]}


def _library_places():
    """Where libnicol may lie, in order."""
    name = f"libnicol.so.{ABI_VERSION}"
    here = Path(__file__).resolve().parent
    multiarch = sysconfig.get_config_var("MULTIARCH") or "lib"
    for folder in (here, *list(here.parents)[:4]):
        for place in ("", "lib", "lib64", multiarch, f"lib/{multiarch}"):
            if (folder / place / name).is_file():
                yield str(folder / place / name)
    yield name


def _load_library():
    named = os.environ.get("NICOL_LIBRARY")
    path = named or next(_library_places())
    try:
        library = ctypes.CDLL(path)
    except OSError as error:
        raise ImportError(f"libnicol cannot be loaded: {error}; NICOL_LIBRARY may name the file") from error
    library.nicol_abi_version.restype = c_uint32
    found = library.nicol_abi_version()
    if found != ABI_VERSION:
        raise ImportError(f"{path} has version {found} of nicol's interface, this module needs {ABI_VERSION}")
    for function, takes in _TAKES.items():
        entry = getattr(library, function)
        entry.argtypes, entry.restype = takes, _ANSWERS.get(function, c_int32)
    return library


_lib = _load_library()
version = _lib.nicol_version().decode()

# ---- Errors ----


class Error(Exception):
    """What nicol could not do, in words; `status` is the number of the C interface."""

    status = 0


class Cancelled(Error):
    """`cancel` said stop. `picture`: as far as it got, or None if nothing was rendered."""

    picture = None


class SceneError(Error):
    """The scene has errors: `diagnostics` lists them all, warnings too, each with severity, file, line, column, message, text."""

    diagnostics = ()


class DeviceError(Error):
    """No OpenCL device, none of that name, or it failed."""


class InputError(Error):
    """A file that cannot be read, or parts that do not fit each other."""


class OutputError(Error):
    """A file that cannot be written."""


class PluginError(Error):
    """A plugin that cannot be loaded, or that failed."""


class CallbackError(Error):
    """An exception of another language left a callback."""


class UnavailableError(Error):
    """The picture does not have what was asked for."""


class ArgumentError(Error, ValueError):
    """What was asked makes no sense."""


class InternalError(Error):
    """An error in libnicol."""


_ERRORS = {1: Cancelled, 2: ArgumentError, 3: SceneError, 4: DeviceError, 5: InputError, 6: OutputError, 8: PluginError,
           9: CallbackError, 10: UnavailableError, 11: InternalError}
_NO_MEMORY, _UNAVAILABLE = 7, 10

# ---- Calls: statuses, exceptions of callbacks, Ctrl-C ----

_thread = threading.local()  # raised: by a callback of the call that this thread is in


class _Outcome:
    """What a call answered: its status with the words, and what a callback raised meanwhile."""

    def __init__(self, function, *arguments):
        arguments = [argument.open_pointer if isinstance(argument, _Owner) else argument for argument in arguments]
        outer, _thread.raised = getattr(_thread, "raised", None), None
        self.status = function(*arguments)
        self.words = _lib.nicol_last_error().decode(errors="replace") if self.status else ""
        self.raised, _thread.raised = _thread.raised, outer

    def error(self):
        """The exception that tells it, or None."""
        if self.raised is not None or not self.status:
            return self.raised
        words = self.words or _lib.nicol_status_text(self.status).decode()
        words = words.replace("want_error_", "error_").replace("no_cache", "cache")  # as Python calls them
        error = MemoryError(words) if self.status == _NO_MEMORY else _ERRORS.get(self.status, Error)(words)
        error.status = self.status
        return error

    def check(self):
        error = self.error()
        if error is not None:
            raise error


def _call(function, *arguments):
    _Outcome(function, *arguments).check()


def _callback(kind, function, stop=1):
    """A C callback that hands its arguments but `user` on; an exception is kept for the call, which is told to stop."""

    def call(_, *arguments):
        try:
            return function(*arguments)
        except BaseException as error:  # KeyboardInterrupt and SystemExit too: C cannot pass them on
            if _thread.raised is None:
                _thread.raised = error
            return stop

    return kind(call)


class _Interrupts:
    """Ctrl-C while a call runs: noted, and told to Python's own handler afterwards. In other threads than the main one: nothing."""

    def __enter__(self):
        self.told, self.before = None, None
        if threading.current_thread() is threading.main_thread() and callable(signal.getsignal(signal.SIGINT)):
            self.before = signal.signal(signal.SIGINT, self._tell)
        return self

    def _tell(self, *signal_and_frame):
        self.told = signal_and_frame

    def __exit__(self, *_):
        if self.before is not None:
            signal.signal(signal.SIGINT, self.before)
        if self.told is not None:
            self.before(*self.told)


class _Handle:
    """One count of something of libnicol's, and what must live as long."""

    def __init__(self, pointer, release, *keeps):
        self.pointer, self._release, self._keeps = pointer, release, keeps

    def __reduce__(self):
        raise TypeError("scenes, pictures and contexts stay in their process: a scene's text can go to another, a picture as a file")

    def __del__(self):
        self._release(self.pointer)


class _Memory:
    """Values at an address, as numpy takes them; `owner` keeps them there."""

    def __init__(self, address, shape, dtype, owner):
        self.owner = owner
        self.__array_interface__ = {"data": (address, True), "shape": shape, "typestr": np.dtype(dtype).str, "version": 3}


def _view(address, shape, dtype, owner):
    return np.asarray(_Memory(address, shape, dtype, owner)) if 0 not in shape else np.zeros(shape, dtype)


class _Owner:
    """A class with a handle, that may be closed before it goes."""

    _handle = None

    @property
    def open_pointer(self):
        """For the C interface. ValueError once it is closed."""
        if self._handle is None:
            raise ValueError(f"this {type(self).__name__} is closed")
        return self._handle.pointer

    def close(self):
        """Lets go of it; arrays that were handed out stay valid."""
        self._handle = None

    def __deepcopy__(self, _):
        """Another that may be closed by itself; what stands behind both does not change."""
        made = type(self).__new__(type(self))
        made._handle = self._handle
        return made

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()


class Record(SimpleNamespace):
    """Plain values."""


def _plain(value, **changes):
    """A filled struct as a Record."""
    skipped = ("struct_size", "reserved")
    fields = {name: getattr(value, name) for name, _ in value._fields_ if name not in skipped}
    texts = {name: text.decode(errors="replace") for name, text in fields.items() if isinstance(text, bytes)}
    return Record(**{**fields, **texts, **changes})


def _sized(kind, **values):
    """A struct of this version's size; None stays zero."""
    made = kind(struct_size=ctypes.sizeof(kind), **{name: value for name, value in values.items() if value is not None})
    for name, value in values.items():
        if isinstance(value, int) and getattr(made, name) != value:  # ctypes cuts off what does not fit
            raise ValueError(f"{name}: {value} is out of range")
    return made


def _filled(kind, function, *arguments):
    """The struct that a function fills."""
    value = _sized(kind)
    _call(function, *arguments, byref(value))
    return value


def _name(text):
    """A path or another name, for C: a text without zeros."""
    data = os.fsencode(text)
    if b"\0" in data:
        raise ValueError("embedded null byte")
    return data


def _texts(texts):
    if isinstance(texts, (str, bytes, os.PathLike)):
        raise TypeError(f"a list of texts is wanted, not {texts!r} alone")
    names = [_name(text) for text in texts]
    return (c_char_p * len(names))(*names)


def _one_of(name, value, choices):
    """The place of a value among those that it may have."""
    for place, choice in enumerate(choices):
        if type(value) is type(choice) and value == choice:
            return place
    raise ValueError(f"{name} is one of {', '.join(map(repr, choices))}, not {value!r}")


def _pair(name, value, meaning):
    """The two of a pair; zeros for None."""
    if value is None:
        return 0, 0
    if isinstance(value, (str, bytes)) or not hasattr(value, "__len__") or len(value) != 2:
        raise ValueError(f"{name} is a pair {meaning}, not {value!r}")
    return value


def _content(text):
    if not isinstance(text, (str, bytes, bytearray, memoryview)):
        raise TypeError(f"a text is wanted, not {type(text).__name__}")
    return text.encode() if isinstance(text, str) else bytes(text)


def _doubles(values):
    values = [float(value) for value in values]
    return (c_double * len(values))(*values)


def _text_of(function, *arguments):
    text = c_char_p()
    _call(function, *arguments, byref(text))
    return text.value.decode(errors="replace")


# ---- Devices and contexts ----


def _device_of(info):
    return _plain(info, **{name: bool(getattr(info, name)) for name in ("is_cpu", "is_gpu", "has_fp64")})


def devices():
    """The OpenCL devices of this machine: records with index, name, platform, version, driver, is_cpu, is_gpu, has_fp64, compute_units,
    memory_bytes."""
    count = c_size_t()
    _call(_lib.nicol_device_count, byref(count))
    return [_device_of(_filled(_DeviceInfo, _lib.nicol_device_get, i)) for i in range(count.value)]


class Context(_Owner):
    """A device, and where scenes' files are looked for.

    device: an index, or a part of a device's name; a list of them, or "all": they share the work; None: a GPU if there is one, else the CPU.
    library_paths: folders where include files are looked for, before nicol's own.
    log: called with a severity ("note", "warning", "error") and a text, for what scenes say by #debug.
    """

    def __init__(self, device=None, library_paths=(), log=None):
        paths = _texts(library_paths)
        names = [str(name) for name in (device if isinstance(device, (list, tuple)) else [device]) if name is not None]
        options = _sized(_ContextOptions, library_path_count=len(paths), library_paths=paths, device=",".join(names).encode())
        told = lambda severity, text: log(_SEVERITIES[severity], text.decode(errors="replace"))
        callback = _LogCallback() if log is None else _callback(_LogCallback, told, stop=None)
        options.log = callback
        pointer = c_void_p()
        _call(_lib.nicol_context_create, byref(options), byref(pointer))
        self._handle = _Handle(pointer, _lib.nicol_context_release, callback)

    @property
    def device(self):
        """The device that renders, or the first of them, opened if it is not yet: a record as in devices()."""
        return _device_of(_filled(_DeviceInfo, _lib.nicol_context_device, self))

    def load_plugin(self, path):
        """Loads a plugin (nicol_plugin.h), a file or a name, for scenes that are read afterwards. Its code runs in this process, and stays
        until the end; formats that it writes are there for every picture."""
        _call(_lib.nicol_load_plugin, self, _name(path))

    def load(self, path, **options):
        """The scene in a file. Options: see load_text. Raises SceneError if it has errors."""
        return self._scene(_lib.nicol_scene_load_file, (_name(path),), **options)

    def load_text(self, text, name="scene.pov", **options):
        """The scene in a text, called `name` in messages; files are looked for in the folder of `name` too.

        width, height: of the picture, pixels (512).       declares: dict of numbers, as #declare NAME = VALUE ahead of the scene.
        wavelengths_nm: array, in place of the scene's.     samples: per pixel.       library_paths: folders, before the context's.
        error, sample_error: relative (0.001 is 0.1 %), settings that keep the picture, or pixel sampling alone, to it are chosen.
        max_trace_level, adc_bailout: as POV-Ray's.         polarization: True, False; None: as the scene says.
        include: called with the name of each #include; answers its text (str, bytes), or None: it is a file.
        clock, frame_number, initial_frame, final_frame, clock_delta, initial_clock, final_clock: of an animation, as POV-Ray's.
        """
        data = _content(text)
        return self._scene(_lib.nicol_scene_load_text, (_name(name), data, len(data)), **options)

    def merge(self, paths, incomplete=False):
        """Parts of a picture, as .exr files, joined to the bits of one run. incomplete: what is missing does not matter."""
        pointer, files = c_void_p(), _texts(paths)
        _call(_lib.nicol_merge, self, files, len(files), byref(_sized(_MergeOptions, incomplete=int(incomplete))), byref(pointer))
        return Picture(_Handle(pointer, _lib.nicol_picture_release, self._handle))

    def _scene(self, function, what, *, width=0, height=0, library_paths=(), declares=None, wavelengths_nm=None, samples=0,
               max_trace_level=0, error=0, sample_error=0, adc_bailout=0, polarization=None, include=None, **animation):
        if not set(animation) <= {"clock", "frame_number", "initial_frame", "final_frame", "clock_delta", "initial_clock", "final_clock"}:
            raise TypeError(f"unknown options of a scene: {', '.join(animation)}")
        paths, declares = _texts(library_paths), declares or {}
        lambda_nm = _doubles(() if wavelengths_nm is None else wavelengths_nm)
        options = _sized(
            _SceneOptions, width=width, height=height, library_path_count=len(paths), library_paths=paths, declare_count=len(declares),
            declare_names=_texts(declares), declare_values=_doubles(declares.values()), wavelength_count=len(lambda_nm),
            wavelengths_nm=lambda_nm, samples=samples, max_trace_level=max_trace_level, error=error, sample_error=sample_error,
            adc_bailout=adc_bailout, polarization=_one_of("polarization", polarization, _SWITCHES), **animation)
        if include is not None:
            options.include = _callback(_IncludeCallback, lambda name, place: _include(include, name, place))
        pointer = c_void_p()
        with _Interrupts():
            outcome = _Outcome(function, self, *what, byref(options), byref(pointer))
            scene = Scene(_Handle(pointer, _lib.nicol_scene_release, self._handle)) if pointer else None
        problem = outcome.error()
        if problem is None:
            return scene
        if isinstance(problem, SceneError) and scene is not None:
            problem.diagnostics = scene.diagnostics
            problem.args = ("\n".join(diagnostic.text for diagnostic in scene.diagnostics),)
        raise problem

    def __repr__(self):
        return "<nicol.Context>" if self._handle else "<nicol.Context, closed>"


def _include(include, name, place):
    text = include(name.decode(errors="replace"))
    if text is None:
        return 0
    data = _content(text)
    _call(_lib.nicol_include_set_text, place, data, len(data))
    return 0


# ---- Scenes ----


class Scene(_Owner):
    """A scene that can be rendered. It does not change; any number of threads may use it."""

    def __init__(self, handle):
        self._handle = handle

    def _all(self, what, kind):
        count = getattr(_lib, f"nicol_scene_{what}_count")(self.open_pointer)
        return [_filled(kind, getattr(_lib, f"nicol_scene_{what}"), self, i) for i in range(count)]

    @property
    def diagnostics(self):
        """Warnings and notes (of a SceneError: errors): records with severity, file, line and column (from 1), message, text."""
        return [_plain(value, severity=_SEVERITIES[value.severity]) for value in self._all("diagnostic", _Diagnostic)]

    @property
    def files(self):
        """The files that were read, and the names of texts handed in."""
        return [_text_of(_lib.nicol_scene_file, self, i) for i in range(_lib.nicol_scene_file_count(self.open_pointer))]

    @property
    def features(self):
        """Every effect that a kernel can have: records with name, on (called for by this scene), meaning, reason."""
        return [_plain(value, on=bool(value.on)) for value in self._all("feature", _Feature)]

    @property
    def explanation(self):
        """What `nicol explain` prints."""
        return _text_of(_lib.nicol_scene_explanation, self)

    @property
    def width(self):
        """Pixels."""
        return _size(_lib.nicol_scene_size, self)[0]

    @property
    def height(self):
        """Pixels."""
        return _size(_lib.nicol_scene_size, self)[1]

    @property
    def wavelengths_nm(self):
        """(wavelengths,), ascending; before settings for an error are chosen."""
        values, count = c_void_p(), c_size_t()
        _call(_lib.nicol_scene_wavelengths, self, byref(values), byref(count))
        return _view(values.value, (count.value,), np.float64, self._handle)

    def render(self, *, precision="float", error_bound=False, error_budget=False, progress=None, tile=None, cancel=None, part=None,
               rows=None, columns=None, wavelengths_nm=None, journal=None, resume=False, lanes=0, generic=False, cache=True):
        """The picture, with the same bits as `nicol render`.

        precision: "float" or "double".        error_bound, error_budget: find out what the picture may be off by; costs some time.
        progress(fraction, seconds, seconds_left), tile(tile): called while it gets finished; what they answer is ignored. A tile has
            width, height of the picture, pixels (n,) = row * width + column, wavelengths_nm (w,), stokes (4, w, n), linear_srgb (n, 3).
        cancel(): asked between tiles; true stops, by Cancelled with the picture as far as it got.
        part: (i, n), the share i = 1..n of the pixels.   rows, columns: (first, stop), from 0.   wavelengths_nm: (first, last), those of
            the scene's in this range. Only a whole picture keeps an error, has a bound or a budget.
        journal: file that keeps finished tiles, resume: go on from it.   lanes: vector width, 0 as the device has it.
        generic: the kernel that serves all scenes.   cache=False: kernels are neither loaded from the disk nor kept there.
        """
        first_row, row_count = _span("rows", rows)
        first_column, column_count = _span("columns", columns)
        first_nm, last_nm = _pair("wavelengths_nm", wavelengths_nm, "(first, last)")
        number, count = _pair("part", part, "(i, n)")
        options = _sized(
            _RenderOptions, precision=_one_of("precision", precision, _PRECISIONS), lanes=lanes, generic=int(generic), no_cache=int(not cache),
            resume=int(resume), journal=None if journal is None else _name(journal), want_error_bound=int(error_bound),
            want_error_budget=int(error_budget), part=number, part_count=count, first_row=first_row, row_count=row_count,
            first_column=first_column, column_count=column_count, first_wavelength_nm=first_nm, last_wavelength_nm=last_nm)
        with _Interrupts() as interrupts:
            options.cancel = _callback(_CancelCallback, lambda: int(interrupts.told is not None or bool(cancel and cancel())))
            if progress is not None:
                options.progress = _callback(_ProgressCallback, _going_on(progress))
            if tile is not None:
                options.tile = _callback(_TileCallback, _going_on(lambda address: tile(_tile_at(address))))
            pointer = c_void_p()
            outcome = _Outcome(_lib.nicol_render, self, byref(options), byref(pointer))
            picture = Picture(_Handle(pointer, _lib.nicol_picture_release, self._handle)) if pointer else None
        problem = outcome.error()
        if isinstance(problem, Cancelled):
            problem.picture = picture
        if problem is not None:
            raise problem
        return picture

    def __repr__(self):
        if self._handle is None:
            return "<nicol.Scene, closed>"
        return f"<nicol.Scene {self.files[0]}: {self.width} x {self.height} pixels, {_span_text(self.wavelengths_nm)}>"


def _going_on(function):
    """The function, whatever it answers."""

    def call(*arguments):
        function(*arguments)
        return 0

    return call


def _span(name, first_and_stop):
    if first_and_stop is None:
        return 0, 0
    first, stop = _pair(name, first_and_stop, "(first, stop)")
    if not 0 <= first < stop:
        raise ValueError(f"{name}: (first, stop) from 0, with one of them at least, not {first_and_stop}")
    return first, stop - first


def _span_text(lambda_nm):
    return f"{len(lambda_nm)} wavelengths, {lambda_nm[0]:g} to {lambda_nm[-1]:g} nm" if len(lambda_nm) > 1 else f"{lambda_nm[0]:g} nm"


def _size(function, owner):
    width, height = c_int32(), c_int32()
    _call(function, owner, byref(width), byref(height))
    return width.value, height.value


def _tile_at(address):
    """A tile as copies: libnicol's own values are gone after the call."""
    told = _Tile.from_address(address)
    pixels, lambdas = told.pixel_count, told.wavelength_count
    copy = lambda place, shape, dtype: _view(place, shape, dtype, None).copy()
    return Record(width=told.width, height=told.height, pixels=copy(told.pixels, (pixels,), np.int32),
                  wavelengths_nm=copy(told.wavelengths_nm, (lambdas,), np.float64),
                  stokes=copy(told.stokes, (4, lambdas, pixels), np.float32),
                  linear_srgb=copy(told.linear_srgb, (pixels, 3), np.float32))


# ---- Pictures ----


class Picture(_Owner):
    """What was rendered or merged. Its arrays are read-only views of libnicol's memory, which they keep alive."""

    def __init__(self, handle):
        self._handle = handle

    @property
    def width(self):
        """Pixels."""
        return _size(_lib.nicol_picture_size, self)[0]

    @property
    def height(self):
        """Pixels."""
        return _size(_lib.nicol_picture_size, self)[1]

    def _spectral(self):
        lambda_nm, widths_nm, count = c_void_p(), c_void_p(), c_size_t()
        _call(_lib.nicol_picture_wavelengths, self, byref(lambda_nm), byref(widths_nm), byref(count))
        return lambda_nm.value, widths_nm.value, count.value

    @property
    def wavelengths_nm(self):
        """(wavelengths,), ascending."""
        lambda_nm, _, count = self._spectral()
        return _view(lambda_nm, (count,), np.float64, self._handle)

    @property
    def widths_nm(self):
        """(wavelengths,): the width in nm that each stands for in a sum over the spectrum."""
        _, widths_nm, count = self._spectral()
        return _view(widths_nm, (count,), np.float64, self._handle)

    def _values(self, function, *shape):
        values = c_void_p()
        _call(function, self, byref(values))
        return _view(values.value, (*shape, self.height, self.width), np.float32, self._handle)

    @property
    def stokes(self):
        """(4, wavelengths, height, width): S0 to S3, radiance per nm. What was not rendered is zero."""
        return self._values(_lib.nicol_picture_stokes, 4, self._spectral()[2])

    @property
    def xyz(self):
        """(3, height, width): CIE 1931 X, Y, Z by the 2 degree observer; Y = 1 for a light of brightness 1."""
        return self._values(_lib.nicol_picture_xyz, 3)

    @property
    def linear_srgb(self):
        """(3, height, width): linear sRGB (IEC 61966-2-1), times the scene's exposure, not clipped."""
        return self._values(_lib.nicol_picture_linear_srgb, 3)

    def plane(self, name):
        """(height, width). "coverage": 1 where rendered; "samples"; "cut_off": weight of the paths cut off, relative to a full path;
        "sample_error": estimated error of pixel sampling, RMS over wavelengths of the Stokes vector's, radiance per nm; rendered with
        error_bound, in radiance per nm: "error_cut_off", "error_sampling", "error_rounding" (with error_budget), "error_total".
        Raises UnavailableError where the picture does not have it."""
        if name not in _PLANES:
            raise ValueError(f"no plane '{name}': {', '.join(_PLANES)}")
        values = c_void_p()
        _call(_lib.nicol_picture_plane, self, _PLANES.index(name), byref(values))
        return _view(values.value, (self.height, self.width), np.float32, self._handle)

    @property
    def error_bound(self):
        """(height, width): what each pixel may be off by, radiance per nm; of pictures rendered with error_bound."""
        return self.plane("error_total")

    def degree_of_polarization(self):
        """(wavelengths, height, width): sqrt(S1^2 + S2^2 + S3^2)/S0, from 0 to 1; NaN where there is no light."""
        stokes = self.stokes
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.sqrt((stokes[1:] ** 2).sum(axis=0)) / stokes[0]

    def polarization_angle_deg(self):
        """(wavelengths, height, width): azimuth of the ellipse's long axis, counter-clockwise from x for the receiver, -90 to 90."""
        return np.degrees(np.arctan2(self.stokes[2], self.stokes[1]) / 2)

    def ellipticity_angle_deg(self):
        """(wavelengths, height, width): -45 (left circular) over 0 (linear) to 45 (right circular)."""
        stokes = self.stokes
        return np.degrees(np.arctan2(stokes[3], np.hypot(stokes[1], stokes[2])) / 2)

    def srgb(self):
        """(height, width, 3), uint8: as the .png has it, for imshow. IEC 61966-2-1; colours outside the gamut are clipped."""
        linear = np.clip(np.nan_to_num(self.linear_srgb.astype(np.float64), nan=0.0), 0, 1)
        encoded = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
        return np.ascontiguousarray(np.moveaxis(np.floor(255 * encoded + 0.5).astype(np.uint8), 0, 2))

    @property
    def report(self):
        """How it was rendered: device, seconds, segments, samples_mean, counts of the kernel, ... (nicol_report in nicol.h).
        Raises UnavailableError of a merged picture."""
        told = _filled(_Report, _lib.nicol_picture_report, self)
        flags = {name: bool(getattr(told, name)) for name in ("interrupted", "kernel_cached", "sample_error_kept")}
        return _plain(told, precision=_PRECISIONS[told.precision], **flags)

    @property
    def budget(self):
        """The error budget of a picture rendered with error_budget, else None: `rms`, of all sources together and relative to the mean
        radiance, and `lines`, each with source, rms (NaN: not known, detail says why), detail, price (what less costs), seconds."""
        count = _lib.nicol_picture_budget_count(self.open_pointer)
        if count == 0:
            return None
        rms = c_double()
        _call(_lib.nicol_picture_budget_rms, self, byref(rms))
        lines = [_plain(_filled(_BudgetLine, _lib.nicol_picture_budget_line, self, i)) for i in range(count)]
        return Record(rms=rms.value, lines=lines)

    @property
    def chosen(self):
        """The settings chosen for an error: kept, error, text, reason (why it is not kept), seconds. None where none was asked for."""
        told = _sized(_Chosen)
        outcome = _Outcome(_lib.nicol_picture_chosen, self, byref(told))
        if outcome.status == _UNAVAILABLE:
            return None
        outcome.check()
        return _plain(told, kept=bool(told.kept))

    @property
    def notes(self):
        """dict: what a file's header tells of scene, settings, device, time, error budget."""
        notes = {}
        for i in range(_lib.nicol_picture_note_count(self.open_pointer)):
            key, text = c_char_p(), c_char_p()
            _call(_lib.nicol_picture_note, self, i, byref(key), byref(text))
            notes[key.value.decode(errors="replace")] = text.value.decode(errors="replace")
        return notes

    def write(self, path):
        """.exr: wavelengths, Stokes vectors, planes. .png: colours. The file appears whole or not at all."""
        _call(_lib.nicol_picture_write, self, _name(path))

    def write_error_map(self, path):
        """The same of its error bound, as a picture."""
        _call(_lib.nicol_picture_write_error_map, self, _name(path))

    def __repr__(self):
        if self._handle is None:
            return "<nicol.Picture, closed>"
        return f"<nicol.Picture: {self.width} x {self.height} pixels, {_span_text(self.wavelengths_nm)}>"

    def _repr_png_(self):
        """Notebooks show it."""
        return None if self._handle is None else _png(self.srgb())


def _png(pixels):
    """A PNG of (height, width, 3) bytes of sRGB."""
    height, width, _ = pixels.shape
    rows = np.zeros((height, 1 + 3 * width), np.uint8)  # each begins with its filter: none
    rows[:, 1:] = pixels.reshape(height, 3 * width)
    chunk = lambda kind, data: struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"sRGB", b"\0") + chunk(b"IDAT", zlib.compress(rows.tobytes(), 3)) +
            chunk(b"IEND", b""))


# ---- Without a context of one's own ----

_default_lock = threading.Lock()
_default = None


def _default_context():
    global _default
    with _default_lock:
        if _default is None:
            _default = Context()
        return _default


def load(path, **options):
    """Context.load with the default device."""
    return _default_context().load(path, **options)


def load_text(text, name="scene.pov", **options):
    """Context.load_text with the default device."""
    return _default_context().load_text(text, name, **options)


def merge(paths, incomplete=False):
    """Context.merge; needs no device."""
    return _default_context().merge(paths, incomplete)
