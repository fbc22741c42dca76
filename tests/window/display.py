"""An X server of one's own without a screen (Xvfb), what stands on it, and a hand for keys and mouse (xdotool)."""

import os
import re
import shutil
import socket
import struct
import subprocess
import time
from pathlib import Path

from pictures import read_xwd


class Display:
    def __init__(self, folder, width=1400, height=800):
        for tool, package in ("Xvfb", "xvfb"), ("xdotool", "xdotool"):
            if not shutil.which(tool):
                raise AssertionError(f"this test needs {tool} (Debian's package: {package})")
        self._screen = Path(folder) / "Xvfb_screen0"
        number_read, number_written = os.pipe()
        with open(Path(folder) / "xvfb.txt", "wb") as log:
            command = ["Xvfb", "-displayfd", number_written, "-screen", 0, f"{width}x{height}x24", "-fbdir", folder]
            self._server = subprocess.Popen([*map(str, command), "-nolisten", "tcp", "-noreset"],
                                            pass_fds=[number_written], stdout=log, stderr=log)
        os.close(number_written)
        with os.fdopen(number_read) as number:
            self.number = number.readline().strip()
        if not self.number:
            raise AssertionError("Xvfb does not start: " + (Path(folder) / "xvfb.txt").read_text())
        self.environment = {name: value for name, value in os.environ.items() if name != "WAYLAND_DISPLAY"}
        self.environment["DISPLAY"] = f":{self.number}"

    def close(self):
        self._server.terminate()
        self._server.wait()

    def screen(self):
        return read_xwd(self._screen)

    def hand(self, *words):
        """xdotool; what it prints."""
        result = subprocess.run(["xdotool", *map(str, words)], env=self.environment, capture_output=True, text=True,
                                timeout=60, check=False)
        return result.stdout

    def window(self, title):
        """Number of the visible window with that title, if there is one."""
        found = self.hand("search", "--onlyvisible", "--name", f"^{re.escape(title)}$").split()
        return int(found[0]) if found else None

    def key(self, name, times=1):
        for _ in range(times):
            self.hand("key", name)

    def drag(self, start, end, steps=8):
        self.hand("mousemove", *start)
        time.sleep(0.05)
        self.hand("mousedown", 1)
        for step in range(1, steps + 1):
            time.sleep(0.03)
            self.hand("mousemove", *(round(a + (b - a) * step / steps) for a, b in zip(start, end)))
        time.sleep(0.05)
        self.hand("mouseup", 1)

    def ask_to_close(self, window):
        """As a window manager does: WM_DELETE_WINDOW (ICCCM 4.2.8.1), in the X protocol's own bytes."""
        with socket.socket(socket.AF_UNIX) as server:
            server.settimeout(60)
            server.connect(f"/tmp/.X11-unix/X{self.number}")
            server.sendall(struct.pack("<BxHHHHxx", ord("l"), 11, 0, 0, 0))
            accepted, length = struct.unpack("<BxxxxxH", _exactly(server, 8))
            _exactly(server, 4 * length)
            assert accepted == 1, "the X server refuses"
            protocols, delete = _atom(server, b"WM_PROTOCOLS"), _atom(server, b"WM_DELETE_WINDOW")
            event = struct.pack("<BBHII5I", 33, 32, 0, window, protocols, delete, 0, 0, 0, 0)
            server.sendall(struct.pack("<BBHII", 25, 0, 11, window, 0) + event)
            _atom(server, b"WM_PROTOCOLS")   # its answer comes after the event is sent


def _exactly(server, count):
    data = b""
    while len(data) < count:
        more = server.recv(count - len(data))
        assert more, "the X server has gone"
        data += more
    return data


def _atom(server, name):
    padded = name + bytes(-len(name) % 4)
    server.sendall(struct.pack("<BBHHxx", 16, 0, 2 + len(padded) // 4, len(name)) + padded)
    reply = _exactly(server, 32)
    assert reply[0] == 1, "InternAtom failed"
    return struct.unpack("<I", reply[8:12])[0]
