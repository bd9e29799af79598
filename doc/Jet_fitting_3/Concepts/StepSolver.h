/*!
\ingroup PkgJetFitting3Concepts
\cgalConcept

Solves the least squares problem inside the steps. `SvdTraits` is the interface for users; this one is for those who
run the steps themselves or replace the fast solver.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Jet_fitting::Orthogonal_solver}
\cgalHasModels{CGAL::Jet_fitting::Abstaining_solver}
\cgalHasModels{CGAL::Jet_fitting::Svd_traits_solver}
\cgalHasModelsEnd
*/
class StepSolver
{
public:
  /// Solves a system of `rows` >= `columns` equations. `assemble(system)` fills a `numeric::Linear_system<FT>` that has
  /// been resized to these numbers; it may be called again.
  ///
  /// \return a `numeric::Least_squares_solution<FT>`: Y, the square sum of the residuals, the numerical rank, the
  ///         triangle R of M = QR, from which the condition number is computed when asked for, and the condition number
  ///         itself if it is known anyway. `trusted` is false (lane by lane, if FT is a pack) where the solver leaves
  ///         the decision to another one
  template <class Assemble>
  numeric::Least_squares_solution<FT> operator()(std::size_t rows, std::size_t columns, const Assemble& assemble);
};
