/*!
\ingroup PkgJetFitting3Concepts
\cgalConcept

The kernel of the input points and of the resulting Monge form.

Coordinates are only subtracted, added and compared here: everything else happens in the `LocalKernel`. So the number
type may be exact.

\cgalHasModelsBegin
\cgalHasModelsBare{every Cartesian kernel of \cgal\, with inexact\, exact or lazy numbers}
\cgalHasModelsBare{any class with the three types below: see the example \ref Jet_fitting_3/stand_alone_no_cgal.cpp}
\cgalHasModelsEnd

\sa `LocalKernel`
\sa `KernelConverters`
*/
class DataKernel
{
public:
  /// \name Types
  /// @{

  /// The number type of the coordinates, with `+`, unary `-`, binary `-`, `<` and a constructor from `int`.
  typedef unspecified_type FT;

  /// A point: constructible from three `FT`, with members `x()`, `y()`, `z()`, copyable.
  typedef unspecified_type Point_3;

  /// A vector: constructible from three `FT`, with members `x()`, `y()`, `z()`, copyable.
  /// `Monge_form::comply_wrt_given_normal()` multiplies its coordinates, `Monge_form::dump_4ogl()` multiplies it by an
  /// `FT`; `operator<<` of the form writes it to a stream.
  typedef unspecified_type Vector_3;

  /// @}
};
