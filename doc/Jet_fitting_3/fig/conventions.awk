# Signs and orientation: the four cases that the manual explains.

function sphere(x, y, radius, direction, title, below) {
  printf "<circle cx=\"%d\" cy=\"%d\" r=\"%d\" fill=\"url(#ball)\" stroke=\"#7f8fa9\"/>\n", x, y, radius
  px = x + 0.64 * radius; py = y - 0.77 * radius
  arrow(px, py, px + direction * 0.64 * 70, py - direction * 0.77 * 70, "#b03030")
  text(px + direction * 0.64 * 70 + (direction > 0 ? 14 : -14), py - direction * 0.77 * 70 + (direction > 0 ? 2 : 14), "n", "#b03030")
  dot(px, py, 3.5, "#222222")
  text(x, 28, title, "#222222")
  text(x, 268, below, "#222222")
}

function height(x, y) { return 0.36 * x * x - 0.36 * y * y }

function saddle(x, y, flipped, title, below, below_2) {
  at_x = x; at_y = y; unit = 105
  surface(1, "#9fb0cc")
  if (flipped) {
    space_arrow(0, 0, 0, 0, 0, -0.75, "#b03030", "n", 14, 8)
    space_arrow(0, 0, 0, 0, 0.75, 0, "#2060b0", sub_("d", 1), 12, 16)
    space_arrow(0, 0, 0, 0.75, 0, 0, "#208040", sub_("d", 2), -12, 16)
  } else {
    space_arrow(0, 0, 0, 0, 0, 0.75, "#b03030", "n", 14, 4)
    space_arrow(0, 0, 0, 0.75, 0, 0, "#2060b0", sub_("d", 1), -12, 16)
    space_arrow(0, 0, 0, 0, 0.75, 0, "#208040", sub_("d", 2), 12, 16)
  }
  dot(across(0, 0, 0), down(0, 0, 0), 3.5, "#222222")
  text(x, 316, title, "#222222")
  text(x, 566, below, "#222222")
  text(x, 588, below_2, "#222222")
}

BEGIN {
  open_svg(820, 604)
  print "<defs><radialGradient id=\"ball\" cx=\"0.4\" cy=\"0.35\" r=\"0.75\"><stop offset=\"0\" stop-color=\"#f4f7fc\"/>" \
        "<stop offset=\"1\" stop-color=\"#b9c7de\"/></radialGradient></defs>"
  sphere(205, 155, 85, 1, "normal outwards", sub_("k", 1) "<tspan dy=\"-4\"> = </tspan>" sub_("k", 2) "<tspan dy=\"-4\"> = -1/r</tspan>")
  sphere(615, 155, 85, -1, "normal inwards", sub_("k", 1) "<tspan dy=\"-4\"> = </tspan>" sub_("k", 2) "<tspan dy=\"-4\"> = +1/r</tspan>")
  line(20, 288, 800, 288, "#d0d7e5", 1)
  saddle(205, 450, 0, "a saddle", "bends towards n along " sub_("d", 1) "<tspan dy=\"-4\">: </tspan>" sub_("k", 1) "<tspan dy=\"-4\"> &gt; 0</tspan>", \
         "and away from it along " sub_("d", 2) "<tspan dy=\"-4\">: </tspan>" sub_("k", 2) "<tspan dy=\"-4\"> &lt; 0</tspan>")
  saddle(615, 450, 1, "the same, its normal on the other side", \
         "(" sub_("d", 1) "<tspan dy=\"-4\">, </tspan>" sub_("d", 2) "<tspan dy=\"-4\">, n) becomes (</tspan>" sub_("d", 2) "<tspan dy=\"-4\">, </tspan>" sub_("d", 1) "<tspan dy=\"-4\">, -n)</tspan>", \
         "(" sub_("k", 1) "<tspan dy=\"-4\">, </tspan>" sub_("k", 2) "<tspan dy=\"-4\">) becomes (-</tspan>" sub_("k", 2) "<tspan dy=\"-4\">, -</tspan>" sub_("k", 1) "<tspan dy=\"-4\">)</tspan>")
  close_svg()
}
