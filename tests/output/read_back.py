"""Reads an EXR that nicol wrote with other people's eyes: Debian's exrheader for the header of a packed
file, and the published file layout (openexr.com, "OpenEXR File Layout") for the values of an unpacked one."""
import re
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

WIDTH, HEIGHT = 7, 5
WAVELENGTHS = ["400,000000", "580,000000", "633,200000"]
PIXEL_BYTES = {0: ("I", 4), 1: ("e", 2), 2: ("f", 4)}


def text_until_zero(data, at):
    end = data.index(b"\0", at)
    return data[at:end].decode(), end + 1


def attributes(data):
    """Name -> (type, bytes), and the place after the header."""
    magic, version = struct.unpack_from("<II", data)
    assert magic == 20000630 and version & 0xFF == 2, "magic number and version"
    assert version & 0x1A00 == 0, "one part of scan lines"
    found, at = {}, 8
    while data[at]:
        name, at = text_until_zero(data, at)
        kind, at = text_until_zero(data, at)
        (size,) = struct.unpack_from("<i", data, at)
        found[name] = (kind, data[at + 4 : at + 4 + size])
        at += 4 + size
    return found, at + 1


def channels(block):
    names, at = [], 0
    while block[at]:
        name, at = text_until_zero(block, at)
        names.append((name, struct.unpack_from("<i", block, at)[0]))
        at += 16
    return names


def pixels(data):
    """Channel -> rows of values, of a file without packing."""
    header, at = attributes(data)
    assert header["compression"][1] == b"\0" and header["lineOrder"][1] == b"\0"
    assert struct.unpack("<4i", header["dataWindow"][1]) == (0, 0, WIDTH - 1, HEIGHT - 1)
    layout = channels(header["channels"][1])
    assert [name for name, _ in layout] == sorted(name for name, _ in layout)
    values = {name: [] for name, _ in layout}
    for place in struct.unpack_from(f"<{HEIGHT}Q", data, at):
        y, size = struct.unpack_from("<ii", data, place)
        assert y == len(values[layout[0][0]]), "rows from the top"
        place += 8
        for name, kind in layout:
            letter, width = PIXEL_BYTES[kind]
            values[name].append(struct.unpack_from(f"<{WIDTH}{letter}", data, place))
            place += WIDTH * width
            size -= WIDTH * width
        assert size == 0
    return values


def check_values(data):
    values = pixels(data)
    stokes = {f"S{s}.{w}nm": 64 * s + 8 * i for s in range(4) for i, w in enumerate(WAVELENGTHS)}
    assert set(values) == set(stokes) | {"R", "G", "B", "cutoff"}
    for y in range(HEIGHT):
        for x in range(WIDTH):
            assert values["cutoff"][y][x] == x + y / 8
            for name, start in stokes.items():
                assert values[name][y][x] == start + x / 16 + y / 256, (name, x, y)


def check_header(text):
    for name in [f"S{s}.{w}nm" for s in range(4) for w in WAVELENGTHS] + ["R", "G", "B", "cutoff"]:
        assert f"    {name}, 32-bit floating-point, sampling 1 1" in text, name
    for line in ['spectralLayoutVersion (type string): "1.0"', 'emissiveUnits (type string): "W.m^-2.sr^-1"',
                 'polarisationHandedness (type string): "right"', 'nicol:scene (type string): "scenes/a b.pov"',
                 'nicol:partial (type string): "3 of 5 rows"', "compression (type compression): piz",
                 "pixelAspectRatio (type float): 1"]:
        assert line in text, line
    assert re.search(r"red +\(0\.64 0\.33\)\s+green \(0\.3 0\.6\)\s+blue +\(0\.15 0\.06\)\s+white \(0\.3127 0\.329\)", text)


def main(write_pattern):
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "a.exr")
        subprocess.run([write_pattern, path, "none"], check=True, stdout=subprocess.DEVNULL)
        check_values(path.read_bytes())
        subprocess.run([write_pattern, path, "rows=3"], check=True, stdout=subprocess.DEVNULL)
        check_header(subprocess.run(["exrheader", path], check=True, capture_output=True, text=True).stdout)


main(sys.argv[1])
