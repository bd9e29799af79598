# What the figures are drawn with.

function open_svg(w, h) {
  printf "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" viewBox=\"0 0 %d %d\"\n", w, h, w, h
  print "     font-family=\"DejaVu Sans, Helvetica, Arial, sans-serif\" font-size=\"15\" fill=\"none\" stroke-linecap=\"round\">"
  print "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>"
}

function close_svg() { print "</svg>" }

function line(x1, y1, x2, y2, colour, width) {
  printf "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\" stroke-width=\"%s\"/>\n", x1, y1, x2, y2, colour, width
}

function dot(x, y, radius, colour) {
  printf "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%s\" fill=\"%s\"/>\n", x, y, radius, colour
}

function text(x, y, words, colour, anchor) {
  printf "<text x=\"%.1f\" y=\"%.1f\" fill=\"%s\" text-anchor=\"%s\">%s</text>\n", x, y, colour, anchor == "" ? "middle" : anchor, words
}

function arrow(x1, y1, x2, y2, colour,    length_, dx, dy) {
  length_ = sqrt((x2 - x1) ^ 2 + (y2 - y1) ^ 2)
  dx = (x2 - x1) / length_; dy = (y2 - y1) / length_
  line(x1, y1, x2 - 8 * dx, y2 - 8 * dy, colour, 2.5)
  printf "<polygon points=\"%.1f,%.1f %.1f,%.1f %.1f,%.1f\" fill=\"%s\"/>\n", x2, y2, \
    x2 - 12 * dx - 5 * dy, y2 - 12 * dy + 5 * dx, x2 - 12 * dx + 5 * dy, y2 - 12 * dy - 5 * dx, colour
}

function sub_(name, index_) { return name "<tspan dy=\"4\" font-size=\"11\">" index_ "</tspan>" }
