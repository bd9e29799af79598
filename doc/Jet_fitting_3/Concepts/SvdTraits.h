/*!
\ingroup PkgJetFitting3Concepts
\cgalConcept

Linear algebra for the least squares problem of step 2.

A model that you write is always called, once for each fit. For the default models any method with the same answer to
rounding may be used instead: see `CGAL::Monge_via_jet_fitting`. A class that misses a requirement is refused at compile
time with a sentence that lists them.

\cgalHasModelsBegin
\cgalHasModelsBare{`CGAL::Eigen_svd` of the package `Solver_interface`\, the default for `double`}
\cgalHasModels{CGAL::Jet_fitting::Jacobi_svd}
\cgalHasModels{CGAL::Lapack_svd}
\cgalHasModelsEnd
*/
class SvdTraits
{
public:
  /// \name Types
  /// @{

  /// The number type, the same as `LocalKernel::FT`.
  typedef unspecified_type FT;

  /// A vector: constructible from its size, a `std::size_t`; `operator()(i)` reads entry `i`, `set(i, x)` writes it,
  /// counted from 0. (\cgal asks for `size()` and `vector()` as well; they are not used here.)
  typedef unspecified_type Vector;

  /// A matrix: constructible from its numbers of rows and columns; `set(i, j, x)` writes the entry in row `i` and
  /// column `j`, counted from 0. (\cgal asks for `number_of_rows()`, `number_of_columns()` and `operator()(i, j)` as
  /// well; they are not used here.)
  typedef unspecified_type Matrix;

  /// @}

  /// \name Operations
  /// @{

  /// Solves M X = B in the least squares sense, where M has at least as many rows as columns, and writes X into the
  /// first entries of B. If M is rank deficient, X should be the solution with the smallest norm.
  /// \return the ratio of the largest to the smallest singular value of M, infinity if the latter is 0
  static FT solve(const Matrix& M, Vector& B);

  /// @}
};
