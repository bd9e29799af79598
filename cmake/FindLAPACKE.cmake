# Finds the C interface of LAPACK: LAPACKE_FOUND and, as CGAL names its optional libraries, the target CGAL::Lapacke_support.

find_path(LAPACKE_INCLUDE_DIR lapacke.h PATH_SUFFIXES lapacke openblas)
find_library(LAPACKE_LIBRARY lapacke)
find_library(LAPACK_LIBRARY lapack)
find_library(BLAS_LIBRARY blas)
mark_as_advanced(LAPACKE_INCLUDE_DIR LAPACKE_LIBRARY LAPACK_LIBRARY BLAS_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(LAPACKE
  REQUIRED_VARS LAPACKE_LIBRARY LAPACK_LIBRARY BLAS_LIBRARY LAPACKE_INCLUDE_DIR)

if(LAPACKE_FOUND AND NOT TARGET CGAL::Lapacke_support)
  add_library(CGAL::Lapacke_support INTERFACE IMPORTED)
  set_target_properties(CGAL::Lapacke_support PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${LAPACKE_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES "${LAPACKE_LIBRARY};${LAPACK_LIBRARY};${BLAS_LIBRARY}")
endif()
