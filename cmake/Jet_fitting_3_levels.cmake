# jet_fitting_3_compile_for_levels(<target> <source>...)
#   adds source files to a target, compiled once for the target's own processor and once more for each of
#   JET_FITTING_3_LEVELS: 3 is x86-64-v3 (AVX2), 4 is x86-64-v4 (AVX-512). The program takes the best at run time, see
#   CGAL/Jet_fitting_3/processor_level.h. Elsewhere than on x86-64 with GNU's or LLVM's compilers and GNU's binutils, one
#   copy is compiled.
#
# Code for a level must not be taken by others. In its object all symbols are made local but the functions of the level
# (named *_level_<n>*), inline functions and instances of templates too, which the linker would else share with files that
# are compiled for all processors. What initializes static objects is moved to a section that the program runs when the
# level is chosen.

include_guard(GLOBAL)
include(CheckCXXCompilerFlag)

set(jet_fitting_3_levels "")
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64" AND CMAKE_SYSTEM_NAME STREQUAL "Linux" AND CMAKE_OBJCOPY AND CMAKE_LINKER)
  check_cxx_compiler_flag(-march=x86-64-v4 JET_FITTING_3_COMPILER_HAS_LEVELS)
  execute_process(COMMAND "${CMAKE_LINKER}" --help OUTPUT_VARIABLE jet_fitting_3_linker_help ERROR_QUIET)
  if(JET_FITTING_3_COMPILER_HAS_LEVELS AND jet_fitting_3_linker_help MATCHES "force-group-allocation")
    set(jet_fitting_3_levels 3 4)
  endif()
endif()
if(JET_FITTING_3_NATIVE OR JET_FITTING_3_SANITIZE) # the first level is that of this machine; sanitizers initialize early
  set(jet_fitting_3_levels "")
endif()
set(JET_FITTING_3_POSSIBLE_LEVELS "${jet_fitting_3_levels}" CACHE INTERNAL "")
set(JET_FITTING_3_LEVELS "${jet_fitting_3_levels}" CACHE STRING
  "Levels of x86-64 beside the first for which programs are compiled: 3, 4, both, or none")

function(jet_fitting_3_compile_for_levels target)
  target_sources(${target} PRIVATE ${ARGN})
  foreach(level IN LISTS JET_FITTING_3_LEVELS)
    set(objects ${target}_level_${level})
    set(together "${CMAKE_CURRENT_BINARY_DIR}/${objects}.o")
    add_library(${objects} OBJECT ${ARGN})
    foreach(property IN ITEMS INCLUDE_DIRECTORIES COMPILE_DEFINITIONS COMPILE_OPTIONS LINK_LIBRARIES)
      set_property(TARGET ${objects} PROPERTY ${property} "$<TARGET_PROPERTY:${target},${property}>")
    endforeach()
    target_compile_definitions(${objects} PRIVATE CGAL_JET_FITTING_3_LEVEL=${level})
    target_compile_options(${objects} PRIVATE -march=x86-64-v${level} -fno-lto $<$<CXX_COMPILER_ID:GNU>:-fno-gnu-unique>)
    set(section cgal_jet_fitting_3_level_${level})
    add_custom_command(OUTPUT "${together}"
      COMMAND "${CMAKE_LINKER}" -r --force-group-allocation -o "${together}" "$<TARGET_OBJECTS:${objects}>"
      COMMAND "${CMAKE_OBJCOPY}" --wildcard "--keep-global-symbol=*_level_${level}*"
        --rename-section .init_array=${section},alloc,load,data,contents "${together}"
      DEPENDS ${objects} "$<TARGET_OBJECTS:${objects}>" COMMAND_EXPAND_LISTS VERBATIM)
    set_source_files_properties("${together}" PROPERTIES EXTERNAL_OBJECT ON GENERATED ON)
    target_sources(${target} PRIVATE "${together}")
    target_compile_definitions(${target} PRIVATE CGAL_JET_FITTING_3_HAS_LEVEL_${level})
  endforeach()
endfunction()
