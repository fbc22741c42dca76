"""`nicol preview` driven by its script, one command after the other; and scenes to preview."""

import json
import os
import select
import shutil
import subprocess
import time
from pathlib import Path

SCENES = Path(__file__).resolve().parents[2] / "scenes"
PATIENCE_S = 300


class CommandFailed(Exception):
    """The program answered "error: ..."."""


class Gone(Exception):
    """The program ended, or answers no longer."""


def copy_scene(folder, name="fig5_active.pov"):
    """A scene of scenes/founding with what it includes, to be changed; its path."""
    for file in name, "founding.inc":
        shutil.copy(SCENES / "founding" / file, folder)
    return Path(folder) / name


def write(path, text):
    """As editors do: a new file takes the old one's name."""
    fresh = Path(f"{path}.new")
    fresh.write_text(text)
    fresh.replace(path)


def change(path, old, new):
    text = Path(path).read_text()
    assert text.count(old) == 1, f"{old!r} stands {text.count(old)} times in {path}"
    write(path, text.replace(old, new))


def without_display():
    return {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}


class Preview:
    def __init__(self, nicol, *arguments, cwd):
        self._errors = open(Path(cwd) / "stderr.txt", "w+b")
        self._process = subprocess.Popen([nicol, "preview", *map(str, arguments), "--script", "-"], cwd=cwd,
                                         env=without_display(), stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                         stderr=self._errors)
        self.pid = self._process.pid
        self._unread = b""

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._process.kill()
        self._process.wait()
        for stream in self._process.stdin, self._process.stdout, self._errors:
            try:
                stream.close()
            except BrokenPipeError:
                pass

    def _line(self, deadline):
        while b"\n" not in self._unread:
            left = deadline - time.monotonic()
            if left <= 0 or not select.select([self._process.stdout], [], [], left)[0]:
                raise Gone("no answer in time")
            more = os.read(self._process.stdout.fileno(), 1 << 16)
            if not more:
                raise Gone(f"ended with exit code {self._process.wait(PATIENCE_S)}")
            self._unread += more
        line, self._unread = self._unread.split(b"\n", 1)
        return line.decode()

    def do(self, command, patience_s=PATIENCE_S):
        """The lines that a command prints. CommandFailed: its "error: ..."; Gone: no answer, or the end."""
        try:
            self._process.stdin.write(command.encode() + b"\n")
            self._process.stdin.flush()
        except BrokenPipeError:
            raise Gone(f"{command!r}: ended with exit code {self._process.wait(PATIENCE_S)}") from None
        answers, deadline = [], time.monotonic() + patience_s
        while True:
            try:
                line = self._line(deadline)
            except Gone as gone:
                raise Gone(f"{command!r}: {gone}") from None
            if line == "ok":
                return answers
            if line.startswith("error: "):
                raise CommandFailed(line[7:])
            answers.append(line)

    def run(self, *commands):
        for command in commands:
            self.do(command)

    def state(self):
        return json.loads(self.do("state")[0])

    def pane(self, number=0):
        return self.state()["panes"][number]

    def pixel(self, side, x, y):
        return json.loads(self.do(f"pixel {side} {x} {y}")[0])

    def until(self, holds, what):
        """Turns go on until the state is so."""
        deadline = time.monotonic() + PATIENCE_S
        while not holds(state := self.state()):
            if time.monotonic() > deadline:
                raise AssertionError(f"waited in vain until {what}: {json.dumps(state)[:3000]}")
            self.do("wait 0.05")
        return state

    def stderr(self):
        self._errors.flush()
        return (Path(self._errors.name)).read_text(errors="replace")

    def quit(self):
        """Its exit code."""
        self.do("quit")
        self._process.stdin.close()
        return self._process.wait(PATIENCE_S)
