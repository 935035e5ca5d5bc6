// Volume and box of part.step.
SetFactory("OpenCASCADE");
Merge "part.step";
v() = Volume "*";
b() = BoundingBox Volume{v()};
Printf("box %.9g %.9g %.9g %.9g %.9g %.9g", b(0), b(1), b(2), b(3), b(4), b(5));
m = 0;
For i In {0 : #v() - 1}
  m += Mass Volume{v(i)};
EndFor
Printf("volume %.12g", m);
