/*!
\ingroup PkgJetFitting3Concepts
\cgalConcept

From which vertices of a mesh, or points of a set, the form at one of them is estimated. For
`CGAL::estimate_vertex_monge_forms()` an item is a `vertex_descriptor` of the mesh, for
`CGAL::estimate_point_monge_forms()` a `std::size_t`, the position in the range.

The models of the package work through an internal interface and respect sharp edges and opposite sheets of the surface;
a function object of yours need not.

\cgalHasModelsBegin
\cgalHasModelsBare{`CGAL::Jet_fitting::k_rings()` and `CGAL::Jet_fitting::enough_rings()`\, of meshes}
\cgalHasModelsBare{`CGAL::Jet_fitting::nearest()` and `CGAL::Jet_fitting::within_radius()`\, of meshes and point sets}
\cgalHasModelsBare{any copyable function object as below\, a lambda for example}
\cgalHasModelsEnd
*/
class Neighborhood
{
public:
  /// Appends the neighborhood of `item` to `items`, which is empty, in any order. Whether `item` itself is among them
  /// makes no difference: it is always taken, as the point of evaluation, and once. Other items that are there twice
  /// count twice. Items with a coordinate that is not finite are left out afterwards.
  ///
  /// Called once for each item. With `CGAL::Parallel_tag` every thread has a copy of the object, so that it may keep
  /// storage between calls; what copies share must be safe to use at the same time. An exception ends the estimation
  /// and reaches its caller. \throw CGAL::Jet_fitting::Invalid_input is what the estimation throws if an item does not
  /// belong to the mesh or range
  void operator()(const Item& item, std::vector<Item>& items);
};
