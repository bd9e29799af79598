# The page of CGAL::Monge_via_jet_fitting shows what the class inherits, which doxygen does not find through a base class
# of the same name: the public members of the base follow those of the class.
# usage: awk -v base=<header of the base class> -f inherited.awk <header of the class>, as a filter of doxygen

{ print }
/^public:/ {
  while ((getline line < base) > 0) {
    if (line == "  /// The result.") inherited = 1
    if (line == "private:") break
    if (inherited) print line
  }
}
