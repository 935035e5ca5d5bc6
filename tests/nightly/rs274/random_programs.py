# SPDX-License-Identifier: GPL-3.0-or-later
"""Random modal programs in RS274/NGC, each from a seed: program(seed) is the same text everywhere."""
import random

MILL = ["G73", "G74", "G81", "G82", "G83", "G84", "G85", "G86", "G88", "G89"]


def half(r, low, high):
    """A number with steps of a half, as a word has it."""
    value = r.randint(int(low * 2), int(high * 2)) / 2
    return f"{value:g}"


def header(r):
    """Modes that every program of a CAM system states, some of them left out now and then."""
    words = ["G21" if r.random() < 0.8 else "G20"]
    words += [w for w, p in (("G17", 0.8), ("G90", 0.8), ("G94", 0.5), ("G40", 0.4), ("G80", 0.4),
                             ("G49", 0.3), ("G54", 0.4), ("G64", 0.2), ("G91.1", 0.2)) if r.random() < p]
    lines = [" ".join(words), f"T{r.randint(1, 3)} M6", "M3 S1000", f"F{r.choice([100, 250, 400])}",
             f"G0 X{half(r, -5, 5)} Y{half(r, -5, 5)} Z{half(r, 5, 15)}"]
    if r.random() < 0.1:
        lines.pop(1)
    return lines


def cycles(r):
    lines = header(r)
    if r.random() < 0.3:
        lines.append(r.choice(["G18", "G19"]))
    for _ in range(r.randint(1, 3)):
        code = r.choice(MILL)
        depth = {"G18": "Y", "G19": "X"}.get(lines[5] if len(lines) > 5 else "", "Z")
        plane = [c for c in "XYZ" if c != depth]
        if r.random() < 0.3:
            lines.append(r.choice(["G90", "G91"]))
        for hole in range(r.randint(1, 4)):
            words = [code] if hole == 0 or r.random() < 0.3 else []
            if r.random() < 0.25:
                words.insert(0, r.choice(["G98", "G99"]))
            if r.random() < 0.1:
                words.insert(0, r.choice(["G90", "G91"]))
            first = hole == 0
            words += [f"{a}{half(r, -20, 20)}" for a in plane if r.random() < 0.7]
            if first or r.random() < 0.3:
                words.append(f"{depth}{half(r, -8, 0)}")
            if first or r.random() < 0.4:
                words.append(f"R{half(r, 0, 8)}")
            if code in ("G73", "G83") and (first or r.random() < 0.2):
                words.append(f"Q{half(r, 0.5, 3)}")
            if code in ("G82", "G86", "G88", "G89") and (first or r.random() < 0.2):
                words.append("P0.5")
            if r.random() < 0.2:
                words.append(f"L{r.randint(1, 3)}")
            lines.append(" ".join(words))
            if r.random() < 0.1:
                lines.append(r.choice(["G98", "G99", "M3", "F200", "G0 Z12", "G4 P1", "(between)"]))
        if r.random() < 0.5:
            lines.append("G80")
            if r.random() < 0.6:
                lines.append(f"G0 X{half(r, -9, 9)} Z{half(r, 5, 15)}")
    return lines


def contour(r, lines, count, arcs=0.3, extra=0.15):
    """Lines and arcs of some length in the plane X Y, in G90 or G91."""
    x = y = 0.0
    incremental = False
    for i in range(count):
        if r.random() < extra:
            lines.append(r.choice(["G17", "G21", "G90", "G91", "G4 P1", "M8", "S1200", "F300", "G0 Z3", "G1 Z-1",
                                   "M0", "(note)", "G54", "G64", "N100", "G98", "M1", "G49", "G40"]
                                  if r.random() < 0.7 else
                                  ["G20", "G18", "G53 G0 Z1", "G28", "G10 L2 P1 X1", "G92 X3", "T2 M6",
                                   "G43 H1", "G81 X1 Y1 Z-1 R1", "G41 D2", "G42 D1", "G61", "G38.2 Z-3", "G55",
                                   "G94", "G33 Z1 K1", "M70", "#1=#5420", "G5.1 X3 I1 J1", "M9", "M5"]))
            if lines[-1] in ("G90", "G91"):
                incremental = lines[-1] == "G91"
        dx, dy = r.choice([-1, 0, 1]) * r.randint(4, 30), r.choice([-1, 0, 1]) * r.randint(4, 30)
        if dx == dy == 0:
            dx = 10
        nx, ny = x + dx, y + dy
        if r.random() < arcs:
            words = [r.choice(["G2", "G3"])]
            centre = [f"I{dx / 2:g}", f"J{dy / 2:g}"]
            if r.random() < 0.3:
                radius = max(abs(dx), abs(dy)) + r.choice([0.5, 3, 10])
                centre = [f"R{r.choice([1, 1, 1, -1]) * radius:g}"]
        else:
            words, centre = [r.choice(["G1", "G1", "G1", "G0", ""])], []
            if not words[0] and i == 0:
                words = ["G1"]
        place = (dx, dy) if incremental else (nx, ny)
        words += [f"{a}{v:g}" for a, v in zip("XY", place) if v != (0 if incremental else (x, y)["XY".index(a)])]
        if r.random() < 0.15:
            words.append(f"Z{half(r, -3, 3)}")
        if r.random() < 0.05:
            words.insert(0, r.choice(["G17", "G21", "G90"]) if not incremental else "G17")
        lines.append(" ".join([w for w in words if w] + centre))
        x, y = nx, ny


def compensation(r):
    lines = ["G21 G90 G17", f"T{r.randint(1, 3)} M6", "M3 S1000", "F200", "G0 X0 Y0 Z5"]
    if r.random() < 0.1:
        lines[0] = "G20 G90 G17"
    for _ in range(r.randint(1, 2)):
        side = r.choice(["G41", "G42"])
        if r.random() < 0.2:
            side += ".1"
        words = [side]
        chance = r.random()
        if chance < 0.7 or (side.endswith("1.1") and chance < 0.9):
            words.append("D" + r.choice(["1", "2", "3", "0", "9"] if "." not in side else ["3", "2.5", "6", "0", "-3"]))
        if "." in side and r.random() < 0.3:
            words.append("L" + r.choice(["0", "3", "9"]))
        lines.append(" ".join(words))
        contour(r, lines, r.randint(2, 6))
        if r.random() < 0.8:
            lines.append("G40" if r.random() < 0.8 else f"G40 G{r.randint(0, 1)} X{half(r, -9, 9)} Y{half(r, -9, 9)}")
            for _ in range(r.randint(0, 3)):
                lines.append(r.choice([f"G0 Z{half(r, 3, 9)}", f"G1 X{half(r, -9, 9)}", f"G1 X{half(r, -9, 9)} Y{half(r, -9, 9)}",
                                       "G91", "G90", f"G2 X{half(r, -9, 9)} Y{half(r, 1, 9)} R30"]))
    return lines


def offsets(r):
    lines = header(r)
    for _ in range(r.randint(3, 9)):
        x, y, z = half(r, -9, 9), half(r, -9, 9), half(r, -9, 9)
        p = r.randint(0, 9)
        lines.append(r.choice([
            f"G10 L2 P{p} X{x} Y{y}", f"G10 L2 P{p} Z{z}", f"G10 L20 P{p} X{x}", f"G10 L20 P{p} X{x} Y{y} Z{z}",
            f"G10 L2 P{p} R{r.choice([0, 30, 90, -45])}", f"G52 X{x}", f"G52 X{x} Y{y} Z{z}", f"G92 X{x} Y{y}",
            f"G92 Z{z}", "G92.1", "G92.2", "G92.3", f"G{r.randint(54, 59)}", f"G59.{r.randint(1, 3)}",
            f"G53 G0 X{x} Z{z}", f"G53 G1 Y{y}", f"G1 X{x} Y{y}", f"G0 Z{z}", f"G1 X{x} Y{y} Z{z}", f"X{x}",
            f"G91 G1 X{x}", "G90", "G91", "G20", "G21", "G28", f"G28 Z{z}", f"G30 X{x} Y{y}", "G28.1", "G30.1",
            f"G2 X{x} Y{y} R40", f"#5221={x}", f"#5213={z}", f"#5163={z}", f"#1=#5421 G0 X[#1+1]",
            f"G0 X#5221", f"G0 Y[#5212]", f"G10 L20 P1 X{x} R10", "G0 X[#5420] Z[#5422+1]",
            f"G10 L1 P2 R{half(r, 1, 4)} Z{z}", f"G10 L10 P1 Z{z}", f"G10 L11 P1 Z{z}", f"G43 H{r.randint(0, 4)}", "G43",
            "G49", f"G43.1 Z{z}", f"G43.2 H{r.randint(1, 3)}", f"G0 G43.1 Z{z}", f"G43 H1 G0 Z{z}", "T2 M6", "M6 T3",
            f"G0 X0 Y0 Z{z}"]))
    lines.append(f"G1 X{half(r, -9, 9)} Y1 Z1")
    return lines


def number(r, depth=0):
    """An expression."""
    if depth > 2 or r.random() < 0.3:
        return r.choice([half(r, -5, 5), f"#{r.randint(1, 5)}", f"#<a{r.randint(1, 2)}>", half(r, 0, 9), "0.30000001", "0.3"])
    if r.random() < 0.3:
        function = r.choice(["ABS", "SIN", "COS", "TAN", "SQRT", "FIX", "FUP", "ROUND", "EXP", "LN", "ACOS", "ASIN", "ATAN", "EXISTS"])
        if function == "ATAN":
            return f"ATAN[{number(r, depth + 1)}]/[{number(r, depth + 1)}]"
        if function == "EXISTS":
            return f"EXISTS[#<a{r.randint(1, 3)}>]"
        return f"{function}[{number(r, depth + 1)}]"
    operator = r.choice(["+", "-", "*", "/", "**", " MOD ", " EQ ", " NE ", " GT ", " GE ", " LT ", " LE ", " AND ", " OR ", " XOR "])
    return f"[{number(r, depth + 1)}{operator}{number(r, depth + 1)}]"


def expressions(r):
    lines = ["G21 G90 G17 F100", "G0 X0 Y0 Z5"]
    lines += [f"#{i}={half(r, -4, 4)}" for i in range(1, 6)] + [f"#<a{i}>={half(r, 0, 4)}" for i in (1, 2)]
    label = 100
    for _ in range(r.randint(2, 7)):
        label += 1
        lines += r.choice([
            lambda: [f"G1 X[{number(r)}]"],
            lambda: [f"G1 X{number(r)} Y[{number(r)}]"],
            lambda: [f"#{r.randint(1, 5)}=[{number(r)}]"],
            lambda: [f"#1=[{number(r)}] #2=#1 G1 X#1 Y#2"],
            lambda: [f"o{label} if [{number(r)}]", f"G1 Y{half(r, 0, 9)}", f"o{label} else", "G1 Y-1", f"o{label} endif"],
            lambda: [f"o{label} if [{number(r)}] {r.choice(['AND', 'OR', 'GT'])} [{number(r)}]", "G1 Y3", f"o{label} endif"],
            lambda: [f"o{label} repeat [{r.choice(['2', '2.5', '3.5', '0', '-1', '1.4', '#1'])}]", f"G91 G1 X{half(r, 0, 2)}", "G90", f"o{label} endrepeat"],
            lambda: ["#6=0", f"o{label} while [#6 {r.choice(['LT', 'LE', 'NE', 'GE'])} {r.choice(['3', '0.3', '2.5', '-0.3'])}]", "#6=[#6+0.1]",
                     "G1 X#6", f"o{label} if [#6 GT 4]", f"o{label - 50} return" if False else f"#6=3", f"o{label} endif" , f"o{label} endwhile"] if False else
                    ["#6=1", f"o{label} while [#6 {r.choice(['GT', 'GE', 'NE', 'EQ'])} {r.choice(['0.3', '0', '-0.3', '1'])}]", "#6=[#6-0.1]",
                     "G1 X#6", f"o{label} endwhile"],
            lambda: ["#6=0", f"o{label} do", "#6=[#6+0.1]", "G1 X#6", f"o{label} while [#6 {r.choice(['LT', 'LE'])} {r.choice(['0.3', '0.7', '1'])}]"],
            lambda: [f"o{label} sub", "G1 X#1 Y#2", f"o{label} endsub [#1+1]" if r.random() < 0.5 else f"o{label} endsub",
                     f"o{label} call [{half(r, 0, 4)}] [{number(r)}]", "G1 X[#<_value>] Y#3"],
            lambda: [f"o{label} sub", f"o{label}1 if [#1 GT 0]", f"G1 X#1", f"o{label} call [#1-1]", f"o{label}1 endif", f"o{label} endsub", f"o{label} call [{r.choice([2, 5, 9, 10, 12])}]"],
        ])()
    return lines


def saved_modes(r):
    change = ["G91", "G20", "G18", "G99", "G93", "G55", "F50", "S300", "G90.1", "G98", "G90", "G61", "M4", "M5", "M8", "G43.1 Z3", "G43 H1", "G52 X3", "G7"]
    lines = header(r)
    move = lambda: r.choice([f"G1 X{half(r, -9, 9)} F100", f"G1 Y{half(r, -9, 9)} Z{half(r, -9, 9)} F90", f"G81 X{half(r, -9, 9)} Z-1 R2 F80", f"G1 X{half(r, -9, 9)}"])
    if r.random() < 0.6:
        lines += ["o100 sub"] + ([r.choice(["M73", "M70"])] if r.random() < 0.8 else [])
        for _ in range(r.randint(1, 3)):
            lines.append(r.choice([r.choice(change), move()]))
        if r.random() < 0.3:
            lines.append("M72")
        lines += ["o100 endsub"]
    for _ in range(r.randint(3, 8)):
        lines.append(r.choice(["M70", "M71", "M72", "o100 call" if "o100 sub" in lines else "M70", r.choice(change), r.choice(change), move(), move()]))
    lines += ["G1 X7 F77", "Y3 Z1"]
    return lines


def arcs(r):
    lines = header(r)
    for _ in range(r.randint(1, 3)):
        plane = r.choice(["G17", "G17", "G18", "G19"])
        lines.append(plane)
        a, b = {"G17": "XY", "G18": "ZX", "G19": "YZ"}[plane]
        third = next(c for c in "XYZ" if c not in (a, b))
        i, j = (chr(ord("I") + "XYZ".index(c)) for c in (a, b))
        if r.random() < 0.2:
            lines.append(r.choice(["G90.1", "G91.1", "G91", "G90"]))
        for _ in range(r.randint(1, 4)):
            words = [r.choice(["G2", "G3", "G2", "G3", ""])]
            u, v = r.randint(-9, 9), r.randint(-9, 9)
            if r.random() < 0.5:
                words += [f"{a}{u}", f"{b}{v}", f"R{r.choice([half(r, 3, 30), half(r, -30, -3)])}"]
            else:
                lines.append(f"G0 {a}{u} {b}{v}")
                ci, cj = half(r, -6, 6), half(r, -6, 6)
                words = [r.choice(["G2", "G3"])]
                shape = r.random()
                if shape < 0.4:
                    words += [f"{a}{u + 2 * float(ci):g}", f"{b}{v + 2 * float(cj):g}"]
                elif shape < 0.6:
                    words += [f"{a}{u + float(ci) - float(cj):g}", f"{b}{v + float(cj) + float(ci):g}"]
                elif shape < 0.7:
                    words += [f"{a}{u + 2 * float(ci) + r.choice([0.01, 0.02, 0.03, 0.05]):g}", f"{b}{v + 2 * float(cj):g}"]
                words += [f"{i}{ci}", f"{j}{cj}"]
            if r.random() < 0.3:
                words.append(f"{third}{half(r, -5, 5)}")
            if r.random() < 0.2:
                words.append(f"P{r.choice([1, 2, 3])}")
            if r.random() < 0.1:
                words.append(f"A{half(r, 0, 90)}")
            lines.append(" ".join(w for w in words if w))
    return lines


def curves(r):
    lines = header(r)
    if r.random() < 0.7:
        lines[0] += " G17 G90"
    for _ in range(r.randint(1, 3)):
        x, y = half(r, -9, 9), half(r, -9, 9)
        lines += r.choice([
            lambda: [f"G5 X{x} Y{y} I1 J2 P-2 Q1", f"X{y} P1 Q3" if r.random() < 0.5 else f"G5 X{y} Y{x} P1 Q2"],
            lambda: [f"G5.1 X{x} Y{y} I{half(r, 1, 3)} J1"],
            lambda: [f"G5.2 P1 L3" if r.random() < 0.3 else f"G5.2 X{x} Y1 P1 L3", f"X{x} Y{y} P1", f"X{y} Y{x} P2", "G5.3"],
            lambda: [f"G5.1 X{x}", "G1 X1"], lambda: [f"G5 X{x} I1 J1"], lambda: ["G5.3"]])()
        lines.append(r.choice([f"G1 X{y}", f"Y{x}", "G0 Z3"]))
    return lines


def feeds(r):
    lines = header(r)
    if r.random() < 0.4:
        lines = [line for line in lines if not line.startswith("F")]
    for _ in range(r.randint(3, 8)):
        x, y = half(r, -9, 9), half(r, -9, 9)
        lines.append(r.choice([
            f"G1 X{x}", f"G1 Y{y} F50", "G93", "G94", "G95", "G93 G1 X1 F2", f"G1 X{x} F3", "F0", f"G4 P1", f"G4 P1 G1 X{x}",
            f"G4 X1", f"G4 P1 X{x}", f"X{x} G4 P0.5", "G94 F80", "F60 G20", "G20 F6", "G21", "G96 D2000 S100", "G97 S900", "G33 Z1 K1",
            "G33.1 Z-2 K1", "M5", "M3", "M4", f"G2 X{x} Y{y} R50 F40", "G61", "G64 P0.1", "G61.1", "S-5", "M48", "M50 P0", "M51",
            "M53", "M62 P1", "M64 P1", "M66 P0 L0", "M68 E1 Q2", "M7", "M7 M8", "M60", "T-1", "G0", "G1", f"G0 X{x} A{y}", "G95 F0.5", "M19", "M19 R20",
            "S0", "G84 X1 Z-1 R1", f"N5 G1 Y{y}", f"/G1 Y{y}", f"G1 (x) X{x} (y)", f"g1 x {x}", "M3 M5", "G90 G91", "G1 G0 X1", f"G1 X{x} X{y}", "G80 X1",
            f"X{x}", "G98", "G99", "G7", "G8", f"G1 X+{abs(float(x)):g}", "G1 X1.", "G1 X.5", "M30", "M2", "P1", "H1", "D1", "L2", "Q3", "R2", "I1", "K1", "G43", "E1"]))
    return lines + ["G1 X8 F20", "Y8"]


KINDS = [cycles, cycles, cycles, compensation, compensation, compensation, offsets, offsets, expressions, expressions,
         saved_modes, arcs, arcs, curves, feeds, feeds]


def program(seed):
    """Kind and lines of the program of a seed; it ends with M2."""
    r = random.Random(f"ncsim {seed}")
    kind = KINDS[seed % len(KINDS)]
    lines = kind(r)
    return kind.__name__, lines + ["M2"]
