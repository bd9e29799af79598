/*!
\ingroup PkgJetFitting3Concepts
\cgalConcept

A number that follows from a Monge form, for `CGAL::Jet_fitting::write_quantity()`.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Jet_fitting::Maximal_curvature}
\cgalHasModels{CGAL::Jet_fitting::Minimal_curvature}
\cgalHasModels{CGAL::Jet_fitting::Mean_curvature}
\cgalHasModels{CGAL::Jet_fitting::Gaussian_curvature}
\cgalHasModels{CGAL::Jet_fitting::Shape_index}
\cgalHasModels{CGAL::Jet_fitting::Curvedness}
\cgalHasModelsEnd
*/
class Quantity
{
public:
  /// The quantity of a `CGAL::Jet_fitting::Monge_form` that is not empty, as anything convertible to the value type of
  /// the map it is written to.
  unspecified_type operator()(const Monge_form& form) const;
};
