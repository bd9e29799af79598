# Reads what write_curvatures has written, with meshio (Debian: python3-meshio), and prints the range of the mean curvature.

import sys

import meshio
import numpy

mesh = meshio.read(sys.argv[1] if len(sys.argv) > 1 else "curvatures.ply")
H = mesh.point_data["quality"]
percent = numpy.nanpercentile(H, [2, 50, 98])
print(f"{len(mesh.points)} vertices, H: 2 % below {percent[0]:.3g}, half below {percent[1]:.3g}, 98 % below {percent[2]:.3g}")
