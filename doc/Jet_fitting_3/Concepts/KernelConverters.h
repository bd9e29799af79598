/*!
\ingroup PkgJetFitting3Concepts
\cgalConcept

Conversions of numbers between the `DataKernel` and the `LocalKernel`, for the stand-alone class
`CGAL::Jet_fitting::Monge_via_jet_fitting`. `CGAL::Monge_via_jet_fitting` needs none: it has those of \cgal.

The paper (section 4.3.3) converts numbers, points and vectors; numbers are enough, because what is converted are
differences of coordinates: a point would be rounded before it could be subtracted.

\cgalHasModelsBegin
\cgalHasModelsBare{`Cgal_kernel_converters` in `Cgal_local_kernel.h`\, beside the example
\ref Jet_fitting_3/stand_alone_lapack.cpp}
\cgalHasModelsEnd

\sa `DataKernel`
\sa `LocalKernel`
*/
class KernelConverters
{
public:
  /// \name Types
  /// @{

  /// A default constructible function object whose `operator()` maps a `DataKernel::FT` to something convertible to
  /// `LocalKernel::FT`. For numbers whose exact value is computed only on demand it should ask for it: the approximate
  /// one of a lazy number of \cgal is right to five digits only.
  typedef unspecified_type D2L_converter;

  /// The same the other way: a `LocalKernel::FT` to something convertible to `DataKernel::FT`.
  typedef unspecified_type L2D_converter;

  /// @}
};
