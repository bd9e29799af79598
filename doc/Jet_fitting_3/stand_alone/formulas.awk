# Turns the formulas of the manual, \f$ ... \f$ and \f[ ... \f], from the part of LaTeX that they use into HTML, so that
# plain doxygen renders them without LaTeX and without the network. A command that is not known stops the build.
# usage: awk -f formulas.awk <file>, as a filter of doxygen

BEGIN {
  n = split("alpha beta gamma delta epsilon kappa lambda pi rho sigma theta phi Phi nabla partial ge le ne approx times cdot " \
            "pm infty sum to in mapsto", plain, " ")
  for (i = 1; i <= n; ++i) symbol[plain[i]] = "&" plain[i] ";"
  symbol["partial"] = "&part;"; symbol["approx"] = "&asymp;"; symbol["cdot"] = "&thinsp;&middot;&thinsp;"
  symbol["pm"] = "&plusmn;"; symbol["infty"] = "&infin;"; symbol["to"] = "&rarr;"; symbol["in"] = "&isin;"
  symbol["mapsto"] = "&rarr;"; symbol["dots"] = "&hellip;"; symbol["wedge"] = "&and;"; symbol["quad"] = "&emsp;"
  symbol["qquad"] = "&emsp;&emsp;"; symbol["lbrace"] = "{"; symbol["rbrace"] = "}"; symbol["mid"] = "&nbsp;|&nbsp;"
  for (name in symbol)
    if (name ~ /^(ge|le|ne|approx|times|pm|to|in|mapsto)$/) symbol[name] = "&nbsp;" symbol[name] " "
  split("log exp min max arctan", plain, " ")
  for (i in plain) symbol[plain[i]] = plain[i] "&thinsp;"
}

{ text = text $0 "\n" }

END {
  while (match(text, /\\f[$[]/)) {
    displayed = substr(text, RSTART + 2, 1) == "["
    end = displayed ? "\\f]" : "\\f$"
    printf "%s", substr(text, 1, RSTART - 1)
    text = substr(text, RSTART + 3)
    length_ = index(text, end) - 1
    if (length_ < 0) stop("a formula without end: " substr(text, 1, 60))
    source = substr(text, 1, length_)
    text = substr(text, length_ + 4)
    lines = gsub(/\n/, " ", source)
    at = 1
    html = sequence("")
    printf "%s", displayed ? "<div class=\"formula\">" html "</div>" : "<span class=\"math\">" html "</span>"
    while (lines-- > 0) printf "\n"
  }
  printf "%s", text
}

function stop(message) {
  print FILENAME ": " message > "/dev/stderr"
  exit 1
}

# The formula from `at` to the closing character, or to the end.
function sequence(closing,    result, c) {
  result = ""
  while (at <= length(source)) {
    c = substr(source, at, 1)
    if (c == closing) {
      ++at
      return result
    }
    if (c ~ /[-+]/ && !small && result ~ /[^( ]$/) {
      ++at
      result = result "&nbsp;" (c == "-" ? "&minus;" : "+") " "
    } else {
      result = result (c == "_" ? script("sub") : c == "^" ? script("sup") : atom())
    }
  }
  if (closing != "") stop("a group without end in " source)
  return result
}

function script(tag,    result) {
  ++at
  ++small
  result = "<" tag ">" atom() "</" tag ">"
  --small
  return result
}

# One character, command or group.
function atom(    c, name, first) {
  c = substr(source, at, 1)
  ++at
  if (c == "{") return sequence("}")
  if (c == "\\") {
    if (match(substr(source, at), /^[A-Za-z]+/)) {
      name = substr(source, at, RLENGTH)
      at += RLENGTH
    } else {
      name = substr(source, at, 1)
      ++at
    }
    if (name ~ /^[,; ]$/) return "&thinsp;"
    if (name == "!") return ""
    if (name == "\\") return "<br>"
    if (name == "{" || name == "}" || name == "|") return name
    if (name == "left" || name == "right") return ""
    if (name == "mathrm" || name == "text") return upright()
    if (name == "frac") {
      first = argument()
      return "<span class=\"frac\"><span class=\"num\">" first "</span><span class=\"den\">" argument() "</span></span>"
    }
    if (name == "sqrt") return "&radic;<span class=\"root\">" argument() "</span>"
    if (!(name in symbol)) stop("formulas.awk does not know \\" name " in " source)
    while (substr(source, at, 1) == " ") ++at
    return symbol[name]
  }
  if (c == " ") return ""
  if (c ~ /[A-Za-z]/) return "<i>" c "</i>"
  if (c == "-") return "&minus;"
  if (c == "'") return "&prime;"
  if (c == "<") return "&nbsp;&lt; "
  if (c == ">") return "&nbsp;&gt; "
  if (c == "=") return "&nbsp;= "
  if (c == ",") return ", "
  return c
}

function argument() {
  while (substr(source, at, 1) == " ") ++at
  return atom()
}

function upright(    end, result) {
  end = index(substr(source, at), "}")
  if (substr(source, at, 1) != "{" || end == 0) stop("\\text and \\mathrm need braces in " source)
  result = substr(source, at + 1, end - 2)
  at += end
  gsub(/ /, "\\&nbsp;", result)
  return result
}
