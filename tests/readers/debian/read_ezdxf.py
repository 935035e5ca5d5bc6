# SPDX-License-Identifier: GPL-3.0-or-later
#
# read_ezdxf.py FILE: box, layers and colours of a drawing.
import json
import sys

import ezdxf
import ezdxf.bbox
import ezdxf.colors

drawing = ezdxf.readfile(sys.argv[1])
audit = drawing.audit()
assert not audit.errors and not audit.fixes
lines = drawing.modelspace().query("LINE ARC CIRCLE")
box = ezdxf.bbox.extents(lines)
layers = {item.dxf.layer for item in lines}
with open(sys.argv[1] + ".json", "w", encoding="utf-8") as out:
    json.dump({"version": ezdxf.__version__, "min": list(box.extmin), "size": list(box.size), "names": sorted(layers)}, out)
