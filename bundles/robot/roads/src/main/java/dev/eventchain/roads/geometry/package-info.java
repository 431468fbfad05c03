/** Curves in the plane, piecewise cubic polynomials, and the search for places. */
package dev.eventchain.roads.geometry;
