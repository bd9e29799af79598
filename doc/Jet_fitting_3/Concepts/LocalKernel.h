/*!
\ingroup PkgJetFitting3Concepts
\cgalConcept

The kernel in which the fit is computed.

\cgalHasModelsBegin
\cgalHasModelsBare{`CGAL::Simple_cartesian<FT>` and `CGAL::Cartesian<FT>` for `float`\, `double`\, `long double` and
multiprecision floating point numbers}
\cgalHasModelsBare{any class with the three types below}
\cgalHasModelsEnd

\sa `DataKernel`
\sa `SvdTraits`
*/
class LocalKernel
{
public:
  /// \name Types
  /// @{

  /// A floating point number type: `float`, `double`, `long double`, or a class with `+ - * /` and unary `-`,
  /// conversions from `int` and `double`, an explicit one to `double`, a default constructor, `<`, `>` and `==`,
  /// `sqrt()`, `abs()` and `exp()` that argument-dependent look-up finds, and a specialization of
  /// `std::numeric_limits`. All is computed in this type, nothing in `double` on the side; but what a user's function
  /// of the distance gives is a `double`. It is the same as `SvdTraits::FT` (section 4.3.5 of the paper).
  typedef unspecified_type FT;

  /// A point; only its name is used.
  typedef unspecified_type Point_3;

  /// A vector, constructible from three `FT`: the axes of the fitting basis are returned as such.
  typedef unspecified_type Vector_3;

  /// @}
};
