# CGAL's example programs and data, unpacked once from the archives that Debian's libcgal-demo installs.
#
# Included: sets CGAL_DATA_DIR (cached), which CGAL::data_file_path() uses, and CGAL_EXAMPLES_DIR (cached), unless they
# are given, and unpacks into <build>/cgal_demo.
# As a script: cmake -DARCHIVES=<folder> -DDESTINATION=<folder> -P unpack_cgal_demo.cmake

function(unpack_cgal_demo archives destination)
  foreach(name IN ITEMS data examples)
    set(archive "${archives}/${name}.tar.gz")
    set(stamp "${destination}/${name}.unpacked")
    if(NOT EXISTS "${archive}")
      message(FATAL_ERROR "There is no ${archive}.")
    endif()
    if("${archive}" IS_NEWER_THAN "${stamp}")
      message(STATUS "Unpacking ${archive} into ${destination}")
      file(ARCHIVE_EXTRACT INPUT "${archive}" DESTINATION "${destination}")
      file(TOUCH "${stamp}")
    endif()
  endforeach()
endfunction()

if(CMAKE_SCRIPT_MODE_FILE)
  unpack_cgal_demo("${ARCHIVES}" "${DESTINATION}")
  return()
endif()

find_path(CGAL_DEMO_ARCHIVES_DIR data.tar.gz
  PATHS /usr/share/doc/libcgal-dev /usr/share/doc/libcgal-demo NO_DEFAULT_PATH
  DOC "Folder of data.tar.gz and examples.tar.gz, as Debian's libcgal-demo installs them")
if(CGAL_DEMO_ARCHIVES_DIR AND NOT (CGAL_DATA_DIR AND CGAL_EXAMPLES_DIR))
  unpack_cgal_demo("${CGAL_DEMO_ARCHIVES_DIR}" "${CMAKE_BINARY_DIR}/cgal_demo")
  if(NOT CGAL_DATA_DIR)
    set(CGAL_DATA_DIR "${CMAKE_BINARY_DIR}/cgal_demo/data" CACHE PATH "Folder of CGAL's data files" FORCE)
  endif()
  if(NOT CGAL_EXAMPLES_DIR)
    set(CGAL_EXAMPLES_DIR "${CMAKE_BINARY_DIR}/cgal_demo/examples" CACHE PATH "Folder of CGAL's own example programs" FORCE)
  endif()
elseif(NOT CGAL_DATA_DIR)
  message(STATUS "NOTICE: CGAL's data files are not found (Debian: libcgal-demo): set CGAL_DATA_DIR.")
endif()
