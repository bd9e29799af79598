// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NEIGHBORHOODS_AUTOMATIC_H
#define CGAL_JET_FITTING_3_NEIGHBORHOODS_AUTOMATIC_H

#include <CGAL/Jet_fitting_3/scale/Automatic.h>

namespace CGAL {
namespace Jet_fitting {

/// \ingroup PkgJetFitting3Neighborhoods
/// Radius and degree chosen from the data, for each point or vertex: nothing is to be guessed.
///
/// For a point set the noise is estimated (or given, by Options::position_noise and normal_noise), and where some parts
/// are several times as dense as others, that of each; for a subsample, jets of degrees 2 and 4, and 3 for the normal,
/// in balls of many radii are compared, which tells their bias; each point takes those with the least bias and
/// variance, the normal and each second derivative in principal axes for itself. From positions alone it takes the
/// radii and degrees of the nearest point of the subsample, unless they are much worse for it. Radii begin where a ball
/// holds about 45 points, with the density of points around. Where many points are copies of others up to rounding,
/// within a five-hundredth of that radius, those are no neighbors. With Options::use_normals the jets are fitted to
/// positions and normals; too few normals around a point that are known (not zero) are too few points.
///
/// On a mesh: jets of degree 2, 4 and 6 in edge-connected neighborhoods are averaged, with the weights of least
/// variance and bias. Their radii are 2 to 24 times the length of the edges around the vertex, which may differ from
/// part to part. The noise is estimated or given likewise; if edges differ by more than four times, it is estimated for
/// each length. Orders 3 and 4 have weights of their own, from degrees 3 and 5, 4 and 6, and up to 24 edges; orders
/// above 4 come from one fit of degree `degree_monge`. With Options::use_normals the normals of the vertices join all
/// fits to order 4, and where they are good, radii for order 2 begin with one ring. The origin is the vertex itself.
/// Where edges are more than three times as long in one direction as across it, the surface turns by less than .2
/// radians along them, and normals are no data, so are neighborhoods. Where the surface turns too soon for all radii,
/// as at tips, or these tell nothing, as on some coarse meshes, one fit of degree 2 to the first rings that have 14
/// vertices is taken, and tells large errors.
///
/// With Options::use_normals, on meshes and point sets, it learns what it does with normals as data and without, and
/// leaves them aside where the middle squared error of second derivatives that it expects is less than a third without
/// them. Normals that were computed from the points or the faces say nothing that positions do not say, and more is
/// expected of them than they are worth: on a mesh they are left aside if they follow from the faces, as those of
/// Polygon_mesh_processing::compute_vertex_normals() do, and those of a point set, unless thirty times as much is
/// expected without them, if their errors are alike at neighbors.
///
/// `degree_fitting`, if it is given, is the highest degree that is tried, 2 at least; without it `degree_monge` may be
/// any. `degree_monge` is at most 4 if it is not given. For a point set degrees go up to 4, and where noise, if it is
/// not given, is far below what degree 4 leaves in the smallest balls, up to 8, with normals to 6. Derivatives of order
/// 3, and without normals of order 4, have radii, degrees and weights of their own, from degrees 3 and 5, 4 and 6;
/// higher ones come from one fit, in a ball that was chosen for a second derivative. Estimation_summary::quality()
/// tells radius and degree, bias and standard deviation of the curvatures, infinite where nothing is known of the bias,
/// as where noise cannot be told from the shape, and errors that contain the bias, of the curvatures and of the third
/// order coefficients b0 and b3; but nothing of one fit, of which there are several. Nor is a status one_sided or
/// pca_ambiguous set. Weights, standard errors and robust losses but Loss::tukey are refused.
///
/// Outliers (Status_flag::outlier) are nobody's neighbors and have no form, unless Options::keep_outliers is set:
/// points of a set to which a fit of degree 2 to the 45 nearest, with the loss of Tukey, leaves no weight, and which
/// are five times as far from it as 70 % of these are from theirs, if one of all is seven times as far; vertices of a
/// mesh that are far from the surface of their neighbors, while 85 % of those around are not a quarter as far. With
/// use_normals, normals of points that are as far from those of such fits are left out (Noise::wrong_normals), and
/// points that lie no farther inside a border than noise moves points are nobody's neighbors either, if their normals
/// are seen to be turned outwards, as where the noise of normals goes with that of positions.
///
/// Neighborhoods end at sharp edges, unless Options::cross_sharp_edges is set. Edges are found from positions: where
/// surfaces of degree 2, of the balls that describe two near points best, have normals that differ by more than the
/// noise and the curvature of these surfaces tell, and by .15 radians, unless a surface of degree 4 describes the
/// points on both sides about as well. Points that are nearer to an edge than the noise may be taken to be on its other
/// side. The sharp edges of a surface need not be edges of its mesh; a vertex on one belongs to the side that describes
/// it best. Edges of a mesh that are constrained (`edge_is_constrained_map`) end neighborhoods besides, and a vertex on
/// one belongs to the side with the widest angle.
inline Automatic automatic() { return Automatic(); }

} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NEIGHBORHOODS_AUTOMATIC_H
