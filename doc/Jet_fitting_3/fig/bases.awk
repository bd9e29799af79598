# The three orthonormal bases: of the world, of the fit, of the Monge form.

function height(x, y) { return 0.25 + 0.12 * x - 0.08 * y - 0.24 * x * x - 0.1 * y * y + 0.1 * x * y }

function sample(x, y, error) {
  dot(across(x, y, height(x, y) + error), down(x, y, height(x, y) + error), 3.5, "#222222")
}

BEGIN {
  open_svg(820, 390)
  at_x = 110; at_y = 290; unit = 90
  space_arrow(0, 0, 0, 0.8, 0, 0, "#666666", "x", -10, 14)
  space_arrow(0, 0, 0, 0, 0.8, 0, "#666666", "y", 12, 12)
  space_arrow(0, 0, 0, 0, 0, 0.8, "#666666", "z", 12, 0)
  text(110, 350, "world basis W", "#666666")

  at_x = 500; at_y = 245; unit = 150
  surface(1.15, "#9fb0cc")
  for (i = 0; i < 26; ++i) { # a sunflower of samples, with an error in height
    r = 1.05 * sqrt((i + 0.5) / 26); a = 2.39996 * i
    sample(r * cos(a), r * sin(a), 0.05 * sin(7 * i))
  }
  z0 = 0.12
  line(across(0, 0, z0), down(0, 0, z0), across(0, 0, height(0, 0)), down(0, 0, height(0, 0)), "#b07020", 1.5)
  space_arrow(0, 0, z0, 0.62, 0.1, 0, "#b07020", "", 0, 0)
  space_arrow(0, 0, z0, -0.1, 0.62, 0, "#b07020", "", 0, 0)
  space_arrow(0, 0, z0, 0, 0, 0.95, "#b07020", "z of F", -30, 6)
  dot(across(0, 0, z0), down(0, 0, z0), 4.5, "#b03030")
  text(across(0, 0, z0) - 14, down(0, 0, z0) + 16, "p", "#b03030")

  g = height(0, 0)
  space_arrow(0, 0, g, -0.074, 0.05, 0.62, "#2060b0", "n", 14, 4)
  space_arrow(0, 0, g, 0.5, -0.33, 0.088, "#2060b0", sub_("d", 1), -16, 4)
  space_arrow(0, 0, g, 0.33, 0.5, 0, "#2060b0", sub_("d", 2), 14, 14)
  dot(across(0, 0, g), down(0, 0, g), 4.5, "#2060b0")
  text(660, 84, "Monge basis M, at the origin", "#2060b0")
  text(660, 104, "of the form", "#2060b0")
  text(390, 84, "fitting basis F, at p", "#b07020")
  text(560, 372, "the graph of the fitted jet J, and the samples", "#54617a")
  close_svg()
}
