# SPDX-License-Identifier: BSD-3-Clause
"""Variables of Karamelo as its parser takes them: python3 karamelo.py FILE POINTS writes bx by vx0 vy0 of each "x y t".

What Karamelo does otherwise than mathematics: a number is read in single precision; what depends on nothing is folded
to a number, which is written with 15 decimals and read again in single precision whenever an expression of it is
evaluated; a variable is replaced by its expression. A sign behind an operator or a parenthesis is taken for that of
the next number, so none may stand there. Names of variables and functions are those of this file.
"""
import math
import re
import struct
import sys

single = lambda text: struct.unpack("f", struct.pack("f", float(text)))[0]


class Var:
    def __init__(self, value, equation=None):
        self.value, self.constant = value, equation is None
        self.equation = f"{value:.15f}" if self.constant else equation

    def _with(self, other, sign, value):
        constant = self.constant and other.constant
        return Var(value, None if constant else f"({self.equation}{sign}{other.equation})")

    def __add__(self, o): return self._with(o, "+", self.value + o.value)
    def __sub__(self, o): return self._with(o, "-", self.value - o.value)
    def __mul__(self, o): return self._with(o, "*", self.value * o.value)
    def __truediv__(self, o): return self._with(o, "/", self.value / o.value if o.value else math.nan)
    def __pow__(self, o): return self._with(o, "^", self.value**o.value)
    def __lt__(self, o): return self._with(o, "<", float(self.value < o.value))
    def __le__(self, o): return self._with(o, "<=", float(self.value <= o.value))
    def __gt__(self, o): return self._with(o, ">", float(self.value > o.value))
    def __ge__(self, o): return self._with(o, ">=", float(self.value >= o.value))


def function(name):
    def call(x):
        value = getattr(math, name)(x.value)
        return Var(value, None if x.constant else f"{name}({x.equation})")
    return call


functions = {name: function(name) for name in ("sqrt", "sin", "cos")}


def parse(text, variables):
    assert not re.search(r"[-+*/^(<>=,][-+]|^[-+]|\d[eE]", text.replace("=-", "=")), text
    text = re.sub(r"(?<![\w.])(\d+(?:\.\d*)?)", r"Number('\1')", text)
    return eval(text.replace("^", "**"), {"__builtins__": {}, "Number": lambda t: Var(single(t)), **functions, **variables})


def main():
    variables = {name: Var(0.0, name) for name in ("x0", "y0", "time")}
    for line in open(sys.argv[1]):
        line = line.split("#")[0].replace(" ", "").strip()
        match = re.fullmatch(r"(\w+)=([^=].*)", line)
        if match:
            assert match[1] not in ("x", "y", "z", "time", "dt"), "is protected"
            variables[match[1]] = parse(match[2], variables)
    names = [name for name in ("bx", "by", "vx0", "vy0") if name in variables]
    for line in open(sys.argv[2]):
        now = dict(zip(("x0", "y0", "time"), map(float, line.split())))
        at = {name: Var(value, name) for name, value in now.items()}
        values = []
        for name in names:
            # a constant that was folded to a negative number stands behind a parenthesis or an operator alone
            equation = re.sub(r"([-+*/^(])-(\d[\d.]*)", r"\1(0-\2)", variables[name].equation)
            values.append(parse(equation, at).value)
        print(*map(repr, values))


main()
