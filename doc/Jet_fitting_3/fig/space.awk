# Figures in space; the figure brings its own height(x, y).

# Where the point (x, y, z) of space is drawn: seen from above and the right. The origin lies at (at_x, at_y).
function across(x, y, z) { return at_x + unit * (0.82 * y - 0.62 * x) }
function down(x, y, z) { return at_y + unit * (0.3 * y + 0.36 * x - 0.9 * z) }

# The graph of height(x, y) over the square |x|, |y| <= extent, as a net of lines.
function surface(extent, colour,    i, j, n, s, t, path) {
  n = 10
  for (i = -n; i <= n; i += 2) {
    s = extent * i / n
    path = ""
    for (j = -n; j <= n; ++j) {
      t = extent * j / n
      path = path sprintf(" %.1f,%.1f", across(s, t, height(s, t)), down(s, t, height(s, t)))
    }
    printf "<polyline points=\"%s\" stroke=\"%s\"/>\n", substr(path, 2), colour
    path = ""
    for (j = -n; j <= n; ++j) {
      t = extent * j / n
      path = path sprintf(" %.1f,%.1f", across(t, s, height(t, s)), down(t, s, height(t, s)))
    }
    printf "<polyline points=\"%s\" stroke=\"%s\"/>\n", substr(path, 2), colour
  }
}

# An arrow in space from (x, y, z) along (u, v, w), with a name beside its tip.
function space_arrow(x, y, z, u, v, w, colour, name, shift_x, shift_y) {
  arrow(across(x, y, z), down(x, y, z), across(x + u, y + v, z + w), down(x + u, y + v, z + w), colour)
  text(across(x + u, y + v, z + w) + shift_x, down(x + u, y + v, z + w) + shift_y, name, colour)
}
