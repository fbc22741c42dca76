#!/usr/bin/env python3
"""A hand at random: edits, drags, clicks, keys, sizes, without a display, while the preview must live and answer.

soak.py NICOL SCENE [--seconds N] [--seed S] [--most-mib-per-minute M] [preview options]

The scene is copied with its folder first. Exit code 0: it lived, its memory stayed flat, it ended with code 0; else 1,
and the last commands are told. The same seed tries the same things, as far as the machine is as fast.
"""

import argparse
import random
import re
import shutil
import statistics
import sys
import tempfile
import time
from collections import deque
from pathlib import Path

from preview_program import CommandFailed, Gone, Preview, write

ANSWER_S = 120         # longer than any turn, kernels being built meanwhile, in a slow build
JUDGED_S = 300         # shorter than that, memory still fills its pools
SIZE = ["-W", "160", "-H", "120"]
BUTTONS = "left", "middle", "right"
# All but those that end it (q, escape).
KEYS = ["a", "shift+a", "ctrl+a", "p", "shift+p", "ctrl+p", "n", "b", "d", "[", "]", "w", "c", "v"]
KEYS += [",", ".", "/", "-", "=", "pageup", "pagedown", "left", "right", "up", "down"]
KEYS += ["shift+left", "shift+right", "shift+up", "shift+down"]
KEYS += ["h", "tab", "r", "F5", "s", "shift+s", "e", "shift+e", "k", "ctrl+c", "space", "enter"]
KEYS += [f"{shift}{digit}" for shift in ("", "shift+") for digit in range(1, 10)]
VIEWS = ["colour", "degree", "angle", "ellipticity", "ellipses", "s1", "s2", "s3"]
LETTERS = ["{", "}", '"', "#", "0", "*/", "\0", "\u00e4"]
NUMBER = re.compile(r"(?<![\w.])\d+(?:\.\d+)?(?![\w.])")


class Hand:
    def __init__(self, chance, scene):
        self.chance, self.scene = chance, scene
        self.text = scene.read_text()
        self.widgets = []

    def place(self):
        pick = self.chance.random()
        if pick < 0.5:
            side = self.chance.choice(["left", "right"])
            return f"{side} {self.chance.uniform(-0.1, 1.1):.3f} {self.chance.uniform(-0.1, 1.1):.3f}"
        if pick < 0.6:
            return f"divider {self.chance.random():.3f}"
        if pick < 0.85 and self.widgets:
            return f'widget "{self.chance.choice(self.widgets)}"'
        return f"{self.chance.randint(-20, 1300)} {self.chance.randint(-20, 900)}"

    def drag(self):
        return f"drag {self.place()} {self.place()} {self.chance.choice(BUTTONS)}"

    def click(self):
        return f"click {self.place()} {self.chance.choice(BUTTONS)}"

    def wheel(self):
        return f"scroll {self.chance.choice([-3, -1, 1, 2])}"

    def loose_button(self):
        return f"{self.chance.choice(['press', 'release'])} {self.chance.choice(BUTTONS)}"

    def size(self):
        small = self.chance.random() < 0.15
        return f"size {self.chance.randint(1, 200 if small else 1600)} {self.chance.randint(1, 200 if small else 1000)}"

    def key(self):
        return f"key {self.chance.choice(KEYS)}"

    def pause(self):
        return f"wait {self.chance.choice([0.01, 0.05, 0.2, 0.5])}"

    def look(self):
        side = self.chance.choice(["left", "right"])
        pixel = f"pixel {side} {self.chance.randint(-9, 200)} {self.chance.randint(-9, 150)}"
        return self.chance.choice([pixel, "screenshot soak.png", "state"])

    def setting(self):
        degrees, view = str(self.chance.randint(-200, 200)), self.chance.choice(VIEWS)
        values = {"analyzer": degrees, "polarizer": degrees, "exposure": str(self.chance.randint(-12, 12)),
                  "amplification": str(self.chance.randint(0, 1000)), "divider": f"{self.chance.uniform(-1, 2):.2f}",
                  "wavelength": self.chance.choice(["none", "450", "600"]), "left": view, "right": view}
        name = self.chance.choice(list(values))
        return f"set {name} {values[name]}"

    def edit(self):
        """Changes the file itself: a number, a letter too many, half of it, nothing of it; or mends it."""
        pick, text = self.chance.random(), self.text
        numbers = list(NUMBER.finditer(text))
        if pick < 0.35 and numbers:
            at = self.chance.choice(numbers)
            value = float(at[0]) * self.chance.choice([0, 0.5, 0.9, 1.1, 2])
            text = f"{text[:at.start()]}{value:g}{text[at.end():]}"
        elif pick < 0.5:
            at = self.chance.randrange(len(text))
            text = text[:at] + self.chance.choice(LETTERS) + text[at:]
        elif pick < 0.6:
            text = text[: self.chance.randrange(len(text))]
        if self.chance.random() < 0.5:
            write(self.scene, text)
        else:
            self.scene.write_text(text)   # in place
        return f"# edit: {len(text)} characters"

    def next(self):
        acts = {self.edit: 12, self.drag: 15, self.click: 20, self.wheel: 6, self.loose_button: 3, self.size: 4,
                self.key: 25, self.pause: 12, self.look: 6, self.setting: 6}
        return self.chance.choices(list(acts), list(acts.values()))[0]()


def slope_mib_per_minute(samples):
    """Of the later half, by the median of the slopes between pairs (Theil 1950, Sen 1968)."""
    later = samples[len(samples) // 2 :]
    slopes = [(b[1] - a[1]) / (b[0] - a[0]) for i, a in enumerate(later) for b in later[i + 1 :] if b[0] > a[0]]
    return 60 * statistics.median(slopes) if slopes else 0


class Record:
    def __init__(self):
        self.done = self.refused = 0
        self.last = deque(maxlen=30)    # commands
        self.memory = []                # (seconds, MiB)

    def text(self):
        mib = [m for _, m in self.memory] or [0]
        slope = slope_mib_per_minute(self.memory)
        return (f"{self.done} commands, {self.refused} of them refused; memory {mib[0]:.0f} MiB at first, "
                f"{max(mib):.0f} at most, {mib[-1]:.0f} at last; in the later half {slope:+.2f} MiB a minute")


def do(preview, command, record):
    record.last.append(command)
    record.done += 1
    try:
        preview.do(command, ANSWER_S)
    except CommandFailed as failed:   # a widget that is not to be seen
        record.last[-1] += f"   -> {failed}"
        record.refused += 1


def soak(preview, hand, seconds, record):
    began, next_look = time.monotonic(), 0
    while (now := time.monotonic() - began) < seconds:
        do(preview, hand.next(), record)
        if now < next_look:
            continue
        state = preview.state()
        hand.widgets = list(state["widgets"])
        record.memory.append((now, state["resident_mib"]))
        next_look = now + max(0.2, seconds / 300)


def settle(preview, hand, record):
    """Everything mended: it must come to a picture of its scene again."""
    write(hand.scene, hand.text)
    for button in BUTTONS:
        do(preview, f"release {button}", record)
    for command in "size 1000 700", "key F5", "do reset":
        do(preview, command, record)

    def whole(pane):
        return pane["done"] and pane["step"] == 1 and not pane["stale"] and not pane["failure"]

    state = preview.until(lambda s: s["at_rest"] and all(map(whole, s["panes"])), "the mended scene is shown")
    for pane in state["panes"]:
        if pane["counted_errors"]:
            raise AssertionError(f"errors counted: {pane}")
    code = preview.quit()
    if code != 0:
        raise Gone(f"ended with exit code {code} at the end")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("nicol")
    parser.add_argument("scene", type=Path)
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--seed", type=int, default=int(time.time()))
    parser.add_argument("--most-mib-per-minute", type=float, default=20)
    arguments, options = parser.parse_known_args()
    print(f"soak: {arguments.seconds:g} s, seed {arguments.seed}", flush=True)
    with tempfile.TemporaryDirectory() as folder:
        for file in arguments.scene.resolve().parent.iterdir():
            if file.is_file():
                shutil.copy(file, folder)
        hand = Hand(random.Random(arguments.seed), Path(folder) / arguments.scene.name)
        record, what = Record(), ""
        with Preview(arguments.nicol, arguments.scene.name, *(options or SIZE), cwd=folder) as preview:
            try:
                preview.do("wait picture", ANSWER_S)
                soak(preview, hand, arguments.seconds, record)
                settle(preview, hand, record)
            except (Gone, AssertionError) as failed:
                what = str(failed)
            errors = preview.stderr()
    print(record.text())
    slope = slope_mib_per_minute(record.memory)
    if not what and arguments.seconds >= JUDGED_S and slope > arguments.most_mib_per_minute:
        what = f"memory grows by {slope:.2f} MiB a minute"
    if not what and errors:
        what = "words on standard error"
    if what:
        print(f"FAILED (seed {arguments.seed}): {what}\nthe last commands:")
        print("\n".join(f"  {command}" for command in record.last))
        print("standard error:\n" + errors[-8000:])
        return 1
    print("lived, answered, came to its picture again, ended with code 0")
    return 0


if __name__ == "__main__":
    sys.exit(main())
