%prog1
(PathScripts.post.uccnc_post --no-header --tool-length-offset --repeat --no-show-editor)
(Units: 'mm' and 'mm/min')
(preamble: begin)
G17 (Default: XY-plane)
G54 (Default: First coordinate system)
G40 (Default: Cutter radius compensation none)
G49 (Default: Tool Length Offsets: cancel tool length)
G90 (Default: Absolute distance mode selection)
G80 (Cancel canned cycle)
(preamble: done)
(operation initialise: G54)
(operation start: G54)
G54
G0 Z130.000
(operation done: G54)
(operation finalised: G54)
(operation initialise: T21 flat 8 mm)
(operation start: T21 flat 8 mm)
(T21 flat 8 mm)
M6 T21 G43 H21
M3 S9000
(operation done: T21 flat 8 mm)
(operation finalised: T21 flat 8 mm)
(operation initialise: Pocket)
(operation start: Pocket)
(Pocket)
G0 Z40.000
G0 X7.776 Y7.776
G0 Z3.000
G1 X7.776 Y7.776 Z-2.500 F250.000
G3 X-10.886 Y-1.565 Z-2.500 I-7.776 J-7.776 K0.000 F900.000
G3 X1.565 Y-10.886 Z-2.500 I10.886 J1.565 K0.000 F900.000
G3 X10.886 Y1.565 Z-2.500 I-1.565 J10.886 K0.000 F900.000
G3 X7.776 Y7.776 Z-2.500 I-10.886 J-1.565 K0.000 F900.000
G0 Z40.000
G0 X4.380 Y4.380 Z40.000
G0 X4.380 Y4.380 Z3.000
G1 X4.380 Y4.380 Z-2.500 F250.000
G3 X-6.131 Y-0.882 Z-2.500 I-4.380 J-4.380 K0.000 F900.000
G3 X6.131 Y0.882 Z-2.500 I6.131 J0.882 K0.000 F900.000
G3 X4.380 Y4.380 Z-2.500 I-6.131 J-0.882 K0.000 F900.000
G0 Z40.000
G0 X0.984 Y0.984 Z40.000
G0 X0.984 Y0.984 Z3.000
G1 X0.984 Y0.984 Z-2.500 F250.000
G3 X-1.377 Y-0.198 Z-2.500 I-0.984 J-0.984 K0.000 F900.000
G3 X1.377 Y0.198 Z-2.500 I1.377 J0.198 K0.000 F900.000
G3 X0.984 Y0.984 Z-2.500 I-1.377 J-0.198 K0.000 F900.000
G1 X0.984 Y0.984 Z-5.000 F250.000
G3 X-1.377 Y-0.198 Z-5.000 I-0.984 J-0.984 K0.000 F900.000
G3 X1.377 Y0.198 Z-5.000 I1.377 J0.198 K0.000 F900.000
G3 X0.984 Y0.984 Z-5.000 I-1.377 J-0.198 K0.000 F900.000
G0 Z40.000
G0 X4.380 Y4.380 Z40.000
G0 X4.380 Y4.380 Z3.000
G1 X4.380 Y4.380 Z-5.000 F250.000
G3 X-6.131 Y-0.882 Z-5.000 I-4.380 J-4.380 K0.000 F900.000
G3 X6.131 Y0.882 Z-5.000 I6.131 J0.882 K0.000 F900.000
G3 X4.380 Y4.380 Z-5.000 I-6.131 J-0.882 K0.000 F900.000
G0 Z40.000
G0 X7.776 Y7.776 Z40.000
G0 X7.776 Y7.776 Z3.000
G1 X7.776 Y7.776 Z-5.000 F250.000
G3 X-10.886 Y-1.565 Z-5.000 I-7.776 J-7.776 K0.000 F900.000
G3 X1.565 Y-10.886 Z-5.000 I10.886 J1.565 K0.000 F900.000
G3 X10.886 Y1.565 Z-5.000 I-1.565 J10.886 K0.000 F900.000
G3 X7.776 Y7.776 Z-5.000 I-10.886 J-1.565 K0.000 F900.000
G0 Z40.000
G0 Z40.000
(operation done: Pocket)
(operation finalised: Pocket)
(operation initialise: T22 drill 4.5 mm)
(operation start: T22 drill 4.5 mm)
(T22 drill 4.5 mm)
M6 T22 G43 H22
M3 S2500
(operation done: T22 drill 4.5 mm)
(operation finalised: T22 drill 4.5 mm)
(operation initialise: Drill001)
(operation start: Drill001)
(Drill001)
(Begin Drilling)
G0 Z40.000
G90
G98
G0 X-27.000 Y-17.000
G0 Z3.000
G81 X-27.000 Y-17.000 Z-17.000 R2.000 F120.000
G0 X-27.000 Y17.000
G0 Z3.000
G81 X-27.000 Y17.000 Z-17.000 R2.000 F120.000
G0 X27.000 Y17.000
G0 Z3.000
G81 X27.000 Y17.000 Z-17.000 R2.000 F120.000
G0 X27.000 Y-17.000
G0 Z3.000
G81 X27.000 Y-17.000 Z-17.000 R2.000 F120.000
G80
G0 Z3.000
G0 Z40.000
(operation done: Drill001)
(operation finalised: Drill001)
(postamble: begin)
M05 (stop spindle)
G17 (Default: XY-plane)
G54 (Default: First coordinate system)
G40 (Default: Cutter radius compensation none)
G90 (Default: Absolute distance mode selection)
G80 (Cancel canned cycle)
M30 (Stop program and rewind code)
(postamble: done)
