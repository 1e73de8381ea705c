# SPDX-License-Identifier: BSD-3-Clause
"""Functions of NairnMPM as its parser takes them: python3 nairn.py POINTS FUNCTION... writes their values of each "x y t".

A sign may stand at the beginning of an expression or a group alone; sign(x) is 1 above 0 and else 0; powers are ^.
"""
import math
import re
import sys

words = {"__builtins__": {}, "sqrt": math.sqrt, "sign": lambda x: float(x > 0)}
functions = []
for text in sys.argv[2:]:
    assert not re.search(r"[-+*/^,][-+*/^,)]|\([*/^,)]", re.sub(r"(\d)e-", r"\1e", text)), text
    assert not set(re.findall(r"[A-Za-z_]+", re.sub(r"\de-?\d", "", text))) - {"x", "y", "t", "sqrt", "sign"}, text
    assert not set("<>&") & set(text), "means something else in XML"
    functions.append(compile(text.replace("^", "**"), "function", "eval"))
for line in open(sys.argv[1]):
    now = dict(zip("xyt", map(float, line.split())))
    print(*(repr(eval(function, words, now)) for function in functions))
