"""Pictures that tests look at: PNG files and the screen of an X server, with nothing but Python."""

import struct
import zlib
from pathlib import Path


class Picture:
    """Rows of 8-bit colours in `data`: `stride` bytes a row, `step` bytes a pixel, R, G, B at `offsets` in it."""

    def __init__(self, width, height, data, stride, step, offsets, first=0):
        self.width, self.height = width, height
        self._data, self._stride, self._step, self._offsets, self._first = data, stride, step, offsets, first

    def values(self, left, top, right, bottom):
        """Of R, G, B each: the bytes of the pixels left <= x < right, top <= y < bottom."""
        left, top, right, bottom = (round(v) for v in (left, top, right, bottom))
        assert 0 <= left < right <= self.width and 0 <= top < bottom <= self.height, (left, top, right, bottom)
        channels = [bytearray() for _ in range(3)]
        for y in range(top, bottom):
            row = self._first + y * self._stride
            for channel, offset in zip(channels, self._offsets):
                channel += self._data[row + left * self._step + offset : row + right * self._step : self._step]
        return channels

    def mean(self, left, top, right, bottom):
        return [sum(channel) / len(channel) for channel in self.values(left, top, right, bottom)]

    def brightest(self, left, top, right, bottom):
        return max(max(channel) for channel in self.values(left, top, right, bottom))

    def part(self, rectangle, left, top, right, bottom):
        """The mean of a part (0..1) of a rectangle {x, y, width, height}."""
        x, y, width, height = (rectangle[name] for name in ("x", "y", "width", "height"))
        return self.mean(x + left * width, y + top * height, x + right * width, y + bottom * height)

    def whole(self):
        return {"x": 0, "y": 0, "width": self.width, "height": self.height}


def _paeth(row, above, step):
    for i in range(step):
        row[i] = (row[i] + above[i]) & 255
    for i in range(step, len(row)):
        left, up, corner = row[i - step], above[i], above[i - step]
        to_left, to_up, to_corner = abs(up - corner), abs(left - corner), abs(left + up - 2 * corner)
        guess = left if to_left <= to_up and to_left <= to_corner else up if to_up <= to_corner else corner
        row[i] = (row[i] + guess) & 255


def _unfiltered(raw, height, stride, step):
    """Filters of the PNG specification, 9.2: none, sub, up, average, Paeth."""
    rows, above = [], bytes(stride)
    for y in range(height):
        start = y * (stride + 1)
        kind, row = raw[start], bytearray(raw[start + 1 : start + 1 + stride])
        if kind == 1:
            for i in range(step, stride):
                row[i] = (row[i] + row[i - step]) & 255
        elif kind == 2:
            row = bytearray((a + b) & 255 for a, b in zip(row, above))
        elif kind == 3:
            for i in range(stride):
                row[i] = (row[i] + ((row[i - step] if i >= step else 0) + above[i]) // 2) & 255
        elif kind == 4:
            _paeth(row, above, step)
        rows.append(bytes(row))
        above = row
    return b"".join(rows)


def read_png(path):
    """RGB or RGBA of 8 or 16 bits; raises AssertionError if a chunk is damaged."""
    data = Path(path).read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n", f"{path} is no PNG"
    at, packed, kind = 8, b"", b""
    while kind != b"IEND":
        length, kind = struct.unpack(">I4s", data[at : at + 8])
        body = data[at + 8 : at + 8 + length]
        assert struct.unpack(">I", data[at + 8 + length : at + 12 + length])[0] == zlib.crc32(kind + body), kind
        if kind == b"IHDR":
            width, height, depth, colour, _, _, interlaced = struct.unpack(">IIBBBBB", body)
        if kind == b"IDAT":
            packed += body
        at += 12 + length
    assert depth in (8, 16) and colour in (2, 6) and not interlaced, (depth, colour, interlaced)
    size = depth // 8
    step = {2: 3, 6: 4}[colour] * size
    rows = _unfiltered(zlib.decompress(packed), height, width * step, step)
    return Picture(width, height, rows, width * step, step, (0, size, 2 * size))


def read_xwd(path):
    """A window dump (X11/XWDFile.h) of a true-colour screen with 32 bits a pixel."""
    data = Path(path).read_bytes()
    header = struct.unpack(">25I", data[:100])
    (size, version, kind, _, width, height, _, byte_order, _, _, _, bits, stride, _, red, green, blue) = header[:17]
    assert version == 7 and kind == 2 and bits == 32, header
    first = size + 12 * header[19]
    place = {0xFF: 0, 0xFF00: 1, 0xFF0000: 2}
    offsets = [place[mask] if byte_order == 0 else 3 - place[mask] for mask in (red, green, blue)]
    return Picture(width, height, data, stride, 4, offsets, first)
