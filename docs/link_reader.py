#!/usr/bin/env python3
"""Reads evenlift's share links, as docs/link-format.md describes them; no dependencies.

    python3 link_reader.py LINK...      prints what each link holds, as JSON; the text of a lesson

A second reader, written from the description and not from the program, so that each checks the
other. It reads any good link of versions 1 and 2; unlike the program it does not look for links that no
program writes.
"""

import json
import pathlib
import struct
import sys

ALPHABET = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_"
METRICS = ["area", "circle", "distance", "distributed", "random"]
OVERLAYS = ["candidates", "chords", "hull", "clockwise", "counterclockwise", "tipping"]
# What a record's payload is read as, by its tag; the other tags are those of later programs.
RECORDS = {1: ("robots", int), 2: ("goal", str), 3: ("min_margin", float), 4: ("apart", float), 5: ("survive", int),
           6: ("positions", str), 7: ("com_radius", float), 8: ("capacity", float), 9: ("robot", str), 10: ("no_go", str),
           11: ("units", str), 12: ("cargo", str), 13: ("holes", list), 17: ("support_capacities", str), 39: ("support_names", str), 18: ("halo", str), 19: ("moved", str), 20: ("clear", float), 30: ("accuracy", float),
           21: ("supports", list), 22: ("snap", float), 15: ("com_height", float), 23: ("slope", float),
           24: ("acceleration", float), 25: ("give", float), 26: ("uneven", float), 27: ("extra", float), 28: ("tilt", str),
           29: ("load", str), 31: ("readings", str), 32: ("reading_error", str), 33: ("level_error", float),
           34: ("readings_tilted", str), 35: ("tilted", float), 36: ("heading", str), 37: ("dynamic", float),
           38: ("weight_doubt", float)}
DOUBLES = 23  # the scale that numbers every double


class LinkError(Exception):
    pass


# --- Characters and checksum ---------------------------------------------------------------------


def crc24(text):
    crc = 0xB704CE
    for byte in text.encode("ascii"):
        crc ^= byte << 16
        for _ in range(8):
            crc <<= 1
            if crc & 0x1000000:
                crc ^= 0x1864CFB
    return crc


def digits_of(text):
    if any(c not in ALPHABET for c in text):
        raise LinkError("a character that no link has")
    return [ALPHABET.index(c) for c in text]


# --- Coder ---------------------------------------------------------------------------------------


class Coder:
    def __init__(self, digits):
        self.digits = digits
        self.position = 0
        self.range = 1 << 30
        self.code = 0
        for _ in range(5):
            self.code = self.code * 64 + self.next_digit()

    def next_digit(self):
        self.position += 1
        if self.position <= len(self.digits):
            return self.digits[self.position - 1]
        if self.position > len(self.digits) + 5:
            raise LinkError("the link ends too early")
        return 0

    def narrow(self, offset, size):
        self.code -= offset
        self.range = size
        while self.range <= 1 << 24:
            self.code = self.code * 64 + self.next_digit()
            self.range *= 64

    def uniform(self, count):
        unit = self.range // count
        value = self.code // unit
        if value >= count:
            raise LinkError("a value that no writer makes")
        self.narrow(value * unit, unit)
        return value

    def bit(self, model):
        part = self.range // (model[0] + model[1]) * model[0]
        value = int(self.code >= part)
        if value:
            self.narrow(part, self.range - part)
        else:
            self.narrow(0, part)
        model[value] += 2
        if model[0] + model[1] > 255:
            model[0] = (model[0] + 1) // 2
            model[1] = (model[1] + 1) // 2
        return value

    def bits(self, count):
        value = 0
        while count > 0:
            part = min(count, 12)
            count -= part
            value = value << part | self.uniform(1 << part)
        return value

    def integer(self, widest):
        width = self.uniform(widest + 1)
        return 0 if width == 0 else 1 << (width - 1) | self.bits(width - 1)

    def up_to(self, greatest):
        low = max(greatest.bit_length() - 12, 0)
        high = self.uniform((greatest >> low) + 1)
        return high << low | self.bits(low)


# --- Numbers -------------------------------------------------------------------------------------


def double_of_bits(bits):
    return struct.unpack("<d", struct.pack("<Q", bits))[0]


def value_on_scale(kind, zero_bits, number):
    if kind < DOUBLES:
        return number / 10**kind  # Python rounds this once, as the format wants
    sign, size = (1 << 63, ~number) if number < 0 else (0, number)
    return double_of_bits(sign | size << zero_bits)


def lone_number(coder):
    kind = coder.uniform(24)
    if kind == DOUBLES:
        return double_of_bits(coder.bits(64))
    negative = coder.uniform(2)
    size = coder.integer(51)
    return value_on_scale(kind, 0, -size if negative else size)


# --- Settings ------------------------------------------------------------------------------------


def read_settings(coder):
    settings = {
        "teams": 3,
        "metric": "area",
        "min_ratio": 0.8,
        "weight": 100.0,
        "seed": 1,
        "overlays": ["chords", "hull", "clockwise", "counterclockwise"],
        "step": None,
    }
    if not coder.bit([15, 1]):
        return settings
    if coder.uniform(2):
        settings["teams"] = "max" if coder.uniform(2) else coder.integer(21)
    if coder.uniform(2):
        settings["metric"] = METRICS[1 + coder.uniform(4)]
    if coder.uniform(2):
        settings["min_ratio"] = lone_number(coder)
    if coder.uniform(2):
        settings["weight"] = lone_number(coder)
    if coder.uniform(2):
        settings["seed"] = coder.integer(64)
    if coder.uniform(2):
        mask = coder.uniform(32)
        if mask == 30:  # the usual ones: tipping besides what follows
            mask = coder.uniform(32) | 32
        settings["overlays"] = [name for i, name in enumerate(OVERLAYS) if mask >> i & 1]
    if coder.uniform(2):
        settings["step"] = coder.integer(32)
    return settings


def read_supports(coder):
    count = coder.integer(10)
    if not 1 <= count <= 1000:
        raise LinkError("a number of supports that no writer makes")
    return read_vertices(coder, count)[0]


def read_holes(coder):
    count = coder.integer(10)
    if not 1 <= count <= 1000:
        raise LinkError("a number of holes that no writer makes")
    sizes = [coder.integer(16) for _ in range(count)]
    if min(sizes) == 0 or sum(sizes) > 32768:
        raise LinkError("a number of vertices that no writer makes")
    vertices = iter(read_vertices(coder, sum(sizes))[0])
    return [[next(vertices) for _ in range(size)] for size in sizes]


def read_records(coder, settings):
    """What came with version 2: each setting as its text; supports and holes as their coordinates."""
    while tag := coder.integer(8):
        if tag not in RECORDS:
            raise LinkError(f"the link was made by a newer evenlift: record {tag}")
        if tag == 21:  # coordinates, not a text
            settings["supports"] = read_supports(coder)
            settings["metric"] = "given"
            continue
        if tag == 13:
            settings["holes"] = read_holes(coder)
            continue
        length = coder.integer(20)
        if length > {9: 160, 10: 64000, 12: 322000, 17: 32000, 19: 64000, 31: 32000, 34: 32000, 36: 64, 39: 243000}.get(tag, 32):
            raise LinkError("a record that is too long")
        text = bytes(coder.uniform(256) for _ in range(length)).decode("utf-8" if tag in (12, 39) else "ascii", "strict")
        name, kind = RECORDS[tag]
        try:
            settings[name] = kind(text)
        except ValueError as error:
            raise LinkError(f"{name}: {text}") from error
        if name == "robots":
            settings["metric"] = "balanced"
        if name == "halo":  # an overlay, which comes last
            if settings.pop("halo") != "shown":
                raise LinkError(f"halo: {text}")
            settings["overlays"] = settings["overlays"] + ["halo"]


# --- Vertices ------------------------------------------------------------------------------------


def wrap(number):
    """To a signed 64-bit integer."""
    number &= (1 << 64) - 1
    return number - (1 << 64) if number >> 63 else number


def predict(predictor, numbers):
    """From the numbers before on the same axis."""
    if not numbers or predictor == 0:
        return 0
    if predictor == 2 and len(numbers) >= 2:
        return 2 * numbers[-1] - numbers[-2]
    if predictor == 3 and len(numbers) >= 5:
        return numbers[-1] + numbers[-4] - numbers[-5]
    return numbers[-1]


class Residuals:
    def __init__(self, coder, exponents, fraction_bits, greatest, negatives):
        self.coder = coder
        self.exponents = exponents
        self.fraction_bits = fraction_bits
        self.greatest = greatest
        self.negatives = negatives
        self.zero_models = [[6, 1] for _ in range(4)]
        self.class_models = [[2, 2] for _ in range(16)]
        self.high_bit_models = [[8, 8] for _ in range(16)]
        self.sign_models = [[4, 4] for _ in range(3)]
        self.zeros_before = 0
        self.sign_before = [0, 0]

    def read_class(self):
        for step in range(16):
            asked = self.greatest - step
            if asked == 1 or self.coder.bit(self.class_models[step]):
                return asked
        return 1 + self.coder.uniform(self.greatest - 16)

    def read(self, axis):
        if self.greatest == 0:
            return 0
        zero = self.coder.bit(self.zero_models[self.zeros_before])
        self.zeros_before = (self.zeros_before << 1 | zero) & 3
        if zero:
            self.sign_before[axis] = 0
            return 0
        size_class = self.read_class()
        place_bits = self.fraction_bits if self.exponents else size_class - 1
        place = 0
        if place_bits > 0:
            below = min(self.greatest - size_class, 15)
            high = self.coder.bit(self.high_bit_models[below])
            place = high << (place_bits - 1) | self.coder.bits(place_bits - 1)
        negative = 0
        if self.negatives:
            negative = self.coder.bit(self.sign_models[self.sign_before[axis]])
        self.sign_before[axis] = 2 if negative else 1
        if self.exponents:
            size = (size_class - 1) << self.fraction_bits | place
            return ~size if negative else size
        size = 1 << (size_class - 1) | place
        return -size if negative else size


def read_vertices(coder, count):
    """The vertices; their numbers, without those of escaped coordinates; the scale and its zero bits."""
    kind = 0 if coder.uniform(2) else 1 + coder.uniform(23)
    zero_bits = coder.uniform(53) if kind == DOUBLES else 0
    predictor = coder.uniform(4)
    escapes_possible = coder.bit([7, 1]) if kind < DOUBLES else 0
    exponents = kind == DOUBLES and predictor == 0
    greatest = coder.uniform(2048 if exponents else 65)
    negatives = coder.uniform(2) if greatest > 0 else 0
    residuals = Residuals(coder, exponents, 52 - zero_bits, greatest, negatives)

    escape_model = [6, 1]
    numbers = ([], [])
    on_scale = ([], [])
    vertices = []
    for i in range(count):
        vertex = []
        for axis in (0, 1):
            prediction = wrap(predict(predictor, numbers[axis]))
            if escapes_possible and coder.bit(escape_model):
                numbers[axis].append(prediction)
                vertex.append(double_of_bits(coder.bits(64)))
                continue
            if i == 0 and predictor != 0:
                number = coder.integer(64)
                if number and coder.uniform(2):
                    number = -number
            else:
                number = prediction + residuals.read(axis)
            number = wrap(number)
            numbers[axis].append(number)
            on_scale[axis].append(number)
            vertex.append(value_on_scale(kind, zero_bits, number))
        vertices.append(vertex)
    return vertices, on_scale, kind, zero_bits


def read_centre(coder, on_scale, kind, zero_bits):
    boxed = all(on_scale)
    if boxed and not coder.bit([3, 1]):
        centre = []
        for axis in (0, 1):
            low, high = min(on_scale[axis]), max(on_scale[axis])
            centre.append(value_on_scale(kind, zero_bits, low + coder.up_to(high - low)))
        return centre
    return [lone_number(coder), lone_number(coder)]


# --- The whole -----------------------------------------------------------------------------------


def checked_digits(link):
    """The digits of a link's payload, after a look at its checksum."""
    digits = digits_of(link.partition(".")[2])
    if len(digits) < 4:
        raise LinkError("the link is cut off")
    checksum = 0
    for digit in digits[-4:]:
        checksum = checksum * 64 + digit
    if checksum != crc24(link[:-4]):
        raise LinkError("the link was cut off or altered")
    return digits[:-4]


def read_link(link):
    version, point, _ = link.partition(".")
    if not point or not version.isdigit():
        raise LinkError("a link begins with its version and a full stop")
    if version not in ("1", "2"):
        raise LinkError("only versions 1 and 2 are known here")
    coder = Coder(checked_digits(link))
    settings = read_settings(coder)
    count = coder.integer(16)
    if count > 32768:
        raise LinkError("too many vertices")
    vertices, on_scale, kind, zero_bits = [], ([], []), 0, 0
    if count > 0:
        vertices, on_scale, kind, zero_bits = read_vertices(coder, count)
    centre = read_centre(coder, on_scale, kind, zero_bits) if coder.uniform(2) else None
    if version == "2":
        read_records(coder, settings)
    return {"vertices": vertices, "centre_of_mass": centre, "settings": settings}


# --- Lessons -------------------------------------------------------------------------------------


class Predictor:
    """The bits of a text, each by what followed the last three bytes, or the last one."""

    def __init__(self):
        self.models = {}
        self.last_three = 0

    def byte(self, bit):
        """The next byte, where bit(model) gives its next bit."""
        node = 1
        while node < 256:
            near = self.models.setdefault((1, self.last_three & 0xFF, node), [1, 1])
            far = self.models.setdefault((3, self.last_three, node), [1, 1])
            value = bit(list(near if sum(far) == 2 else far))
            for model in (near, far):
                model[value] += 8
                if sum(model) > 255:
                    model[:] = [(count + 1) // 2 for count in model]
            node = 2 * node + value
        self.last_three = (self.last_three << 8 | node & 0xFF) & 0xFFFFFF
        return node & 0xFF


def read_lesson_link(link):
    """The bytes of a lesson's text."""
    if not link.startswith("L1."):
        raise LinkError("only version L1 is known here")
    coder = Coder(checked_digits(link))
    length = coder.integer(17)
    if length > 65536:
        raise LinkError("the lesson is too long")
    predictor = Predictor()
    primer = pathlib.Path(__file__).with_name("lesson-primer.txt").read_bytes()
    for byte in primer:
        bits = iter([byte >> shift & 1 for shift in range(7, -1, -1)])
        predictor.byte(lambda model: next(bits))
    return bytes(predictor.byte(coder.bit) for _ in range(length))


def main():
    for link in sys.argv[1:]:
        if link.startswith("L"):
            print(read_lesson_link(link).decode("utf-8"))
        else:
            print(json.dumps(read_link(link)))


if __name__ == "__main__":
    main()
