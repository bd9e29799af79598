# Neighborhoods of the vertex in the middle, on a mesh that is denser in one direction.

function px(i, j) { return centre + spacing * (1.28 * i + 0.64 * j) }
function py(j) { return middle - spacing * 0.62 * j }
function distance(i, j) { return sqrt((1.28 * i + 0.64 * j) ^ 2 + (0.62 * j) ^ 2) }
function rings(i, j,    k) {
  k = i < 0 ? -i : i
  if ((j < 0 ? -j : j) > k) k = j < 0 ? -j : j
  return (i + j < 0 ? -i - j : i + j) > k ? (i + j < 0 ? -i - j : i + j) : k
}

function is_drawn(i, j) { return j >= -5 && j <= 5 && px(i, j) > centre - 118 && px(i, j) < centre + 118 }

# Edges lead along i, along j, and along (-1, 1).
function mesh(    i, j) {
  for (j = -5; j <= 5; ++j)
    for (i = -9; i <= 9; ++i) {
      if (!is_drawn(i, j)) continue
      if (is_drawn(i + 1, j)) line(px(i, j), py(j), px(i + 1, j), py(j), "#c9d2e3", 1)
      if (is_drawn(i, j + 1)) line(px(i, j), py(j), px(i, j + 1), py(j + 1), "#c9d2e3", 1)
      if (is_drawn(i - 1, j + 1)) line(px(i, j), py(j), px(i - 1, j + 1), py(j + 1), "#c9d2e3", 1)
    }
}

# kind: rings up to `bound`, or distance up to `bound`; cut: nothing beyond row 1, a sharp edge
function panel(x, title, kind, bound, cut,    i, j, chosen) {
  centre = x; middle = 118
  mesh()
  if (kind == "ball")
    printf "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" stroke=\"#b07020\" stroke-width=\"1.5\" stroke-dasharray=\"5 4\"/>\n", centre, middle, bound * spacing
  if (cut) line(centre - 118, py(1), centre + 118, py(1), "#b03030", 3)
  for (j = -5; j <= 5; ++j)
    for (i = -9; i <= 9; ++i) {
      if (!is_drawn(i, j)) continue
      chosen = (kind == "rings" ? rings(i, j) : distance(i, j)) <= bound && (!cut || j <= 1)
      if (chosen) dot(px(i, j), py(j), 5, "#2060b0")
    }
  dot(centre, middle, 6, "#b03030")
  text(centre, 240, title, "#222222")
}

BEGIN {
  spacing = 25
  open_svg(820, 256)
  panel(145, "k_rings(2)", "rings", 2, 0)
  panel(410, "within_radius(r)", "ball", 2.05, 0)
  panel(675, "within_radius(r), sharp edge", "ball", 2.05, 1)
  close_svg()
}
